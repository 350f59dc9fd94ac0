package simpleray.ui.film;

import java.awt.Dimension;

/**
 * Says which frame of a film is rendered next while it plays, and how coarse, so that the film plays at its rate. Where a frame takes
 * longer than it is shown, all are coarser. Once each frame is there, they are rendered again as fine as the memory has room for.
 * <em>Mutable.</em> Any thread may call.
 */
final class PlayPlan {
    private static final int[] DIVISORS = {1, 2, 3, 4, 6, 8};
    private static final int COARSEST = DIVISORS[DIVISORS.length - 1];
    /** The share of the time for which a frame is shown that rendering it may take. */
    private static final double SHARE = 0.8;
    private static final double SECOND = 1e9;

    private final int frames;
    private final double rate;
    private final Dimension size;
    private final FrameCache cache;
    private final int fine;                                   // the least divisor with which all frames fit; 0 for none
    private double perPixel = -1;                             // nanoseconds; negative before anything was measured

    /** A frame to be rendered, and by how much its sides are shorter than those of the whole picture. */
    record Choice(int frame, int divisor) {
    }

    /** Plans a film of some frames at a rate a second, 1 or more and above 0. */
    PlayPlan(int frames, double rate, Dimension size, FrameCache cache) {
        this.frames = frames;
        this.rate = rate;
        this.size = size;
        this.cache = cache;
        int least = 0;
        for (int i = DIVISORS.length - 1; i >= 0 && fits(frames, DIVISORS[i]); i--) {
            least = DIVISORS[i];
        }
        fine = least;
    }

    private boolean fits(long count, int divisor) {
        return count * bytes(divisor) <= cache.room();
    }

    private long bytes(int divisor) {
        Dimension sides = sides(divisor);
        return FrameCache.bytes(sides.width, sides.height);
    }

    /** {@return the sides of a frame's picture, 1 pixel or more} */
    Dimension sides(int divisor) {
        return new Dimension((size.width + divisor - 1) / divisor, (size.height + divisor - 1) / divisor);
    }

    /** Notes how long a frame took. */
    synchronized void took(long nanoseconds, int divisor) {
        double now = (double) nanoseconds * Integer.BYTES / bytes(divisor);
        perPixel = perPixel < 0 ? now : (perPixel + now) / 2;
    }

    private double seconds(int divisor) {
        return Math.max(0, perPixel) * bytes(divisor) / Integer.BYTES / SECOND;
    }

    /** {@return the finest divisor with which frames are ready in time and fit; the coarsest before anything was measured} */
    private int pace() {
        for (int divisor : DIVISORS) {
            if (divisor >= fine && perPixel >= 0 && seconds(divisor) * rate <= SHARE) {
                return divisor;
            }
        }
        return COARSEST;
    }

    /**
     * Chooses a frame.
     *
     * @param at the frame that is shown
     * @param loop whether the first follows the last
     * @return the frame; null while there is nothing to do
     */
    synchronized Choice next(int at, boolean loop) {
        int pace = pace();
        int skipped = (int) Math.min(frames - 1, (long) (seconds(pace) * rate));   // are shown meanwhile
        int count = loop ? frames : frames - at;
        int room = fine > 0 ? count : (int) Math.min(count, cache.room() / bytes(pace));
        for (int i = 0; i < room; i++) {
            int frame = (at + (skipped + i) % count) % frames;
            if (cache.get(frame) == null) {
                return new Choice(frame, pace);
            }
        }
        for (int i = 0; fine > 0 && i < count; i++) {
            int frame = (at + i) % frames;
            if (cache.get(frame).divisor() > fine) {
                return new Choice(frame, fine);
            }
        }
        return null;
    }
}
