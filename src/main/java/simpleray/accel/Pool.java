package simpleray.accel;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.Semaphore;
import java.util.concurrent.ThreadFactory;
import java.util.concurrent.ThreadPoolExecutor;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.function.Supplier;

/**
 * The threads that compile a scene: the one that creates the pool, and others that help it. <em>Mutable</em>: that thread and its tasks may begin
 * and await tasks.
 *
 * <p>A thread that awaits a task runs it, unless another thread already does, and the end of a task allocates nothing. So no thread waits for ever
 * if memory runs out and others die of it; docs/decisions/0016-threads-that-end-without-memory.md says why this is no ForkJoinPool.
 */
public final class Pool implements AutoCloseable {
    private static final int MAX_THREADS = 64;
    /** The number of items that are worth a task of their own. */
    private static final int TASK = 1 << 15;
    /** How long to wait for tasks whose results nobody wants any more, in seconds. */
    private static final int PATIENCE = 2;

    private final int helpers;
    private ThreadPoolExecutor threads;                       // null until the first task: most scenes are small

    /**
     * Creates a pool; its threads start when they are needed.
     *
     * @param threads the most threads at work at a time, the caller's included
     */
    public Pool(int threads) {
        helpers = Math.min(threads, MAX_THREADS) - 1;
    }

    /** Processes the items from one number to before another. */
    interface Work {
        void on(int from, int to);
    }

    /** Processes the items 0 to count - 1, in parts that several threads share. */
    void ranges(int count, Work work) {
        List<Task<Work>> tasks = new ArrayList<>();
        for (int from = TASK; from < count; from += TASK) {
            int first = from;
            tasks.add(begin(new Supplier<>() {
                @Override
                public Work get() {
                    work.on(first, Math.min(first + TASK, count));
                    return work;
                }
            }));
        }
        if (count > 0) {
            work.on(0, Math.min(TASK, count));
        }
        for (Task<Work> task : tasks) {
            await(task);
        }
    }

    /**
     * Begins a task that is to be {@linkplain #await awaited}.
     *
     * @param <T> the type of its result
     * @param making computes the result, on any of the threads
     * @return the task
     */
    public <T> Task<T> begin(Supplier<T> making) {
        Task<T> task = new Task<>(making);
        if (helpers > 0) {
            try {
                threads().execute(task);
            } catch (OutOfMemoryError e) {                    // the system grants no more threads: the one that awaits the task runs it
                return task;
            }
        }
        return task;
    }

    private ThreadPoolExecutor threads() {
        if (threads == null) {                                // no task has begun, so there is only this thread
            threads = new ThreadPoolExecutor(helpers, helpers, PATIENCE, TimeUnit.SECONDS, new LinkedBlockingQueue<>(), new Helpers(),
                new ThreadPoolExecutor.DiscardPolicy());
            threads.allowCoreThreadTimeOut(true);
        }
        return threads;
    }

    /**
     * Returns the result of a task, which it runs or waits for. An interrupt is kept for later.
     *
     * @param <T> the type of the result
     * @param task the task
     * @return the result; if the task has thrown an exception, it is thrown here
     */
    public <T> T await(Task<T> task) {
        for (Runnable next = task; next != null && !task.hasEnded(); next = threads == null ? null : threads.getQueue().poll()) {
            next.run();
        }
        return task.result();
    }

    /** Ends the threads, and waits for those that are at work: if a task has failed, the memory of others is free afterwards. */
    @Override
    public void close() {
        if (threads == null) {
            return;
        }
        threads.shutdownNow();
        boolean interrupted = Thread.interrupted();
        try {
            threads.awaitTermination(PATIENCE, TimeUnit.SECONDS);
        } catch (InterruptedException e) {
            interrupted = true;
        }
        if (interrupted) {
            Thread.currentThread().interrupt();
        }
    }

    /**
     * A result to come.
     *
     * @param <T> its type
     */
    public static final class Task<T> implements Runnable {
        private final Supplier<T> making;
        private final AtomicBoolean taken = new AtomicBoolean();
        private final Semaphore ended = new Semaphore(0);
        private T result;
        private Throwable fault;

        private Task(Supplier<T> making) {
            this.making = making;
        }

        /** Computes the result, unless another thread has begun to. */
        @Override
        public void run() {
            if (taken.compareAndSet(false, true)) {
                try {
                    result = making.get();
                } catch (RuntimeException | Error e) {
                    fault = e;
                }
                ended.release();
            }
        }

        private boolean hasEnded() {
            return ended.availablePermits() > 0;
        }

        private T result() {
            ended.acquireUninterruptibly();
            ended.release();
            if (fault instanceof Error error) {
                throw error;
            }
            if (fault instanceof RuntimeException exception) {
                throw exception;
            }
            return result;
        }
    }

    /** Creates threads that print nothing if they die. */
    private static final class Helpers implements ThreadFactory, Thread.UncaughtExceptionHandler {
        @Override
        public Thread newThread(Runnable work) {
            Thread thread = new Thread(work, "simpleray-compiling");
            thread.setDaemon(true);
            thread.setUncaughtExceptionHandler(this);
            return thread;
        }

        @Override
        public void uncaughtException(Thread thread, Throwable thrown) {
            // there was no memory to look for the next task; the threads that await the tasks run them
        }
    }
}
