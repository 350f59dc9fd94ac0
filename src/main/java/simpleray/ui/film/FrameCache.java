package simpleray.ui.film;

import java.awt.image.BufferedImage;
import java.util.HashMap;
import java.util.Map;
import java.util.function.IntUnaryOperator;

/** The pictures of a film's frames, as many as fit into some memory. <em>Mutable.</em> Any thread may call. */
final class FrameCache {
    private static final int BYTES = Integer.BYTES;           // of a pixel
    /** The share of the memory that they may take. */
    private static final int SHARE = 4;

    private final long room;
    private final Map<Integer, Kept> kept = new HashMap<>();
    private long bytes;

    /**
     * The picture of a frame.
     *
     * @param image the picture, not to be changed
     * @param divisor by how much its sides are shorter than those of the whole picture, 1 or more
     */
    record Kept(BufferedImage image, int divisor) {
        private long bytes() {
            return FrameCache.bytes(image.getWidth(), image.getHeight());
        }
    }

    /** Creates a cache that never takes more than a quarter of the memory that Java may use. */
    FrameCache() {
        this(Runtime.getRuntime().maxMemory() / SHARE);
    }

    /** Creates a cache that may take a number of bytes. */
    FrameCache(long room) {
        this.room = room;
    }

    /** {@return the bytes that the picture of a frame takes} */
    static long bytes(int width, int height) {
        return (long) BYTES * width * height;
    }

    /** {@return the bytes that the pictures may take} */
    long room() {
        return room;
    }

    /** {@return the bytes that the pictures take} */
    synchronized long bytes() {
        return bytes;
    }

    /** {@return the picture of a frame; null if it is not there} */
    synchronized Kept get(int frame) {
        return kept.get(frame);
    }

    /**
     * Keeps the picture of a frame, in place of one that it may have. Where there is not room for all, those go first whose turn is the
     * last; that may be the new one.
     *
     * @param turn tells how many frames are shown before a frame
     */
    synchronized void put(int frame, Kept picture, IntUnaryOperator turn) {
        remove(frame);
        while (bytes + picture.bytes() > room) {
            int last = frame;
            for (int other : kept.keySet()) {
                last = turn.applyAsInt(other) > turn.applyAsInt(last) ? other : last;
            }
            if (last == frame) {
                return;
            }
            remove(last);
        }
        kept.put(frame, picture);
        bytes += picture.bytes();
    }

    private void remove(int frame) {
        Kept old = kept.remove(frame);
        bytes -= old == null ? 0 : old.bytes();
    }
}
