package simpleray.ui.widget;

import java.util.function.Consumer;
import java.util.function.Supplier;

/**
 * A part of the window that is made when it is first needed, so that the window opens sooner. For the event thread.
 *
 * @param <T> the part
 */
public final class Lazy<T> {
    private final Supplier<T> maker;
    private T made;                                           // null until it is needed

    /**
     * Makes nothing yet.
     *
     * @param maker makes the part
     */
    public Lazy(Supplier<T> maker) {
        this.maker = maker;
    }

    /** {@return the part} Makes it at the first call. */
    public T get() {
        if (made == null) {
            made = maker.get();
        }
        return made;
    }

    /** {@return whether it was made} */
    public boolean isMade() {
        return made != null;
    }

    /**
     * Does something with the part if it was made.
     *
     * @param task what to do
     */
    public void ifMade(Consumer<T> task) {
        if (made != null) {
            task.accept(made);
        }
    }
}
