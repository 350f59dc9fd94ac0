package simpleray.render;

/** A gate for threads at work, which may be shut for a while. <em>Mutable</em>; any thread may call. */
final class Pause extends Hold {
    private volatile boolean on;

    /** {@return whether it is shut} */
    boolean isOn() {
        return on;
    }

    synchronized void set(boolean shut) {
        on = shut;
        notifyAll();
    }

    @Override
    boolean holds() {
        return on;
    }

    /** Waits while it is shut; an interrupt is kept for later. */
    void await() {
        if (on) {
            untilFree();
        }
    }
}
