package simpleray.accel;

import java.util.concurrent.CancellationException;
import java.util.concurrent.ForkJoinPool;
import java.util.concurrent.RecursiveTask;

/**
 * Threads that make a scene ready. <em>Mutable</em>: one thread has it.
 *
 * <p>What is thrown on one of them is kept here, and thrown by what waits. The library makes objects to keep it in and to wait with; when
 * memory has come to its end it cannot, and would wait for ever.
 */
public final class Pool implements AutoCloseable, Thread.UncaughtExceptionHandler {
    private static final int MAX_THREADS = 64;
    /** So many things are worth a task of their own. */
    private static final int TASK = 1 << 15;
    /** So many milliseconds are tasks waited for whose outcome nobody wants any more. */
    private static final int PATIENCE = 2000;

    private final int most;
    private Throwable fault;                                  // what was thrown first
    private int running;                                      // tasks
    private boolean closed;
    private ForkJoinPool threads;                             // null until they are needed: most scenes are small

    /**
     * Creates a pool; its threads are made when they are needed.
     *
     * @param threads how many there may be
     */
    public Pool(int threads) {
        most = Math.min(threads, MAX_THREADS);
    }

    private ForkJoinPool threads() {
        if (threads == null) {
            threads = new ForkJoinPool(most, ForkJoinPool.defaultForkJoinWorkerThreadFactory, this, false);
        }
        return threads;
    }

    @Override
    public void uncaughtException(Thread thread, Throwable thrown) {
        note(thrown);
    }

    private synchronized void note(Throwable thrown) {
        if (fault == null) {
            fault = thrown;
        }
        notifyAll();
    }

    /** What is done with the things from one number to before another. */
    interface Work {
        void on(int from, int to);
    }

    /**
     * What is to be made.
     *
     * @param <T> its type
     */
    public interface Making<T> {
        /** {@return the thing} */
        T make();
    }

    /** Does something with the things 0 to count - 1, in parts of one or more. */
    void ranges(int count, Work work) {
        if (count > TASK) {
            run(new Part(this, 0, count, work));
        } else if (count > 0) {
            work.on(0, count);
        }
    }

    /** {@return what a task finds} */
    <T> T run(Task<T> task) {
        threads().execute(task);
        return await(task);
    }

    /**
     * Begins to make something that is to be {@linkplain #await waited} for.
     *
     * @param <T> its type
     * @param making makes it, on one of the threads
     * @return what is waited for
     */
    public <T> Task<T> begin(Making<T> making) {
        Task<T> task = new Task<>(this) {
            private static final long serialVersionUID = 1L;

            @Override
            T find() {
                return making.make();
            }
        };
        threads().execute(task);
        return task;
    }

    /**
     * Waits for a task that was begun. What is thrown on any of the threads is thrown here.
     *
     * @param <T> the type of what it makes
     * @param task the task
     * @return what it made
     */
    public <T> T await(Task<T> task) {
        boolean interrupted = false;
        Throwable thrown;
        synchronized (this) {
            while (!task.ended && fault == null) {
                try {
                    wait();
                } catch (InterruptedException e) {            // the scene is made ready all the same
                    interrupted = true;
                }
            }
            thrown = fault;
        }
        if (interrupted) {
            Thread.currentThread().interrupt();
        }
        if (thrown instanceof CancellationException) {        // a thread died, with tasks that others waited for, which may be noted first
            throw new OutOfMemoryError("a thread that makes the scene ready has ended");
        }
        if (thrown instanceof Error error) {
            throw error;
        }
        if (thrown instanceof RuntimeException exception) {
            throw exception;
        }
        return task.found;
    }

    /** Ends the threads. If that is because of a fault, they may have to give back memory first. */
    @Override
    public void close() {
        if (threads == null) {
            return;
        }
        try {
            threads.shutdownNow();                            // nobody waits for what is not done
        } catch (OutOfMemoryError e) {                        // they end by themselves when there is nothing to do
            note(e);
        }
        boolean interrupted = false;
        long end = System.nanoTime() + PATIENCE * 1_000_000L;
        synchronized (this) {
            closed = true;
            for (long left = PATIENCE; running > 0 && left > 0; left = (end - System.nanoTime()) / 1_000_000) {
                try {
                    wait(left);
                } catch (InterruptedException e) {
                    interrupted = true;
                }
            }
        }
        if (interrupted) {
            Thread.currentThread().interrupt();
        }
    }

    /** {@return whether a task is still wanted} */
    private synchronized boolean begins() {
        boolean wanted = fault == null && !closed;
        running += wanted ? 1 : 0;
        return wanted;
    }

    private synchronized <T> void ends(Task<T> task, T found) {
        task.found = found;
        task.ended = true;
        running--;
        notifyAll();
    }

    /**
     * Finds something, on one of the threads.
     *
     * @param <T> its type
     */
    public abstract static class Task<T> extends RecursiveTask<T> {
        private static final long serialVersionUID = 1L;
        final transient Pool pool;
        private transient T found;
        private transient boolean ended;

        Task(Pool pool) {
            this.pool = pool;
        }

        /** {@return what is to be found} */
        abstract T find();

        /** {@return what is found; null once something was thrown} */
        @Override
        protected final T compute() {
            if (!pool.begins()) {
                return null;
            }
            T result = null;
            try {
                result = find();
            } catch (RuntimeException | Error e) {
                pool.note(e);
            }
            pool.ends(this, result);
            return result;
        }
    }

    /** Halves a range until it is small. */
    private static final class Part extends Task<Void> {
        private static final long serialVersionUID = 1L;
        private final int from;
        private final int to;
        private final transient Work work;

        Part(Pool pool, int from, int to, Work work) {
            super(pool);
            this.from = from;
            this.to = to;
            this.work = work;
        }

        @Override
        Void find() {
            if (to - from <= TASK) {
                work.on(from, to);
            } else {
                int middle = (from + to) >>> 1;
                invokeAll(new Part(pool, from, middle, work), new Part(pool, middle, to, work));
            }
            return null;
        }
    }
}
