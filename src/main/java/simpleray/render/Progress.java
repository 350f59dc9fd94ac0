package simpleray.render;

import java.util.Locale;

/**
 * Counts finished rows and estimates the time left, as if all rows took the same time. <em>Mutable</em>; any thread may call.
 */
public final class Progress {
    private static final double SECOND = 1e9;
    private static final int MINUTE = 60;

    private final long rows;
    private final long start;
    private final long known;
    private long finished;
    private double worked;                                    // finished work, in rows
    private long held;                                        // nanoseconds
    private long heldSince;
    private boolean paused;

    /**
     * Starts counting.
     *
     * @param rows the number of rows
     * @param start the time at which rendering began, in nanoseconds of {@link System#nanoTime}
     */
    public Progress(long rows, long start) {
        this(rows, start, 0);
    }

    /**
     * Starts counting.
     *
     * @param rows the number of rows
     * @param start the time at which rendering began, in nanoseconds of {@link System#nanoTime}
     * @param known the number of rows that take no time, because they are known from before
     */
    public Progress(long rows, long start, long known) {
        this.rows = rows;
        this.start = start;
        this.known = known;
    }

    /** Counts a finished row. */
    public synchronized void rowFinished() {
        finished++;
    }

    /**
     * Counts finished rows.
     *
     * @param n how many
     */
    public synchronized void rowsFinished(long n) {
        finished += n;
    }

    /**
     * Counts finished work on a row that is not finished yet.
     *
     * @param share the work, in rows
     */
    public synchronized void worked(double share) {
        worked += share;
    }

    /**
     * Stops the clock, or restarts it.
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

    /** {@return the number of rows} */
    public long rows() {
        return rows;
    }

    /** {@return the number of finished rows} */
    public synchronized long finished() {
        return finished;
    }

    /** {@return the percentage of finished rows, rounded down} */
    public synchronized int percent() {
        return (int) (100L * finished / rows);
    }

    /**
     * Returns the time since the start, without pauses.
     *
     * @param now the time, in nanoseconds of {@link System#nanoTime}
     * @return seconds
     */
    public synchronized double elapsed(long now) {
        return seconds(start + held, paused ? heldSince : now);
    }

    /**
     * Returns the time between two moments.
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
     * @return seconds; NaN as long as only known rows are finished
     */
    public synchronized double left(long now) {
        double done = Math.max((double) finished, worked) - known;
        return done <= 0 ? Double.NaN : elapsed(now) * (rows - known - done) / done;
    }

    /**
     * Formats a time for people.
     *
     * @param seconds the time; NaN if it is unknown
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
