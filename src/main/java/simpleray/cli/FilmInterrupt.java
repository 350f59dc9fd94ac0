package simpleray.cli;

import java.io.Closeable;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.function.Supplier;
import simpleray.film.FilmRenderer;

/** Ends the rendering of a film when the program is told to stop, and then says how to go on. Any thread may call. */
final class FilmInterrupt implements Closeable {
    /** How long the end of the program waits for the rendering to end, in milliseconds. */
    private static final long PATIENCE = 1_200;

    private final FilmRenderer film;
    private final RenderCheckpointer.Notes notes;
    private final Supplier<String> kept;
    private final CountDownLatch closed = new CountDownLatch(1);
    private final Thread hook = new Thread("simpleray-interrupted") {
        @Override
        public void run() {
            FilmInterrupt.this.interrupted();
        }
    };

    /**
     * Begins to listen.
     *
     * @param film the film
     * @param notes where messages go
     * @param kept says what is kept, and how to go on
     */
    FilmInterrupt(FilmRenderer film, RenderCheckpointer.Notes notes, Supplier<String> kept) {
        this.film = film;
        this.notes = notes;
        this.kept = kept;
        try {
            Runtime.getRuntime().addShutdownHook(hook);
        } catch (IllegalStateException e) {
            film.cancel();                                    // the program is being stopped already
        }
    }

    /** Ends the rendering because the program is told to stop. */
    void interrupted() {
        film.cancel();
        try {
            closed.await(PATIENCE, TimeUnit.MILLISECONDS);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
        if (!film.isDone()) {
            notes.err().println("simpleray: interrupted" + kept.get());
        }
    }

    @Override
    public void close() {
        try {
            Runtime.getRuntime().removeShutdownHook(hook);
        } catch (IllegalStateException e) {
            // the program is told to stop, and the hook runs
        }
        closed.countDown();
    }
}
