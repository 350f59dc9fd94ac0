package simpleray.render;

/** Something that holds threads for a while. It takes no memory to wait for it, or to end it: there may be none left. */
abstract class Hold {
    /** {@return whether threads are held} Asked with the lock of this object; with it all is changed, and notified, that the answer depends on. */
    abstract boolean holds();

    /** Waits while threads are held; an interrupt is kept for later. */
    final synchronized void untilFree() {
        boolean interrupted = false;
        while (holds()) {
            try {
                wait();
            } catch (InterruptedException e) {
                interrupted = true;
            }
        }
        if (interrupted) {
            Thread.currentThread().interrupt();
        }
    }
}
