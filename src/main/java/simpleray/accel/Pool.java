package simpleray.accel;

import java.util.concurrent.Callable;
import java.util.concurrent.ForkJoinPool;
import java.util.concurrent.ForkJoinTask;
import java.util.concurrent.RecursiveAction;

/** Threads that make a scene ready. <em>Mutable</em>: one thread has it. */
final class Pool implements AutoCloseable {
    private static final int MOST_THREADS = 64;
    /** So many things are worth a task of their own. */
    private static final int TASK = 1 << 15;

    private final int most;
    private ForkJoinPool threads;                             // null until they are needed: most scenes are small

    Pool(int threads) {
        most = Math.min(threads, MOST_THREADS);
    }

    private ForkJoinPool threads() {
        if (threads == null) {
            threads = new ForkJoinPool(most);
        }
        return threads;
    }

    /** What is done with the things from one number to before another. */
    interface Work {
        void on(int from, int to);
    }

    /** Does something with the things 0 to count - 1, in parts of one or more. */
    void ranges(int count, Work work) {
        if (count > TASK) {
            run(new Part(0, count, work));
        } else if (count > 0) {
            work.on(0, count);
        }
    }

    /** {@return what a task finds} */
    <T> T run(ForkJoinTask<T> task) {
        return threads().invoke(task);
    }

    /** Begins something that is to be waited for. */
    <T> ForkJoinTask<T> begin(Callable<T> work) {
        return threads().submit(work);
    }

    /** Begins something that is to be waited for. */
    ForkJoinTask<?> begin(Runnable work) {
        return threads().submit(work);
    }

    @Override
    public void close() {
        if (threads != null) {
            threads.shutdown();
        }
    }

    /** Halves a range until it is small. */
    private static final class Part extends RecursiveAction {
        private static final long serialVersionUID = 1L;
        private final int from;
        private final int to;
        private final transient Work work;

        Part(int from, int to, Work work) {
            this.from = from;
            this.to = to;
            this.work = work;
        }

        @Override
        protected void compute() {
            if (to - from <= TASK) {
                work.on(from, to);
            } else {
                int middle = (from + to) >>> 1;
                invokeAll(new Part(from, middle, work), new Part(middle, to, work));
            }
        }
    }
}
