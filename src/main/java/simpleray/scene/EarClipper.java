package simpleray.scene;

import java.math.BigDecimal;
import java.util.Arrays;

/**
 * Cuts a polygon into triangles that cover exactly it, by ear clipping (Meisters, "Polygons have ears", 1975). <em>Mutable,</em> for one thread.
 *
 * <p>The polygon is projected along the axis nearest to its normal (Newell's), which rounds nothing. The sign of an area is exact. Each triangle has
 * an area above 0 on the polygon's own side, and each edge of one is an edge of the polygon or, backwards, of another triangle; so they cover
 * each point as often as the polygon winds around it: once if it does not cross itself. All corners stay corners of triangles, also those
 * on a straight line, so that no seam opens to a neighbour.
 *
 * <p>Edges may touch one another, as those of a hole and the bridge to it do. Corners that lie in one place one after another, and spikes
 * without area, are passed over.
 */
public final class EarClipper {
    /** The result for a convex polygon: the fan from its first corner. */
    public static final int[] FAN = {};

    /** The error of a rounded area, as a share of its two products (Shewchuk, "Adaptive Precision Floating-Point Arithmetic", 1997). */
    private static final double AREA_ERROR = (3 + 16 * 0x1p-53) * 0x1p-53;
    /** The error of coordinates that were rounded to doubles, as a share of the largest; what crosses by less than that touches. */
    private static final double ROUNDING = 0x1p-50;

    // the projected corners, anticlockwise
    private double[] x = {};
    private double[] y = {};
    private double noise;                                     // the error of a coordinate
    private boolean isWarped;

    // the ring of corners that are left; a removed one has no next
    private int[] next = {};
    private int[] previous = {};
    private int left;

    private int[] suspects = {};                              // corners that may lie in an ear, from left to right
    private int suspectCount;
    private int[] triangles = {};
    private int end;

    /** Creates one, for any number of polygons. */
    public EarClipper() {
    }

    /**
     * Cuts a polygon.
     *
     * @param vertices x, y, z of each vertex
     * @param corners the polygon's vertices, counted from 0
     * @param count the number of corners, 3 or more
     * @return the corners of each triangle, as indices of the corners, running round as the polygon does; {@link #FAN} if that is it since it is
     *     convex, or so far from flat that it has no plane to be cut in; null if it cannot be cut, since it crosses itself
     */
    public int[] cut(double[] vertices, int[] corners, int count) {
        if (!project(vertices, corners, count)) {
            return null;
        }
        if (isWarped || isConvex(count)) {
            return FAN;
        }
        for (int i = 0; i < count; i++) {
            next[i] = i + 1 < count ? i + 1 : 0;
            previous[i] = (i > 0 ? i : count) - 1;
        }
        left = count;
        int first = withoutSpikes();
        if (left < 3 || crosses(first)) {
            return null;
        }
        if (turns(first) != 1) {                              // it runs round in place more than once, or crosses itself at corners
            return isFan(count) ? FAN : null;
        }
        suspect(first);
        end = 0;
        triangles = new int[3 * (left - 2)];
        return clip(next[first]) ? Arrays.copyOf(triangles, end) : null;
    }

    /** Projects the corners, and finds whether they are far from flat. {@return false if the polygon has no area} */
    private boolean project(double[] v, int[] corners, int count) {
        if (x.length < count) {
            x = new double[count];
            y = new double[count];
            next = new int[count];
            previous = new int[count];
        }
        double[] normal = new double[3];
        double[] cross = new double[3];
        double largest = 0;
        for (int i = 0; i < count; i++) {
            int at = 3 * corners[i];
            Triangles.cross(v, 3 * corners[0], at, 3 * corners[i + 1 < count ? i + 1 : 0], cross);
            for (int k = 0; k < 3; k++) {
                normal[k] += cross[k];
                largest = Math.max(largest, Math.abs(v[at + k]));
            }
        }
        noise = largest * ROUNDING;
        double nx = Math.abs(normal[0]);
        double ny = Math.abs(normal[1]);
        double nz = Math.abs(normal[2]);
        int axis = nx > ny ? nx > nz ? 0 : 2 : ny > nz ? 1 : 2;
        int right = (axis + (normal[axis] > 0 ? 1 : 2)) % 3;
        int up = 3 - axis - right;
        double slopeRight = normal[right] / normal[axis];
        double slopeUp = normal[up] / normal[axis];
        Range width = new Range();
        Range height = new Range();
        Range depth = new Range();                            // off the plane
        for (int i = 0; i < count; i++) {
            int at = 3 * corners[i];
            x[i] = v[at + right];
            y[i] = v[at + up];
            width.add(x[i]);
            height.add(y[i]);
            depth.add(v[at + axis] + slopeRight * x[i] + slopeUp * y[i]);
        }
        isWarped = depth.size() > (width.size() + height.size()) / 2;
        return normal[axis] != 0;
    }

    /** {@return whether all corners turn left, by one full turn; what turns right or back by no more than rounding goes straight on} */
    private boolean isConvex(int count) {
        int turns = 0;
        int a = count - 1;
        while (a > 0 && isSame(a, 0)) {
            a--;
        }
        int b = 0;
        for (int c = 1; c <= count; c++) {
            int to = c < count ? c : 0;
            if (isSame(b, to)) {
                continue;
            }
            boolean straight = Math.abs(roundedArea(a, b, to)) <= noise * (distance(a, b) + distance(b, to));
            if (straight ? isBack(a, b, to) : roundedArea(a, b, to) < 0) {
                return false;
            }
            turns += turn(a, b, to);
            a = b;
            b = to;
        }
        return turns == 1;
    }

    /** Removes corners that lie in the place of the next, and spikes. {@return a corner that is left, the first if it is} */
    private int withoutSpikes() {
        int at = 0;
        int first = 0;
        for (int unchanged = 0; unchanged < left && left > 2; unchanged++) {
            if (isSpike(at)) {
                first = at == first ? next[at] : first;
                int before = previous[at];
                remove(at);
                at = previous[before];
                unchanged = -1;
            }
            at = next[at];
        }
        return first;
    }

    /** {@return whether the corner adds no area: it lies in the place of a neighbour, or the next edge runs back along the one before} */
    private boolean isSpike(int at) {
        int a = previous[at];
        int c = next[at];
        return isSame(at, c) || isSame(at, a) || isBack(a, at, c) && area(a, at, c) == 0;
    }

    private void remove(int at) {
        next[previous[at]] = next[at];
        previous[next[at]] = previous[at];
        next[at] = -1;
        left--;
    }

    /** {@return how many full turns to the left the ring makes} */
    private int turns(int first) {
        int turns = 0;
        int at = first;
        do {
            turns += turn(previous[at], at, next[at]);
            at = next[at];
        } while (at != first);
        return turns;
    }

    /** {@return whether no triangle of the fan from the first corner turns right} */
    private boolean isFan(int count) {
        for (int i = 2; i < count; i++) {
            if (area(0, i - 1, i) < 0) {
                return false;
            }
        }
        return true;
    }

    /** {@return 1 or -1 if the direction passes that of the x axis to the left or to the right at a corner, else 0} */
    private int turn(int a, int b, int c) {
        boolean before = isUpper(a, b);
        boolean after = isUpper(b, c);
        if (before == after) {
            return 0;
        }
        double area = area(a, b, c);
        return after && area > 0 ? 1 : before && area < 0 ? -1 : 0;
    }

    private boolean isUpper(int a, int b) {
        return y[b] > y[a] || y[b] == y[a] && x[b] > x[a];
    }

    /** {@return whether two edges cross, each from one side of the other to the other side} */
    private boolean crosses(int first) {
        Integer[] order = ring(first);
        double[] u = spread(order, x) <= spread(order, y) ? x : y;    // sweep along the axis of which edges take less
        Arrays.sort(order, (a, b) -> Double.compare(Math.min(u[a], u[next[a]]), Math.min(u[b], u[next[b]])));
        int[] open = new int[order.length];                   // the edges that the sweep has not left behind
        int count = 0;
        for (int edge : order) {
            double from = Math.min(u[edge], u[next[edge]]);
            int kept = 0;
            for (int k = 0; k < count; k++) {
                int other = open[k];
                if (Math.max(u[other], u[next[other]]) >= from) {
                    open[kept++] = other;
                    if (isCrossed(edge, other) && isCrossed(other, edge)) {
                        return true;
                    }
                }
            }
            count = kept;
            open[count++] = edge;
        }
        return false;
    }

    private Integer[] ring(int first) {
        Integer[] ring = new Integer[left];
        int at = first;
        for (int i = 0; i < left; i++) {
            ring[i] = at;
            at = next[at];
        }
        return ring;
    }

    /** {@return the length of all edges along an axis, in lengths of the polygon} */
    private double spread(Integer[] order, double[] u) {
        double sum = 0;
        Range range = new Range();
        for (int i : order) {
            sum += Math.abs(u[next[i]] - u[i]);
            range.add(u[i]);
        }
        return sum / range.size();
    }

    /** {@return whether the ends of another edge lie on both sides of an edge's line, by more than rounding} */
    private boolean isCrossed(int edge, int other) {
        double least = noise * distance(edge, next[edge]);
        double a = roundedArea(edge, next[edge], other);
        double b = roundedArea(edge, next[edge], next[other]);
        return a > least && b < -least || a < -least && b > least;
    }

    /** Notes the corners that may lie in an ear: if any corner does, one does that turns right or shares its place. */
    private void suspect(int first) {
        Integer[] order = ring(first);
        Arrays.sort(order, (a, b) -> x[a] != x[b] ? Double.compare(x[a], x[b]) : Double.compare(y[a], y[b]));
        suspects = new int[order.length];
        suspectCount = 0;
        for (int i = 0; i < order.length; i++) {
            int at = order[i];
            boolean shared = i > 0 && isSame(at, order[i - 1]) || i + 1 < order.length && isSame(at, order[i + 1]);
            if (shared || area(previous[at], at, next[at]) <= 0) {
                suspects[suspectCount++] = at;
            }
        }
    }

    /** What is taken for an ear. */
    private enum Rule {
        /** A corner that turns left by more than rounding, with nothing else in its triangle or as near to it as rounding. */
        CLEAR,
        /** The same without regard to rounding: a polygon that does not touch itself always has such an ear. */
        EXACT,
        /** Something may lie in it by no more than rounding: edges touch. */
        TOUCHED
    }

    /** Clips ears, of one corner as long as possible, by the strictest rule by which there are any. {@return whether nothing is left} */
    private boolean clip(int second) {
        int at = second;
        Rule rule = Rule.CLEAR;
        for (int vain = 0; left > 2; vain++) {
            if (vain > left) {
                if (rule == Rule.TOUCHED) {
                    return false;
                }
                rule = rule == Rule.CLEAR ? Rule.EXACT : Rule.TOUCHED;
                vain = 0;
            }
            int a = previous[at];
            int c = next[at];
            if (isSpike(at)) {
                remove(at);
                vain = -1;
            } else if (isEar(a, at, c, rule)) {
                triangles[end++] = a;
                triangles[end++] = at;
                triangles[end++] = c;
                remove(at);
                vain = -1;
            }
            at = c;
        }
        return true;
    }

    /** {@return whether the ring turns left at b, and no other part of it lies in this triangle} */
    private boolean isEar(int a, int b, int c, Rule rule) {
        if (rule == Rule.CLEAR ? roundedArea(a, b, c) <= noise * (distance(a, b) + distance(b, c)) : area(a, b, c) <= 0) {
            return false;
        }
        double xmin = Math.min(x[a], Math.min(x[b], x[c])) - noise;
        double xmax = Math.max(x[a], Math.max(x[b], x[c])) + noise;
        double ymin = Math.min(y[a], Math.min(y[b], y[c])) - noise;
        double ymax = Math.max(y[a], Math.max(y[b], y[c])) + noise;
        for (int i = firstFrom(xmin); i < suspectCount && x[suspects[i]] <= xmax; i++) {
            int p = suspects[i];
            if (y[p] >= ymin && y[p] <= ymax && next[p] >= 0 && p != a && p != b && p != c && isIn(p, a, b, c, rule)) {
                return false;
            }
        }
        return true;
    }

    /** {@return the first suspect from this x on} */
    private int firstFrom(double xmin) {
        int low = 0;
        int high = suspectCount;
        while (low < high) {
            int middle = (low + high) >>> 1;
            if (x[suspects[middle]] < xmin) {
                low = middle + 1;
            } else {
                high = middle;
            }
        }
        return low;
    }

    /** {@return whether a corner, or an edge at it if it is in the place of one of the three, lies in the triangle} */
    private boolean isIn(int p, int a, int b, int c, Rule rule) {
        if (rule != Rule.TOUCHED && (isSame(p, a) || isSame(p, b) || isSame(p, c))) {
            return isSame(p, a) ? leadsIn(p, b, c) : isSame(p, b) ? leadsIn(p, c, a) : leadsIn(p, a, b);
        }
        if (rule == Rule.EXACT) {
            return area(a, b, p) >= 0 && area(b, c, p) >= 0 && area(c, a, p) >= 0;
        }
        double least = rule == Rule.CLEAR ? -noise : noise;
        return roundedArea(a, b, p) > least * distance(a, b) && roundedArea(b, c, p) > least * distance(b, c)
            && roundedArea(c, a, p) > least * distance(c, a);
    }

    /** {@return whether an edge at p runs between the directions to b and c} */
    private boolean leadsIn(int p, int b, int c) {
        return area(p, b, next[p]) > 0 && area(p, next[p], c) > 0 || area(p, b, previous[p]) > 0 && area(p, previous[p], c) > 0;
    }

    private boolean isSame(int a, int b) {
        return x[a] == x[b] && y[a] == y[b];
    }

    /** {@return whether the way from b to c leads back to where it came from a} */
    private boolean isBack(int a, int b, int c) {
        return (x[b] - x[a]) * (x[c] - x[b]) + (y[b] - y[a]) * (y[c] - y[b]) < 0;
    }

    private double distance(int a, int b) {
        return Math.abs(x[b] - x[a]) + Math.abs(y[b] - y[a]);
    }

    private double roundedArea(int a, int b, int c) {
        return (x[b] - x[a]) * (y[c] - y[a]) - (x[c] - x[a]) * (y[b] - y[a]);
    }

    /** {@return a number with the exact sign of the triangle's area: above 0 if it runs anticlockwise} */
    private double area(int a, int b, int c) {
        double bx = x[b] - x[a];
        double by = y[b] - y[a];
        double cx = x[c] - x[a];
        double cy = y[c] - y[a];
        double area = bx * cy - cx * by;
        if (Math.abs(area) > AREA_ERROR * (Math.abs(bx * cy) + Math.abs(cx * by))) {
            return area;
        }
        if (bx == 0 && cx == 0 || by == 0 && cy == 0) {
            return 0;
        }
        return difference(x[b], x[a]).multiply(difference(y[c], y[a])).compareTo(difference(x[c], x[a]).multiply(difference(y[b], y[a])));
    }

    private static BigDecimal difference(double a, double b) {
        return new BigDecimal(a).subtract(new BigDecimal(b));
    }

    /** The range of some numbers. */
    private static final class Range {
        private double low = Double.POSITIVE_INFINITY;
        private double high = Double.NEGATIVE_INFINITY;

        void add(double number) {
            low = Math.min(low, number);
            high = Math.max(high, number);
        }

        double size() {
            return high - low;
        }
    }
}
