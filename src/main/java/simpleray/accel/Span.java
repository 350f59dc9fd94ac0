package simpleray.accel;

import java.util.Arrays;

/** Some boxes that lie side by side in {@link Boxes}, while a tree is built of them. <em>Constant</em>, but for the order in it. */
final class Span {
    /** Places along an axis at which a span may be parted. */
    private static final int BINS = 16;

    final Boxes boxes;
    /** The first box. */
    final int first;
    /** One after the last. */
    final int end;
    /** The box around all of them. */
    final float[] bounds = {Float.POSITIVE_INFINITY, Float.POSITIVE_INFINITY, Float.POSITIVE_INFINITY,
        Float.NEGATIVE_INFINITY, Float.NEGATIVE_INFINITY, Float.NEGATIVE_INFINITY};
    /** The box around the middles of all of them, doubled. */
    private final float[] middles = bounds.clone();

    Span(Boxes boxes, int first, int end) {
        this.boxes = boxes;
        this.first = first;
        this.end = end;
        float[] s = boxes.sides;
        for (int i = first; i < end; i++) {
            int at = Boxes.SIDES * i;
            grow(bounds, s, at);
            for (int axis = 0; axis < 3; axis++) {
                float middle = s[at + axis] + s[at + axis + 3];
                middles[axis] = Math.min(middles[axis], middle);
                middles[axis + 3] = Math.max(middles[axis + 3], middle);
            }
        }
    }

    int count() {
        return end - first;
    }

    /** {@return half the surface of the box around all of them} */
    float area() {
        return area(bounds);
    }

    private static float area(float[] box) {
        float x = box[3] - box[0];
        float y = box[4] - box[1];
        float z = box[5] - box[2];
        return x < 0 ? 0 : x * y + y * z + z * x;
    }

    private static void grow(float[] box, float[] sides, int at) {
        box[0] = Math.min(box[0], sides[at]);
        box[1] = Math.min(box[1], sides[at + 1]);
        box[2] = Math.min(box[2], sides[at + 2]);
        box[3] = Math.max(box[3], sides[at + 3]);
        box[4] = Math.max(box[4], sides[at + 4]);
        box[5] = Math.max(box[5], sides[at + 5]);
    }

    /**
     * Parts the span in two where the surface area heuristic finds it best among a few places along its longest axis (Wald, "On fast
     * Construction of SAH-based Bounding Volume Hierarchies", 2007).
     *
     * @param even whether to part it into equal numbers instead, which bounds the depth of a tree
     * @param least the most boxes that may stay together if parting does not pay
     * @return the two parts; null if the boxes may stay together and better do
     */
    Span[] parts(boolean even, int least) {
        int axis = 0;
        for (int other = 1; other < 3; other++) {
            if (middles[other + 3] - middles[other] > middles[axis + 3] - middles[axis]) {
                axis = other;
            }
        }
        float width = middles[axis + 3] - middles[axis];
        if (even || !(width > 0 && width < Float.POSITIVE_INFINITY)) {
            return count() <= least ? null : at(first + count() / 2);
        }
        float scale = BINS / width * 0.9999f;
        float[][] bins = new float[BINS][];
        int[] counts = new int[BINS];
        float[] s = boxes.sides;
        for (int i = first; i < end; i++) {
            int at = Boxes.SIDES * i;
            int bin = bin(s, at, axis, scale);
            if (bins[bin] == null) {
                bins[bin] = Arrays.copyOfRange(s, at, at + Boxes.SIDES);
            } else {
                grow(bins[bin], s, at);
            }
            counts[bin]++;
        }
        int border = border(bins, counts, least);
        if (border < 0) {
            return null;
        }
        int low = first;
        int high = end - 1;
        while (low <= high) {
            if (bin(s, Boxes.SIDES * low, axis, scale) < border) {
                low++;
            } else {
                boxes.swap(low, high--);
            }
        }
        return at(low);
    }

    private int bin(float[] s, int at, int axis, float scale) {
        return Math.min(BINS - 1, Math.max(0, (int) ((s[at + axis] + s[at + axis + 3] - middles[axis]) * scale)));
    }

    private Span[] at(int middle) {
        return new Span[] {new Span(boxes, first, middle), new Span(boxes, middle, end)};
    }

    /** {@return the bin at which the second part begins; -1 if the boxes better stay together} */
    private int border(float[][] bins, int[] counts, int least) {
        float[] highAreas = new float[BINS];
        int[] highCounts = new int[BINS];
        float[] box = new float[Boxes.SIDES];
        int count = 0;
        for (int i = BINS - 1; i > 0; i--) {
            add(box, bins[i], count == 0);
            count += counts[i];
            highAreas[i] = count == 0 ? 0 : area(box);
            highCounts[i] = count;
        }
        count = 0;
        int border = -1;
        float best = Float.POSITIVE_INFINITY;
        for (int i = 1; i < BINS; i++) {
            add(box, bins[i - 1], count == 0);
            count += counts[i - 1];
            if (count > 0 && highCounts[i] > 0) {
                float cost = area(box) * count + highAreas[i] * highCounts[i];
                if (border < 0 || cost < best) {
                    best = cost;
                    border = i;
                }
            }
        }
        return count() <= least && best + area() >= area() * count() ? -1 : border;
    }

    private static void add(float[] box, float[] bin, boolean first) {
        if (bin != null) {
            if (first) {
                System.arraycopy(bin, 0, box, 0, Boxes.SIDES);
            } else {
                grow(box, bin, 0);
            }
        }
    }
}
