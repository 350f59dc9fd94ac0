package simpleray.accel;

import java.util.concurrent.CancellationException;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ForkJoinPool;
import java.util.concurrent.ForkJoinTask;
import java.util.concurrent.RecursiveTask;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;

/**
 * Threads that make a scene ready. <em>Mutable</em>: one thread has it.
 *
 * <p>What is thrown on one of them is kept here, and thrown by what waits. The library would make an object to keep it in; if it is memory
 * that has come to its end it could not, and its task would never end.
 */
final class Pool implements AutoCloseable, Thread.UncaughtExceptionHandler {
    private static final int MOST_THREADS = 64;
    /** So many things are worth a task of their own. */
    private static final int TASK = 1 << 15;
    /** So often, in milliseconds, is looked whether there still are threads. */
    private static final int LOOK = 100;

    private final int most;
    private volatile Throwable fault;                         // the first thing thrown, or of two at once one
    private ForkJoinPool threads;                             // null until they are needed: most scenes are small

    Pool(int threads) {
        most = Math.min(threads, MOST_THREADS);
    }

    private ForkJoinPool threads() {
        if (threads == null) {
            threads = new ForkJoinPool(most, ForkJoinPool.defaultForkJoinWorkerThreadFactory, this, false);
        }
        return threads;
    }

    private void note(Throwable thrown) {
        if (fault == null) {
            fault = thrown;
        }
    }

    @Override
    public void uncaughtException(Thread thread, Throwable thrown) {
        note(thrown);
    }

    /** What is done with the things from one number to before another. */
    interface Work {
        void on(int from, int to);
    }

    /** What is to be made. */
    interface Making<T> {
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
        return await(threads().submit(task));
    }

    /** Begins to make something that is to be {@linkplain #await waited} for. */
    <T> ForkJoinTask<T> begin(Making<T> making) {
        return threads().submit(new Task<T>(this) {
            private static final long serialVersionUID = 1L;

            @Override
            T find() {
                return making.make();
            }
        });
    }

    /** {@return what a task found that was begun} What is thrown on any of the threads is thrown here. */
    <T> T await(ForkJoinTask<T> task) {
        boolean interrupted = false;
        T found = null;
        boolean done = false;
        while (!done && fault == null) {
            try {
                found = task.get(LOOK, TimeUnit.MILLISECONDS);
                done = true;
            } catch (TimeoutException e) {
                continue;
            } catch (InterruptedException e) {                // the scene is made ready all the same
                interrupted = true;
            } catch (ExecutionException e) {
                note(e.getCause());
            } catch (CancellationException e) {
                note(e);
            }
        }
        if (interrupted) {
            Thread.currentThread().interrupt();
        }
        if (fault instanceof CancellationException) {         // it had no memory to look for work, and what waited for it went with it
            throw new OutOfMemoryError("a thread that makes the scene ready has ended");
        }
        if (fault instanceof Error error) {
            throw error;
        }
        if (fault instanceof RuntimeException exception) {
            throw exception;
        }
        return found;
    }

    @Override
    public void close() {
        if (threads != null) {
            try {
                threads.shutdownNow();                        // nobody waits for what is not done
            } catch (OutOfMemoryError e) {                    // they end by themselves when there is nothing to do
                note(e);
            }
        }
    }

    /** Finds something, on one of the threads. */
    abstract static class Task<T> extends RecursiveTask<T> {
        private static final long serialVersionUID = 1L;
        final transient Pool pool;

        Task(Pool pool) {
            this.pool = pool;
        }

        /** {@return what is to be found} */
        abstract T find();

        /** {@return what is found; null once something was thrown} */
        @Override
        protected final T compute() {
            try {
                return pool.fault == null ? find() : null;
            } catch (RuntimeException | Error e) {
                pool.note(e);
                return null;
            }
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
