package simpleray.render;

import java.util.Locale;

/** How the nearest object along a ray is found. The picture is the same. */
public enum Accel {
    /** By a tree of boxes and lists of what lies in each direction. */
    AUTO,
    /** By asking all objects in turn, as the thesis does. */
    NONE;

    /** {@return the name as the command line has it, in lower case} */
    @Override
    public String toString() {
        return name().toLowerCase(Locale.ROOT);
    }
}
