package simpleray.render;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import simpleray.math.Point;
import simpleray.math.Vector;
import simpleray.scene.Cylinder;
import simpleray.scene.Mesh;
import simpleray.scene.Object;
import simpleray.scene.Plane;
import simpleray.scene.Scene;
import simpleray.scene.Triangle;

/**
 * Finds flat surfaces that overlap in one plane: planes, triangles, triangles of meshes and ends of cylinders. Faces that have a common edge
 * or lie side by side do not overlap. <em>Mutable</em>, for one thread.
 *
 * <p>Faces are sorted by the directions of their normals. Those of one direction are divided by space until few are left, and these are
 * compared in pairs.
 */
final class CoplanarSurfaces {
    /** An upper bound of the rounding errors of a face's vertices, as a share of its coordinates. */
    static final double ROUNDINGS = 0x1p-44;
    /** A smaller share of the smaller face is no overlap, but the rounding of vertices with six digits. */
    private static final double MIN_SHARE = 1e-5;
    /** The number of vertices that stand for a circle. */
    private static final int RING = 32;
    /** Normals fall into cells of this width. No normal that people write is at the edge of one, where rounding would part two faces. */
    private static final double CELL = 1.0 / 512;
    private static final Vector OFF = new Vector(0.2763932, 0.3819661, 0.4370161);
    /** No plane that people build is parallel to it; it tells which of a normal's two directions counts. */
    private static final Vector ODD = new Vector(0.5391, 0.3175, 0.7801);
    private static final long MIXER = 0x9E3779B97F4A7C15L;
    /** So few faces are compared in pairs. */
    private static final int FEW = 64;
    /** A heap of faces is not divided further if that makes so many more of them. */
    private static final double MAX_GROWTH = 1.25;
    /** Comparisons of boxes, some tenths of a second; thousands of long faces crosswise in one plane need more, and are not all compared. */
    private static final long MAX_COMPARISONS = 1L << 26;
    /** As many comparisons of boxes take as long as one of faces. */
    private static final int COST_OF_FACES = 64;
    /** More faces than that are not compared: their boxes could fill the memory. */
    private static final long MAX_FACES = 1L << 22;
    /** The most pairs of objects that are told apart. */
    private static final int MAX_PAIRS = 100_000;

    private final Scene scene;
    private final Sight sight;
    private final int[] starts;                               // the number of each object's first face
    private final Map<Long, Pair> pairs = new LinkedHashMap<>();
    private double[] boxes;                                   // of the faces of one direction: three low sides, three high ones
    private int[] numbers;                                    // of these faces
    private double slack;                                     // boxes that are so far apart may touch, by rounding
    private double middle;                                    // where to divide
    private long comparisons;

    /** Decides which overlaps may be seen. */
    interface Sight {
        /** {@return whether an overlap of these faces may be seen} */
        boolean reaches(Face one, Face other);
    }

    /**
     * Two objects that overlap in a plane, or a mesh that overlaps itself.
     *
     * @param first the index of the object listed first
     * @param second that of the other, or the same
     * @param firstFace the number of a face that overlaps among those of the first, from 0; of a mesh the triangle
     * @param secondFace that of the face of the second which it overlaps; of one object the later
     * @param place a point where they overlap
     * @param seen whether an overlap of them may be seen
     */
    record Pair(int first, int second, int firstFace, int secondFace, Point place, boolean seen) {
    }

    /**
     * A flat face.
     *
     * @param object the index of its object
     * @param number its number among those of the object, from 0
     * @param normal its unit normal, outward
     * @param offset the distance of its plane from the origin, along the normal
     * @param corners its vertices, anticlockwise as seen from outside; none for an infinite plane
     */
    record Face(int object, int number, Vector normal, double offset, Point[] corners) {
        private static Face of(int object, int number, Point... corners) {
            Vector normal = Vector.cross(Vector.subtract(corners[1], corners[0]), Vector.subtract(corners[2], corners[0])).normalised();
            return new Face(object, number, normal, normal.dot(corners[0]), corners);
        }

        private double size() {
            double size = Math.abs(offset);
            for (Point p : corners) {
                size = Math.max(size, Math.max(Math.abs(p.x), Math.max(Math.abs(p.y), Math.abs(p.z))));
            }
            return size;
        }

        private boolean isIn(Face plane, double tolerance) {
            if (corners.length == 0) {
                double cosine = normal.dot(plane.normal);
                return plane.corners.length == 0 && Vector.cross(normal, plane.normal).norm() <= ROUNDINGS
                    && Math.abs(offset - Math.signum(cosine) * plane.offset) <= tolerance;
            }
            for (Point p : corners) {
                if (Math.abs(plane.normal.dot(p) - plane.offset) > tolerance) {
                    return false;
                }
            }
            return true;
        }
    }

    private CoplanarSurfaces(Scene scene, Sight sight) {
        this.scene = scene;
        this.sight = sight;
        starts = new int[scene.getNumberObjects() + 1];
        for (int i = 0; i < scene.getNumberObjects(); i++) {
            starts[i + 1] = starts[i] + faces(scene.getObject(i));
        }
    }

    /**
     * Finds the objects that overlap in a plane; in a scene of more than four million faces none.
     *
     * @param scene the scene, which must not change meanwhile
     * @param sight decides which overlaps may be seen
     * @return the pairs of objects, each once
     */
    static Collection<Pair> find(Scene scene, Sight sight) {
        long faces = 0;
        for (int i = 0; i < scene.getNumberObjects(); i++) {
            faces += faces(scene.getObject(i));
        }
        if (faces > MAX_FACES) {
            return List.of();
        }
        CoplanarSurfaces surfaces = new CoplanarSurfaces(scene, sight);
        surfaces.find();
        return surfaces.pairs.values();
    }

    private static int faces(Object object) {
        return object instanceof Mesh mesh ? mesh.size() : object instanceof Cylinder ? 2
            : object instanceof Plane || object instanceof Triangle ? 1 : 0;
    }

    /** {@return the object of a face} */
    private int object(int number) {
        int place = Arrays.binarySearch(starts, number);
        int object = place < 0 ? -place - 2 : place;
        while (starts[object + 1] == number) {                // objects without faces
            object++;
        }
        return object;
    }

    private Face face(int number) {
        int object = object(number);
        Object of = scene.getObject(object);
        int face = number - starts[object];
        if (of instanceof Plane plane) {
            return new Face(object, face, plane.normal.normalised(), plane.constant / plane.normal.norm(), new Point[0]);
        } else if (of instanceof Triangle t) {
            return Face.of(object, face, t.a, t.b, t.c);
        } else if (of instanceof Mesh mesh) {
            return Face.of(object, face, mesh.vertex(face, 0), mesh.vertex(face, 1), mesh.vertex(face, 2));
        }
        Cylinder cylinder = (Cylinder) of;
        return face == 0 ? disc(object, face, cylinder.start, cylinder.end, cylinder.radius)
            : disc(object, face, cylinder.end, cylinder.start, cylinder.radius);
    }

    /** {@return the end of a cylinder} */
    private static Face disc(int object, int number, Point middle, Point otherEnd, double radius) {
        Vector axis = Vector.subtract(middle, otherEnd).normalised();
        Vector across = Vector.cross(axis, Math.abs(axis.x) < Math.abs(axis.y) ? new Vector(1, 0, 0) : new Vector(0, 1, 0)).normalised();
        Vector along = Vector.cross(axis, across);
        Point[] ring = new Point[RING];
        for (int i = 0; i < RING; i++) {
            double angle = 2 * Math.PI * i / RING;
            ring[i] = Point.add(Point.add(middle, Vector.scale(across, radius * Math.cos(angle))),
                Vector.scale(along, radius * Math.sin(angle)));
        }
        return new Face(object, number, axis, axis.dot(middle), ring);
    }

    private void find() {
        int count = starts[starts.length - 1];
        long[] keys = new long[count];                        // the cell of the normal, and the number of the face
        for (int i = 0; i < count; i++) {
            Vector normal = face(i).normal;
            Vector turned = Vector.scale(normal, Math.signum(normal.dot(ODD)) / CELL);
            turned.add(OFF);
            long cell = ((long) Math.floor(turned.x) * MIXER + (long) Math.floor(turned.y)) * MIXER + (long) Math.floor(turned.z);
            keys[i] = cell * MIXER & -1L << Integer.SIZE | i;
        }
        Arrays.sort(keys);
        int from = 0;
        for (int i = 1; i <= count; i++) {
            if (i == count || keys[i] >> Integer.SIZE != keys[from] >> Integer.SIZE) {
                if (i - from > 1) {
                    compareDirection(keys, from, i);
                }
                from = i;
            }
        }
    }

    /** Compares faces of one direction. */
    private void compareDirection(long[] keys, int from, int to) {
        numbers = new int[to - from];
        boxes = new double[6 * numbers.length];
        int[] all = new int[numbers.length];
        double size = 0;
        for (int i = 0; i < numbers.length; i++) {
            all[i] = i;
            numbers[i] = (int) keys[from + i];
            Face face = face(numbers[i]);
            boolean infinite = face.corners.length == 0;
            Arrays.fill(boxes, 6 * i, 6 * i + 3, infinite ? Double.NEGATIVE_INFINITY : Double.POSITIVE_INFINITY);
            Arrays.fill(boxes, 6 * i + 3, 6 * i + 6, infinite ? Double.POSITIVE_INFINITY : Double.NEGATIVE_INFINITY);
            for (Point p : face.corners) {
                stretch(6 * i, p.x);
                stretch(6 * i + 1, p.y);
                stretch(6 * i + 2, p.z);
            }
            size = Math.max(size, face.size());
        }
        slack = Object.THRESHOLD + ROUNDINGS * size;
        divide(all);
    }

    private void stretch(int at, double to) {
        boxes[at] = Math.min(boxes[at], to);
        boxes[at + 3] = Math.max(boxes[at + 3], to);
    }

    /** Divides faces at their middle along the axis along which they are spread most, as against their size, or compares them all. */
    private void divide(int[] some) {
        int axis = some.length > FEW ? widestAxis(some) : -1;
        int[] below = new int[axis < 0 ? 0 : some.length];
        int[] above = new int[below.length];
        int belows = 0;
        int aboves = 0;
        for (int k = 0; k < below.length; k++) {
            int i = some[k];
            if (boxes[6 * i + axis] <= middle + slack) {
                below[belows++] = i;
            }
            if (boxes[6 * i + axis + 3] >= middle - slack) {
                above[aboves++] = i;
            }
        }
        if (axis < 0 || belows + aboves > MAX_GROWTH * some.length || Math.max(belows, aboves) == some.length) {
            compareAll(some);
        } else {
            divide(Arrays.copyOf(below, belows));
            divide(Arrays.copyOf(above, aboves));
        }
    }

    /** Finds along which axis faces are spread most, as against their size, and their middle there. {@return the axis; -1 for none} */
    private int widestAxis(int[] some) {
        double[] sum = new double[3];
        double[] extent = new double[3];
        double[] low = {Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY};
        double[] high = {Double.NEGATIVE_INFINITY, Double.NEGATIVE_INFINITY, Double.NEGATIVE_INFINITY};
        int finite = 0;
        for (int i : some) {
            if (boxes[6 * i] > Double.NEGATIVE_INFINITY) {
                finite++;
                for (int axis = 0; axis < 3; axis++) {
                    double from = boxes[6 * i + axis];
                    double to = boxes[6 * i + axis + 3];
                    sum[axis] += from + to;
                    extent[axis] += to - from;
                    low[axis] = Math.min(low[axis], from + to);
                    high[axis] = Math.max(high[axis], from + to);
                }
            }
        }
        int widest = -1;
        double most = 0;
        for (int axis = 0; axis < 3; axis++) {
            double spread = (high[axis] - low[axis]) / (extent[axis] + finite * slack);
            if (spread > most) {
                most = spread;
                widest = axis;
                middle = sum[axis] / finite / 2;
            }
        }
        return widest;
    }

    private void compareAll(int[] some) {
        for (int i = 0; i < some.length; i++) {
            Face one = null;
            for (int j = i + 1; j < some.length && comparisons < MAX_COMPARISONS; j++) {
                comparisons++;
                if (overlap(some[i], some[j]) && isNew(object(numbers[some[i]]), object(numbers[some[j]]))) {
                    comparisons += COST_OF_FACES;
                    one = one == null ? face(numbers[some[i]]) : one;
                    compareFaces(one, face(numbers[some[j]]));
                }
            }
        }
    }

    /** {@return whether it is not known yet that two objects overlap where it may be seen} */
    private boolean isNew(int one, int other) {
        Pair known = pairs.get(key(one, other));
        return known == null ? pairs.size() < MAX_PAIRS : !known.seen;
    }

    private static long key(int one, int other) {
        return (long) Math.min(one, other) << Integer.SIZE | Math.max(one, other);
    }

    /** {@return whether two boxes touch, and overlap along two axes at least} Faces with a common edge along an axis do not. */
    private boolean overlap(int i, int j) {
        int axes = 0;
        for (int axis = 0; axis < 3; axis++) {
            double common = Math.min(boxes[6 * i + axis + 3], boxes[6 * j + axis + 3]) - Math.max(boxes[6 * i + axis], boxes[6 * j + axis]);
            if (common < -slack) {
                return false;
            }
            axes += common > 0 ? 1 : 0;
        }
        return axes > 1;
    }

    private void compareFaces(Face one, Face other) {
        double tolerance = ROUNDINGS * Math.max(one.size(), other.size());
        if (isClear(scene, one) || isClear(scene, other)) {   // a ray that leaves one would miss the other
            tolerance = Math.max(tolerance, Object.THRESHOLD);
        }
        Point place = one.isIn(other, tolerance) || other.isIn(one, tolerance) ? common(one, other) : null;
        if (place != null) {
            long key = key(one.object, other.object);
            boolean seen = sight.reaches(one, other);
            if (seen || !pairs.containsKey(key)) {
                boolean inOrder = one.object < other.object || one.object == other.object && one.number < other.number;
                Face first = inOrder ? one : other;
                Face second = inOrder ? other : one;
                pairs.put(key, new Pair(first.object, second.object, first.number, second.number, place, seen));
            }
        }
    }

    /** {@return whether light passes through a face} */
    static boolean isClear(Scene scene, Face face) {
        return !scene.getObject(face.object).isOpaque();
    }

    /** {@return a point in the overlap of two faces of one plane; null if there is none} */
    private static Point common(Face one, Face other) {
        if (one.corners.length == 0 && other.corners.length == 0) {
            return Point.add(new Point(), Vector.scale(one.normal, one.offset));
        }
        if (one.corners.length == 0 || other.corners.length == 0) {
            return middle(List.of(one.corners.length == 0 ? other.corners : one.corners));
        }
        List<Point> cut = List.of(one.corners);
        for (int i = 0; i < other.corners.length && cut.size() > 2; i++) {
            cut = cut(cut, other, i);
        }
        double smaller = Math.min(area(List.of(one.corners)), area(List.of(other.corners)));
        return cut.size() > 2 && area(cut) > MIN_SHARE * smaller ? middle(cut) : null;
    }

    /** {@return the part of a polygon inside an edge of a face} Sutherland and Hodgman, "Reentrant Polygon Clipping", 1974. */
    private static List<Point> cut(List<Point> polygon, Face face, int edge) {
        Point start = face.corners[edge];
        Vector inward = Vector.cross(face.normal, Vector.subtract(face.corners[(edge + 1) % face.corners.length], start));
        List<Point> left = new ArrayList<>();
        for (int i = 0; i < polygon.size(); i++) {
            Point p = polygon.get(i);
            Point q = polygon.get((i + 1) % polygon.size());
            double a = inward.dot(Vector.subtract(p, start));
            double b = inward.dot(Vector.subtract(q, start));
            if (a >= 0) {
                left.add(p);
            }
            if (a >= 0 != b >= 0) {
                left.add(Point.add(p, Vector.scale(Vector.subtract(q, p), a / (a - b))));
            }
        }
        return left;
    }

    private static double area(List<Point> polygon) {
        Vector sum = new Vector();
        for (int i = 2; i < polygon.size(); i++) {
            sum.add(Vector.cross(Vector.subtract(polygon.get(i - 1), polygon.get(0)), Vector.subtract(polygon.get(i), polygon.get(0))));
        }
        return sum.norm() / 2;
    }

    private static Point middle(List<Point> polygon) {
        Vector sum = new Vector();
        double rounding = 0;
        for (Point p : polygon) {
            sum.add(new Vector(p));
            rounding += ROUNDINGS * (Math.abs(p.x) + Math.abs(p.y) + Math.abs(p.z));
        }
        sum.scale(1.0 / polygon.size());
        return new Point(Math.abs(sum.x) < rounding ? 0 : sum.x, Math.abs(sum.y) < rounding ? 0 : sum.y,
            Math.abs(sum.z) < rounding ? 0 : sum.z);
    }
}
