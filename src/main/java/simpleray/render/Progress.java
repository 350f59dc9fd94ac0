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
    private int finished;

    /**
     * Begins to count.
     *
     * @param rows how many rows there are
     * @param start the time at which rendering began, in nanoseconds of {@link System#nanoTime}
     */
    public Progress(int rows, long start) {
        this.rows = rows;
        this.start = start;
    }

    /** Counts a finished row. */
    public synchronized void rowFinished() {
        finished++;
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
     * Tells the time since the start.
     *
     * @param now the time, in nanoseconds of {@link System#nanoTime}
     * @return seconds
     */
    public double elapsed(long now) {
        return seconds(start, now);
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
     * @return seconds; NaN while no row is finished
     */
    public synchronized double left(long now) {
        return finished == 0 ? Double.NaN : elapsed(now) * (rows - finished) / finished;
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
