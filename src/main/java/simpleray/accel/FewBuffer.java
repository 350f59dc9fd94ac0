package simpleray.accel;

import java.util.Arrays;
import simpleray.math.Point;

/**
 * For each direction from a point, the planes that lie there, and where they are few the bounded objects, too, the nearest first; as
 * {@link DirectionBuffer}. What a ray is asked about lies side by side in one array. <em>Constant</em>, but for a {@link #copy}, which
 * belongs to one thread.
 */
final class FewBuffer {
    /**
     * Numbers an entry: how near the object is at least; a sphere's centre and radius, or a plane's normal and constant; its place in
     * {@link Primitives}, its kind, and its place in the scene. Behind the last of a list stands one that is neither near nor far: not a
     * number.
     */
    static final int ENTRY = 8;
    static final int PLACE = 5;
    static final int KIND = 6;
    static final int ORDER = 7;

    private static final int NOW_AND_THEN = 15;
    private static final int SIDE = 12;
    private static final int MOST_PLANES = 64;
    /** By what share of the numbers it is made of, and of the way to a plane, a plane may be nearer than worked out. */
    private static final double ROUNDING = 1e-9;
    private static final double MARGIN = 1e-5;
    /** How many times as far away as a plane a ray may start: then its way is known to a tenth of the margin. */
    private static final double REACH = 1e9;

    private final Cube cube;
    /** Where in {@link #numbers} the list of each cell begins. */
    final int[] starts;
    /** The entries, list by list. */
    double[] numbers;
    /** Whether the bounded objects are in the lists. */
    final boolean whole;
    /** From how far away a ray may come towards the point: from farther, rounding lets it hit what is not on its way. */
    double reach = Double.POSITIVE_INFINITY;
    private int end;
    private int asked;
    private final double[] spare = new double[ENTRY];         // for an exchange: nothing is made for a ray

    private FewBuffer(Cube cube, int cells, boolean whole) {
        this.cube = cube;
        this.whole = whole;
        starts = new int[cells];
        numbers = new double[4 * ENTRY * cells];
    }

    private FewBuffer(FewBuffer other) {
        cube = other.cube;
        whole = other.whole;
        starts = other.starts;
        numbers = other.numbers.clone();
    }

    /** Lists the objects in no direction, as of everywhere: all, or only those that are not bounded. */
    static FewBuffer everywhere(Primitives all, boolean whole) {
        FewBuffer buffer = new FewBuffer(null, 1, whole);
        for (int place = whole ? 0 : all.bounded; place < all.count(); place++) {
            buffer.insert(all, 0, place, 0);
        }
        buffer.close();
        return buffer;
    }

    /**
     * Makes the buffer of a point.
     *
     * @param all the objects
     * @param boxes the boxes of the bounded ones; null where those are not to be listed
     * @param point the point
     * @return the buffer; null if there is nothing to gain
     */
    static FewBuffer of(Primitives all, Boxes boxes, Point point) {
        int count = all.planes.length / 4;
        Seen[] seen = boxes == null ? null : Seen.of(boxes, point);
        if (count > MOST_PLANES || count + (seen == null ? 0 : seen.length) < 2) {
            return null;
        }
        Cube cube = new Cube(SIDE);
        FewBuffer buffer = new FewBuffer(cube, cube.cells(), seen != null);
        Plane[] planes = new Plane[count];
        for (int i = 0; i < count; i++) {
            planes[i] = new Plane(all, i, point);
            buffer.reach = Math.min(buffer.reach, planes[i].reach);
        }
        if (buffer.whole) {
            buffer.reach = Math.min(buffer.reach, boxes.reach());
        }
        for (int row = 0; row < Cube.FACES * SIDE; row++) {
            for (Plane plane : planes) {
                plane.look(cube, row);
            }
            for (int column = 0; column < SIDE; column++) {
                buffer.list(all, planes, seen, row, column);
            }
        }
        return buffer;
    }

    /** Lists what lies in a cell, of a row that the planes look along. */
    private void list(Primitives all, Plane[] planes, Seen[] seen, int row, int column) {
        int first = end;
        starts[row * SIDE + column] = first;
        for (int i = 0; i < planes.length; i++) {
            double distance = planes[i].near(cube, column);
            if (distance < Double.POSITIVE_INFINITY) {
                insert(all, first, all.bounded + i, distance);
            }
        }
        for (int i = 0; whole && i < seen.length; i++) {
            if (seen[i].covers(row, column)) {
                insert(all, first, i, seen[i].near);
            }
        }
        for (int place = all.afterPlanes; place < all.count(); place++) {
            insert(all, first, place, 0);
        }
        close();
    }

    /** Inserts an object into the list that is being made, where its distance belongs. */
    private void insert(Primitives all, int first, int place, double distance) {
        int at = next();
        for (; at > first && numbers[at - ENTRY] > distance; at -= ENTRY) {
            System.arraycopy(numbers, at - ENTRY, numbers, at, ENTRY);
        }
        numbers[at] = distance;
        all.copy(place, numbers, at + 1);
        numbers[at + PLACE] = place;
        numbers[at + KIND] = all.kind(place);
        numbers[at + ORDER] = all.order[place];
    }

    private void close() {
        int at = next();                                      // which may put the numbers elsewhere
        numbers[at] = Double.NaN;
    }

    private int next() {
        int at = end;
        end += ENTRY;
        if (end > numbers.length) {
            numbers = Arrays.copyOf(numbers, 2 * end);
        }
        return at;
    }

    /** {@return where the list of a direction begins} */
    int start(double dx, double dy, double dz) {
        return starts[cube.cell(dx, dy, dz)];
    }

    /** {@return the same lists, in which the order of entries can be changed} */
    FewBuffer copy() {
        return new FewBuffer(this);
    }

    /** {@return whether it is time to ask something else first: now and then, as it is mostly the same that is in the way} */
    boolean isDue() {
        return (++asked & NOW_AND_THEN) == 0;
    }

    /** Exchanges two entries. */
    void exchange(int one, int other) {
        System.arraycopy(numbers, one, spare, 0, ENTRY);
        System.arraycopy(numbers, other, numbers, one, ENTRY);
        System.arraycopy(spare, 0, numbers, other, ENTRY);
    }

    /** A plane as seen from the point: N·D / h, one over the way to it in direction D, is linear in D. */
    private static final class Plane {
        private final double[] slopes = new double[3];
        final double reach;
        private final boolean close;
        private final double slack;
        private double most;                                  // 1 / way in the row that it looks along, at most, but for the column's share
        private double slope;                                 // of 1 / way along that row
        private double rounding;

        Plane(Primitives all, int i, Point point) {
            double[] p = all.planes;
            double nx = p[4 * i];
            double ny = p[4 * i + 1];
            double nz = p[4 * i + 2];
            double c = p[4 * i + 3];
            double height = c - (nx * point.x + ny * point.y + nz * point.z);
            double numbers = Math.abs(c) + Math.abs(nx * point.x) + Math.abs(ny * point.y) + Math.abs(nz * point.z);
            close = !(Math.abs(height) > ROUNDING * numbers);
            reach = close ? Double.POSITIVE_INFINITY : REACH * Math.abs(height) / Math.sqrt(nx * nx + ny * ny + nz * nz);
            slopes[0] = nx / height;
            slopes[1] = ny / height;
            slopes[2] = nz / height;
            slack = ROUNDING * Math.max(Math.abs(point.x), Math.max(Math.abs(point.y), Math.abs(point.z)));
        }

        /** Looks along a row of cells; the rows of all faces are counted on. */
        void look(Cube cube, int row) {
            int face = row / SIDE;
            int along = row % SIDE;
            double ahead = (face & 1) == 0 ? slopes[face >> 1] : -slopes[face >> 1];
            double b = slopes[Cube.along(face)];
            slope = slopes[Cube.across(face)];
            most = ahead + Math.max(b * cube.slope(along), b * cube.slope(along + 1));
            rounding = ROUNDING * (Math.abs(ahead) + Math.abs(slope) + Math.abs(b));
        }

        /** {@return how near the plane is in the directions of a cell of the row, or less; infinite if it is not there} */
        double near(Cube cube, int column) {
            if (close) {
                return 0;
            }
            double highest = most + Math.max(slope * cube.slope(column), slope * cube.slope(column + 1));
            if (highest < -rounding) {
                return Double.POSITIVE_INFINITY;
            }
            return Math.max(0, (1 - MARGIN) / (highest + rounding) - slack);   // a direction in a face is 1 long at least
        }
    }

    /** A bounded object as seen from the point. */
    private static final class Seen {
        final double near;
        private final int[][] rectangles = new int[Cube.FACES][];

        private Seen(Boxes boxes, int i, double[] point, Cube cube) {
            double[] box = new double[Boxes.SIDES];
            DirectionBuffer.seen(boxes, i, point[0], point[1], point[2], box);
            near = DirectionBuffer.distance(box);
            for (int face = 0; face < Cube.FACES; face++) {
                int[] rectangle = new int[4];
                if (DirectionBuffer.covers(box, face, cube, rectangle)) {
                    rectangles[face] = rectangle;
                }
            }
        }

        /** {@return the objects, in the order of their boxes; null where their boxes may be too small for so far a point} */
        static Seen[] of(Boxes boxes, Point point) {
            double[] about = DirectionBuffer.about(boxes, point);
            if (about == null) {
                return null;
            }
            Seen[] all = new Seen[boxes.count()];
            for (int i = 0; i < all.length; i++) {
                all[i] = new Seen(boxes, i, about, new Cube(SIDE));
            }
            return all;
        }

        /** {@return whether it may be seen in a cell; the rows of all faces are counted on} */
        boolean covers(int row, int column) {
            int[] rectangle = rectangles[row / SIDE];
            int along = row % SIDE;
            return rectangle != null && rectangle[0] <= column && column <= rectangle[1] && rectangle[2] <= along && along <= rectangle[3];
        }
    }
}
