package simpleray.render;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.ThreadFactory;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;

/**
 * Threads that render one picture after another. If the next one is begun in time, each goes over to it as soon as no row is left of the one
 * before. <em>Mutable</em>; belongs to the thread that created it.
 */
public final class RenderThreads implements AutoCloseable {
    /** The size of a thread's stack, in bytes: enough for {@link RenderSettings#MAX_DEPTH} reflections within reflections. */
    private static final long STACK = 8L << 20;

    private final int count;
    private final List<Thread> started = new CopyOnWriteArrayList<>();   // a dying one starts another
    private final ExecutorService pool;

    /**
     * Starts no thread yet.
     *
     * @param count the number of threads, above 0
     */
    public RenderThreads(int count) {
        this(count, new ThreadFactory() {
            private int number;

            @Override
            public Thread newThread(Runnable work) {
                Thread thread = new Thread(null, work, "simpleray-worker-" + ++number, STACK);
                thread.setDaemon(true);
                return thread;
            }
        });
    }

    /** Starts threads of other kinds. */
    RenderThreads(int count, ThreadFactory maker) {
        this.count = count;
        pool = Executors.newFixedThreadPool(count, new ThreadFactory() {
            @Override
            public Thread newThread(Runnable work) {
                Thread thread = maker.newThread(work);
                started.add(thread);
                return thread;
            }
        });
    }

    /**
     * Has a task done by each thread, once it has done those before.
     *
     * @return the tasks; fewer if the system grants no more threads, but one at least
     */
    List<Future<?>> begin(Runnable task) {
        List<Future<?>> tasks = new ArrayList<>(count);
        try {
            for (int i = 0; i < count; i++) {
                tasks.add(pool.submit(task));
            }
        } catch (OutOfMemoryError e) {
            if (tasks.isEmpty()) {
                throw e;
            }
        }
        return tasks;
    }

    /**
     * Waits for the end of a task.
     *
     * @throws InterruptedException if this thread is interrupted meanwhile
     * @throws OutOfMemoryError if it will never end: a thread that has no memory to wait for a task dies
     */
    void await(Future<?> task) throws InterruptedException {
        while (!task.isDone()) {
            try {
                task.get(1, TimeUnit.SECONDS);
            } catch (ExecutionException e) {
                throw new IllegalStateException(e);           // renderers keep what went wrong
            } catch (TimeoutException e) {
                if (!areAlive() && !task.isDone()) {
                    throw new OutOfMemoryError("no thread is left to render");
                }
            }
        }
    }

    private boolean areAlive() {
        for (Thread thread : started) {
            if (thread.isAlive()) {
                return true;
            }
        }
        return false;
    }

    /** Waits until all threads have ended. */
    @Override
    public void close() {
        pool.shutdown();
        boolean interrupted = false;
        for (Thread thread : started) {
            while (thread.isAlive()) {
                try {
                    thread.join();
                } catch (InterruptedException e) {
                    interrupted = true;
                }
            }
        }
        if (interrupted) {
            Thread.currentThread().interrupt();
        }
    }
}
