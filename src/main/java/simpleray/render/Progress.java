package simpleray.render;

import java.util.Locale;

/**
 * How far a rendering has come and how long it will still take, taking all rows for equal. <em>Mutable</em>; any thread may call.
 */
public final class Progress {
    private static final double SECOND = 1e9;
    private static final int MINUTE = 60;

    private final int rows;
    private final long start;
    private final int known;
    private int finished;
    private double worked;                                    // rows' worth of work, as far as it was told
    private long held;                                        // nanoseconds
    private long heldSince;
    private boolean paused;

    /**
     * Begins to count.
     *
     * @param rows how many rows there are
     * @param start the time at which rendering began, in nanoseconds of {@link System#nanoTime}
     */
    public Progress(int rows, long start) {
        this(rows, start, 0);
    }

    /**
     * Begins to count.
     *
     * @param rows how many rows there are
     * @param start the time at which rendering began, in nanoseconds of {@link System#nanoTime}
     * @param known how many of them take no time, because they are known from before
     */
    public Progress(int rows, long start, int known) {
        this.rows = rows;
        this.start = start;
        this.known = known;
    }

    /** Counts a finished row. */
    public synchronized void rowFinished() {
        finished++;
    }

    /**
     * Counts work of which whole rows come later.
     *
     * @param share how many rows it is worth
     */
    public synchronized void worked(double share) {
        worked += share;
    }

    /**
     * Stops the clock, or lets it go on.
     *
     * @param hold whether to stop it
     * @param now the time, in nanoseconds of {@link System#nanoTime}
     */
    public synchronized void pause(boolean hold, long now) {
        if (hold && !paused) {
            heldSince = now;
        } else if (paused && !hold) {
            held += now - heldSince;
        }
        paused = hold;
    }

    /** {@return how many rows there are} */
    public int rows() {
        return rows;
    }

    /** {@return how many rows are finished} */
    public synchronized int finished() {
        return finished;
    }

    /** {@return how much is finished, from 0 to 100, rounded down} */
    public synchronized int percent() {
        return (int) (100L * finished / rows);
    }

    /**
     * Tells the time since the start, without pauses.
     *
     * @param now the time, in nanoseconds of {@link System#nanoTime}
     * @return seconds
     */
    public synchronized double elapsed(long now) {
        return seconds(start + held, paused ? heldSince : now);
    }

    /**
     * Tells the time between two moments.
     *
     * @param from the earlier, in nanoseconds of {@link System#nanoTime}
     * @param to the later
     * @return seconds
     */
    public static double seconds(long from, long to) {
        return (to - from) / SECOND;
    }

    /**
     * Estimates the time until the end.
     *
     * @param now the time, in nanoseconds of {@link System#nanoTime}
     * @return seconds; NaN while nothing is finished but known rows
     */
    public synchronized double left(long now) {
        double done = Math.max(finished, worked) - known;
        return done <= 0 ? Double.NaN : elapsed(now) * (rows - known - done) / done;
    }

    /**
     * Writes a time as people read it.
     *
     * @param seconds the time; NaN if it is not known
     * @return such as {@code 0.3 s}, {@code 12 s}, {@code 3:05 min}, {@code 1:02:03 h} or {@code ?}
     */
    public static String time(double seconds) {
        if (Double.isNaN(seconds)) {
            return "?";
        }
        if (seconds < 9.95) {
            return String.format(Locale.ROOT, "%.1f s", seconds);
        }
        long whole = Math.round(seconds);
        if (whole < MINUTE) {
            return whole + " s";
        }
        long minutes = whole / MINUTE;
        return minutes < MINUTE ? String.format(Locale.ROOT, "%d:%02d min", minutes, whole % MINUTE)
            : String.format(Locale.ROOT, "%d:%02d:%02d h", minutes / MINUTE, minutes % MINUTE, whole % MINUTE);
    }
}
