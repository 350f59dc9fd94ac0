package simpleray.ui;

import java.util.function.Consumer;
import java.util.function.Supplier;

/**
 * A part of the window that is made when it is first needed, so that the window opens sooner. For the event thread.
 *
 * @param <T> the part
 */
final class Lazy<T> {
    private final Supplier<T> maker;
    private T made;                                           // null until it is needed

    Lazy(Supplier<T> maker) {
        this.maker = maker;
    }

    T get() {
        if (made == null) {
            made = maker.get();
        }
        return made;
    }

    /** Passes the part to a task, if it was made. */
    void ifMade(Consumer<T> task) {
        if (made != null) {
            task.accept(made);
        }
    }
}
