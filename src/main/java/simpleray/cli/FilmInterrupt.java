package simpleray.cli;

import java.io.Closeable;
import java.util.concurrent.CancellationException;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.function.Supplier;
import simpleray.render.Renderer;

/** Ends the rendering of a film when the program is told to stop, and then says how to go on. Any thread may call. */
final class FilmInterrupt implements Closeable {
    /** How long the end of the program waits for the rendering to end, in milliseconds. */
    private static final long PATIENCE = 1_200;

    private final RenderCheckpointer.Notes notes;
    private final Supplier<String> kept;
    private final CountDownLatch closed = new CountDownLatch(1);
    private final Thread hook = new Thread("simpleray-interrupted") {
        @Override
        public void run() {
            FilmInterrupt.this.interrupted();
        }
    };
    private Renderer current;
    private boolean stopped;
    private boolean finished;

    /**
     * Begins to listen.
     *
     * @param notes where messages go
     * @param kept says what is kept, and how to go on
     */
    FilmInterrupt(RenderCheckpointer.Notes notes, Supplier<String> kept) {
        this.notes = notes;
        this.kept = kept;
        try {
            Runtime.getRuntime().addShutdownHook(hook);
        } catch (IllegalStateException e) {
            stopped = true;                                   // the program is being stopped already
        }
    }

    /**
     * Notes which frame is being rendered.
     *
     * @throws CancellationException if the program has been told to stop
     */
    synchronized void renders(Renderer frame) {
        if (stopped) {
            throw new CancellationException("told to stop");
        }
        current = frame;
    }

    /** {@return whether the program has been told to stop} Faults from then on come from that. */
    synchronized boolean isStopped() {
        return stopped;
    }

    /** Notes that the film is whole. */
    synchronized void finished() {
        finished = true;
    }

    /** Ends the rendering because the program is told to stop. */
    void interrupted() {
        synchronized (this) {
            stopped = true;
            if (current != null) {
                current.cancel();
            }
        }
        try {
            closed.await(PATIENCE, TimeUnit.MILLISECONDS);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
        synchronized (this) {
            if (!finished) {
                notes.err().println("simpleray: interrupted" + kept.get());
            }
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
