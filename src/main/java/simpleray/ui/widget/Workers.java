package simpleray.ui.widget;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.ThreadPoolExecutor;
import java.util.concurrent.TimeUnit;

/** The threads of a window for tasks that take long. Each does its tasks one after another, and starts with the first one. */
public final class Workers {
    /** Room for as many reflections within reflections as rendering has. */
    private static final long STACK = 8L << 20;

    private final List<ExecutorService> finishing = new ArrayList<>();
    private final List<ExecutorService> stopping = new ArrayList<>();

    /** Creates no thread yet. */
    public Workers() {
    }

    /**
     * Creates a thread that still does the tasks that it has when the window is closed, and takes none after that.
     *
     * @param name its name
     * @return the thread
     */
    public ExecutorService finishing(String name) {
        return add(finishing, name, false);
    }

    /**
     * Creates a thread that is interrupted when the window is closed, drops its other tasks, and takes none after that.
     *
     * @param name its name
     * @return the thread
     */
    public ExecutorService stopping(String name) {
        return add(stopping, name, true);
    }

    private static ExecutorService add(List<ExecutorService> all, String name, boolean daemon) {
        ExecutorService made = new ThreadPoolExecutor(1, 1, 0, TimeUnit.SECONDS, new LinkedBlockingQueue<>(), task -> {
            Thread thread = new Thread(null, task, name, STACK);
            thread.setDaemon(daemon);
            return thread;
        }, new ThreadPoolExecutor.DiscardPolicy());
        all.add(made);
        return made;
    }

    /** Closes them all; does not wait for it. */
    public void close() {
        finishing.forEach(ExecutorService::shutdown);
        stopping.forEach(ExecutorService::shutdownNow);
    }

    /**
     * Waits until all threads have ended; not for the event thread.
     *
     * @throws InterruptedException if the thread is interrupted
     */
    public void await() throws InterruptedException {
        for (List<ExecutorService> all : List.of(finishing, stopping)) {
            for (ExecutorService one : all) {
                one.awaitTermination(Long.MAX_VALUE, TimeUnit.NANOSECONDS);
            }
        }
    }
}
