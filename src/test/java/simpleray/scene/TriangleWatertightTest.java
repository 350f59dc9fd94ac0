package simpleray.scene;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.Collections;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Random;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import simpleray.math.Point;
import simpleray.math.Ray;
import simpleray.math.Vector;

/** Closed surfaces of triangles, and rays that aim at the seams. */
class TriangleWatertightTest {
    private static final long SEED = 20130228;
    private static final int RAYS = 200_000;
    /** How far from the point aimed at a hit may be, in radii: rays come from up to 20 radii away. */
    private static final double NEAR = 1e-12;

    private final Random random = new Random(SEED);
    private final List<Point> corners = new ArrayList<>();
    private List<int[]> faces = new ArrayList<>();

    @Tag("slow")
    @ParameterizedTest
    @ValueSource(doubles = {1e-3, 1, 1e4})
    void noRaySlipsBetweenTheTrianglesOfASphere(double radius) {
        icosahedron();
        divide();
        shoot(radius);
    }

    @ParameterizedTest
    @ValueSource(doubles = {1e-3, 1, 1e4})
    void norThroughTheEdgesOfATetrahedron(double radius) {
        corners.addAll(List.of(onSphere(1, 1, 1), onSphere(1, -1, -1), onSphere(-1, 1, -1), onSphere(-1, -1, 1)));
        faces.addAll(List.of(new int[] {0, 1, 2}, new int[] {0, 2, 3}, new int[] {0, 3, 1}, new int[] {1, 3, 2}));
        shoot(radius);
    }

    /** Rays from outside through a point of an edge or a vertex to the inside, and on: each hits at that point, and again beyond. */
    private void shoot(double radius) {
        corners.forEach(p -> p.set(p.x * radius, p.y * radius, p.z * radius));
        Object[] triangles = triangles();
        int passed = 0;
        for (int i = 0; i < RAYS; i++) {
            int[] face = faces.get(random.nextInt(faces.size()));
            Point from = corners.get(face[0]);
            Point aim = new Point(from);
            if (i % 4 != 0) {                                 // else the vertex itself
                aim.add(Vector.scale(Vector.subtract(corners.get(face[1]), from), random.nextDouble()));
            }
            Vector direction = Vector.subtract(inside(radius), aim);
            direction.normalise();
            direction.scale(i % 2 == 0 ? 1 : 0.1 + random.nextDouble());
            double back = (0.5 + 20 * random.nextDouble()) * radius / direction.norm();
            Ray ray = new Ray(Point.add(aim, Vector.scale(direction, -back)), direction);
            if (!hitsAt(triangles, ray, back, NEAR * radius / direction.norm()) || !hitsBeyond(triangles, new Ray(aim, direction))) {
                passed++;
            }
        }
        assertThat(passed).as("rays that slip through, seed " + SEED).isZero();
    }

    private static boolean hitsAt(Object[] triangles, Ray ray, double where, double tolerance) {
        for (Object triangle : triangles) {
            double t = triangle.intersect(ray);
            if (Math.abs(t - where) <= tolerance) {
                return true;
            }
        }
        return false;
    }

    private static boolean hitsBeyond(Object[] triangles, Ray ray) {
        for (Object triangle : triangles) {
            if (triangle.intersect(ray) > Object.THRESHOLD) {
                return true;
            }
        }
        return false;
    }

    /** {@return the faces as triangles whose vertices stand in any order} */
    private Object[] triangles() {
        Material material = new Material();
        return faces.stream().map(face -> {
            List<Point> order = new ArrayList<>(List.of(corners.get(face[0]), corners.get(face[1]), corners.get(face[2])));
            Collections.shuffle(order, random);
            return new Triangle(material, order.get(0), order.get(1), order.get(2));
        }).toArray(Object[]::new);
    }

    /** {@return a point well inside, also of a tetrahedron, whose faces are a third of a radius from its middle} */
    private Point inside(double radius) {
        return new Point((random.nextDouble() - 0.5) * 0.3 * radius, (random.nextDouble() - 0.5) * 0.3 * radius,
            (random.nextDouble() - 0.5) * 0.3 * radius);
    }

    private void icosahedron() {
        double golden = (1 + Math.sqrt(5)) / 2;
        for (int i = 0; i < 4; i++) {
            double one = (i & 1) == 0 ? 1 : -1;
            double other = (i & 2) == 0 ? golden : -golden;
            corners.addAll(List.of(onSphere(one, other, 0), onSphere(0, one, other), onSphere(other, 0, one)));
        }
        double edge = Vector.subtract(corners.get(0), corners.get(3)).norm() * 1.1;
        for (int i = 0; i < corners.size(); i++) {
            for (int j = 0; j < i; j++) {
                for (int k = 0; k < j; k++) {
                    if (distance(i, j) < edge && distance(j, k) < edge && distance(k, i) < edge) {
                        faces.add(new int[] {i, j, k});
                    }
                }
            }
        }
        assertThat(faces).hasSize(20);
    }

    private double distance(int i, int j) {
        return Vector.subtract(corners.get(i), corners.get(j)).norm();
    }

    /** Divides each face into four. */
    private void divide() {
        Map<Integer, Integer> middles = new HashMap<>();
        List<int[]> smaller = new ArrayList<>();
        for (int[] face : faces) {
            int p = middle(middles, face[0], face[1]);
            int q = middle(middles, face[1], face[2]);
            int r = middle(middles, face[2], face[0]);
            smaller.addAll(List.of(new int[] {face[0], p, r}, new int[] {face[1], q, p}, new int[] {face[2], r, q}, new int[] {p, q, r}));
        }
        faces = smaller;
    }

    private int middle(Map<Integer, Integer> middles, int i, int j) {
        return middles.computeIfAbsent(Math.min(i, j) * 1000 + Math.max(i, j), key -> {
            Point p = corners.get(i);
            Point q = corners.get(j);
            corners.add(onSphere(p.x + q.x, p.y + q.y, p.z + q.z));
            return corners.size() - 1;
        });
    }

    private static Point onSphere(double x, double y, double z) {
        Vector unit = new Vector(x, y, z).normalised();
        return new Point(unit.x, unit.y, unit.z);
    }
}
