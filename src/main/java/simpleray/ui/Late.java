package simpleray.ui;

import java.util.function.Consumer;
import java.util.function.Supplier;

/**
 * A part of the window that is made when it is first needed: the window opens the sooner. For the event thread.
 *
 * @param <T> the part
 */
final class Late<T> {
    private final Supplier<T> maker;
    private T made;                                           // null until it is needed

    Late(Supplier<T> maker) {
        this.maker = maker;
    }

    T get() {
        if (made == null) {
            made = maker.get();
        }
        return made;
    }

    /** Does something with it if it was made. */
    void ifMade(Consumer<T> task) {
        if (made != null) {
            task.accept(made);
        }
    }
}
