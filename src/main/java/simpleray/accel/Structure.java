package simpleray.accel;

/** A way to the bounded objects that a ray may hit. <em>Constant.</em> */
interface Structure {
    /** {@return what walks through it for a thread} */
    Walk walk(Finder finder);
}
