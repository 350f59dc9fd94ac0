package simpleray.ui;

import java.awt.AWTEvent;
import java.awt.EventQueue;
import java.awt.Toolkit;
import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;

/**
 * Measures how long the event thread is held by each event. The time it worked says what the program did; the time that went by also holds
 * what other threads and programs took from it.
 */
public final class StallMeter implements AutoCloseable {
    private final ThreadMXBean threads = ManagementFactory.getThreadMXBean();
    private final Meter meter = new Meter();
    private long longest;                                     // nanoseconds; the event thread's own, as all of these
    private long longestWork;
    private int events;
    private int stalls;
    private AWTEvent worst;

    /** How long an event may hold the event thread, in nanoseconds. */
    public static final long MAX = 16_000_000;

    private final class Meter extends EventQueue {
        @Override
        protected void dispatchEvent(AWTEvent event) {
            long begin = System.nanoTime();
            long work = threads.getCurrentThreadCpuTime();
            super.dispatchEvent(event);
            work = threads.getCurrentThreadCpuTime() - work;
            events++;
            stalls += work > MAX ? 1 : 0;
            if (work > longestWork) {
                longestWork = work;
                worst = event;
            }
            longest = Math.max(longest, System.nanoTime() - begin);
        }

        @Override
        public void pop() {
            super.pop();
        }
    }

    /** Begins to measure. */
    public StallMeter() {
        OpenWindow.run(() -> Toolkit.getDefaultToolkit().getSystemEventQueue().push(meter));
    }

    /** Forgets what was measured so far. */
    public void reset() {
        OpenWindow.run(() -> {
            longest = 0;
            longestWork = 0;
            events = 0;
            stalls = 0;
        });
    }

    /** {@return for how many events the event thread worked longer than it may} */
    public int stalls() {
        return OpenWindow.ask(() -> stalls);
    }

    public int events() {
        return OpenWindow.ask(() -> events);
    }

    /** {@return the most milliseconds that the event thread worked for an event} */
    public double mostWork() {
        return OpenWindow.ask(() -> longestWork / 1e6);
    }

    @Override
    public String toString() {
        return OpenWindow.ask(() -> events + " events, " + stalls + " of more than 16 ms; the longest took " + longest / 1e6 + " ms, of "
            + "which " + longestWork / 1e6 + " ms of work at most, in " + worst);
    }

    @Override
    public void close() {
        OpenWindow.run(meter::pop);
    }
}
