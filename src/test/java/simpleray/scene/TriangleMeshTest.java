package simpleray.scene;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.fail;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import simpleray.math.Point;
import simpleray.math.Ray;
import simpleray.math.Vector;

/** The tree finds what the plain loop over all triangles finds, at any scale, and lets no ray through a closed surface. */
class TriangleMeshTest {
    private static final long SEED = 2013;
    private static final int RAYS = 100_000;

    @Tag("slow")
    @Test
    void theTreeFindsTheSameTriangleAtTheSameTAsThePlainLoop() {
        Random random = new Random(SEED);
        int hits = 0;
        for (int scene = 0; scene < 10; scene++) {
            Triangles triangles = scene % 2 == 0 ? soup(random, 20 + 40 * scene) : icosphere(2);
            TriangleMesh mesh = new TriangleMesh(triangles);
            for (int i = 0; i < RAYS / 10; i++) {
                hits += compared(mesh, ray(random, triangles), "scene " + scene + ", ray " + i);
            }
        }
        assertThat(hits).as("enough of them hit").isGreaterThan(RAYS / 4);
    }

    /** Coordinates from 1e-30 to 1e30, about the origin or far from it, rays from near and from far away. */
    @ParameterizedTest
    @ValueSource(doubles = {1e-30, 1e-12, 1e-3, 1e3, 1e12, 1e30})
    void soItDoesAtAnyScale(double scale) {
        Random random = new Random(SEED);
        int hits = 0;
        for (int scene = 0; scene < 8; scene++) {
            double[] away = {0, 0, 0};
            if (scene % 2 == 1) {
                away = random.doubles(3, -1e4 * scale, 1e4 * scale).toArray();
            }
            Triangles unit = scene % 4 < 2 ? soup(random, 100) : icosphere(2);
            Triangles triangles = moved(unit, scale, away);
            TriangleMesh mesh = new TriangleMesh(triangles);
            for (int i = 0; i < 1000; i++) {
                double[] ray = ray(random, unit);
                double farther = i % 5 == 0 ? Math.pow(10, random.nextInt(10)) : 1;
                for (int axis = 0; axis < 3; axis++) {
                    ray[axis] = (ray[axis] - farther * ray[axis + 3]) * scale + away[axis];
                    ray[axis + 3] *= scale;
                }
                hits += compared(mesh, ray, "seed " + SEED + ", scene " + scene + ", ray " + i);
            }
        }
        assertThat(hits).as("enough of them hit").isGreaterThan(1000);
    }

    /** Such a ray sees triangles as lines, and rounding decides what it hits: but nothing that lies far from it. */
    @Test
    void soItDoesForRaysWithinThePlaneOfTheTriangles() {
        Random random = new Random(SEED);
        for (int scene = 0; scene < 20; scene++) {
            double[] u = random.doubles(3, -1, 1).toArray();
            double[] v = random.doubles(3, -1, 1).toArray();
            double[] corners = new double[9 * 100];
            for (int corner = 0; corner < 300; corner++) {
                double alongU = 10 * random.nextDouble();
                double alongV = 10 * random.nextDouble();
                for (int axis = 0; axis < 3; axis++) {
                    int first = corner - corner % 3;
                    corners[3 * corner + axis] = corner == first ? alongU * u[axis] + alongV * v[axis]
                        : corners[3 * first + axis] + alongU / 10 * u[axis] + alongV / 10 * v[axis];
                }
            }
            TriangleMesh mesh = new TriangleMesh(new Triangles(corners, IntStream.range(0, 300).toArray(), new double[0], null));
            for (int i = 0; i < 500; i++) {
                double[] ray = new double[6];
                double fromU = 20 * random.nextDouble() - 5;
                double alongU = random.nextGaussian();
                double alongV = random.nextGaussian();
                for (int axis = 0; axis < 3; axis++) {
                    ray[axis] = fromU * u[axis] - 5 * v[axis];
                    ray[axis + 3] = alongU * u[axis] + alongV * v[axis];
                }
                compared(mesh, ray, "seed " + SEED + ", scene " + scene + ", ray " + i);
            }
        }
    }

    /** Compares the tree with the loop; returns 1 if the ray hits, else 0. */
    private static int compared(TriangleMesh mesh, double[] ray, String where) {
        Triangles triangles = mesh.triangles;
        TriangleIntersector walked = new TriangleIntersector();
        walked.start(mesh, ray[0], ray[1], ray[2], ray[3], ray[4], ray[5]);
        TriangleIntersector looped = new TriangleIntersector();
        looped.start(mesh, ray[0], ray[1], ray[2], ray[3], ray[4], ray[5]);
        double t = Double.POSITIVE_INFINITY;
        int nearest = TriangleIntersector.NONE;
        for (int n = 0; n < triangles.count(); n++) {
            double found = looped.test(n);
            if (found >= 0 && found < t) {
                t = found;
                nearest = n;
            }
        }
        boolean hit = walked.closest(Double.POSITIVE_INFINITY);
        if (hit != (t < Double.POSITIVE_INFINITY) || walked.triangle != nearest
            || Double.doubleToLongBits(walked.t) != Double.doubleToLongBits(t)) {
            fail("%s: the tree finds triangle %d at %s, the loop %d at %s".formatted(where, walked.triangle, walked.t, nearest, t));
        }
        if (hit) {
            looped.test(nearest);
            assertThat(new double[] {walked.weightA, walked.weightB, walked.weightC}).as(where)
                .containsExactly(looped.weightA, looped.weightB, looped.weightC);
        }
        assertThat(walked.occluded(t)).as(where + ": before the nearest").isFalse();
        assertThat(walked.occluded(Math.nextUp(t))).as(where + ": up to the nearest").isEqualTo(hit);
        return hit ? 1 : 0;
    }

    /** From the middle a ray must hit, wherever it goes: to a vertex, to a place on an edge, anywhere. */
    @Tag("slow")
    @ParameterizedTest
    @ValueSource(doubles = {1e-3, 1, 1e4})
    void noRayEscapesFromAnIcosphere(double scale) {
        Triangles triangles = icosphere(3);
        Mesh mesh = new Mesh(new Material(), "x", new Point(0.1, -0.2, 0.3), scale, triangles);
        double[] v = triangles.vertices();
        int[] c = triangles.corners();
        Random random = new Random(SEED);
        Point[] inside = {new Point(0.1, -0.2, 0.3), new Point(0.1 + 0.4 * scale, -0.2 + 0.3 * scale, 0.3 - 0.5 * scale)};
        for (int i = 0; i < c.length; i++) {
            int a = 3 * c[i];
            int b = 3 * c[i % 3 == 2 ? i - 2 : i + 1];
            for (double along : new double[] {0, 0.5, random.nextDouble()}) {
                double[] to = new double[3];
                for (int axis = 0; axis < 3; axis++) {
                    to[axis] = (v[a + axis] + along * (v[b + axis] - v[a + axis])) * scale;
                }
                for (Point from : inside) {
                    Vector direction = new Vector(to[0] + 0.1 - from.x, to[1] - 0.2 - from.y, to[2] + 0.3 - from.z);
                    assertThat(mesh.intersect(new Ray(from, direction))).isBetween(0.9, 1.1);
                    direction.normalise();
                    assertThat(mesh.intersect(new Ray(from, direction))).isPositive();
                }
            }
        }
    }

    @Test
    void raysAlongTheAxesThroughVerticesOfAGridHit() {
        int n = 20;
        double[] v = new double[3 * (n + 1) * (n + 1)];
        int[] c = new int[6 * n * n];
        for (int i = 0; i <= n; i++) {
            for (int j = 0; j <= n; j++) {
                v[3 * (i * (n + 1) + j)] = i / 10f;
                v[3 * (i * (n + 1) + j) + 1] = j / 10f;
            }
        }
        int at = 0;
        for (int i = 0; i < n; i++) {
            for (int j = 0; j < n; j++) {
                int a = i * (n + 1) + j;
                for (int corner : new int[] {a, a + n + 1, a + n + 2, a, a + n + 2, a + 1}) {
                    c[at++] = corner;
                }
            }
        }
        Mesh mesh = new Mesh(new Material(), "x", new Point(), 1, new Triangles(v, c, new double[0], null));
        for (int i = 0; i < v.length; i += 3) {
            assertThat(mesh.intersect(Scenes.ray(v[i], v[i + 1], 3, 0, 0, -1))).isEqualTo(3);
            assertThat(mesh.intersect(Scenes.ray(v[i], v[i + 1], -3, -0.0, -0.0, 1))).isEqualTo(3);
        }
    }

    @Test
    void manyTrianglesInOnePlaceAndInEverSmallerOnesMakeATreeOfBoundedDepth() {
        double[] v = new double[9 * 2000];
        int[] c = new int[3 * 2000];
        for (int i = 0; i < 2000; i++) {
            double size = i < 1000 ? 1 : Math.scalb(1.0, -(i - 1000));
            v[9 * i] = size;
            v[9 * i + 4] = size;
            v[9 * i + 8] = size;
            c[3 * i] = 3 * i;
            c[3 * i + 1] = 3 * i + 1;
            c[3 * i + 2] = 3 * i + 2;
        }
        TriangleIntersector triangles = new TriangleIntersector();
        triangles.start(new TriangleMesh(new Triangles(v, c, new double[0], null)), 1, 1, 1, -1, -1, -1);
        assertThat(triangles.closest(Double.POSITIVE_INFINITY)).isTrue();
        assertThat(triangles.triangle).isZero();
    }

    @Test
    void theTreeIsTheSameOnOneThreadAndOnSeveral() {
        Triangles triangles = soup(new Random(SEED), 40_000);
        TriangleMesh.Tree one = new TriangleMesh(triangles).tree(1);
        TriangleMesh.Tree several = new TriangleMesh(triangles).tree(4);

        assertThat(Arrays.equals(several.order(), one.order())).isTrue();
        assertThat(Arrays.equals(several.corners(), one.corners())).isTrue();
    }

    @Test
    void theTreeIsBuiltOnce() {
        TriangleMesh mesh = new TriangleMesh(icosphere(0));
        TriangleMesh.Tree tree = mesh.tree(2);

        assertThat(mesh.tree()).isSameAs(tree);
        assertThat(mesh.tree(1)).isSameAs(tree);
    }

    @Test
    void theCornersAreThoseOfTheTrianglesInTheOrderOfTheLeaves() {
        Triangles triangles = icosphere(1);
        TriangleMesh.Tree tree = new TriangleMesh(triangles).tree();

        boolean[] seen = new boolean[triangles.count()];
        for (int i = 0; i < seen.length; i++) {
            int triangle = tree.order()[i];
            assertThat(seen[triangle]).isFalse();
            seen[triangle] = true;
            for (int corner = 0; corner < 3; corner++) {
                assertThat(tree.corners()[3 * i + corner]).isEqualTo(3 * triangles.corners()[3 * triangle + corner]);
            }
        }
    }

    @Test
    void ofNoTriangleThereIsNoTreeAndNoHit() {
        TriangleMesh none = new TriangleMesh(Triangles.NONE);
        TriangleIntersector triangles = new TriangleIntersector();
        triangles.start(none, 0, 0, 0, 1, 0, 0);

        assertThat(none.tree().bvh()).isNull();
        assertThat(triangles.closest(Double.POSITIVE_INFINITY)).isFalse();
        assertThat(triangles.occluded(Double.POSITIVE_INFINITY)).isFalse();
    }

    /** {@return a ray's origin and direction} */
    private static double[] ray(Random random, Triangles triangles) {
        double[] to = {random.nextGaussian() / 2, random.nextGaussian() / 2, random.nextGaussian() / 2};
        if (random.nextInt(4) == 0) {                         // exactly to a vertex
            System.arraycopy(triangles.vertices(), 3 * random.nextInt(triangles.vertices().length / 3), to, 0, 3);
        }
        double distance = random.nextInt(3) == 0 ? 100 : 2;
        double x = distance * random.nextGaussian();
        double y = distance * random.nextGaussian();
        double z = distance * random.nextGaussian();
        return random.nextInt(8) == 0 ? new double[] {to[0], to[1], z, 0, 0, random.nextBoolean() ? 1 : -1}   // along an axis
            : new double[] {x, y, z, to[0] - x, to[1] - y, to[2] - z};
    }

    private static Triangles moved(Triangles triangles, double scale, double[] by) {
        double[] v = triangles.vertices().clone();
        for (int i = 0; i < v.length; i++) {
            v[i] = v[i] * scale + by[i % 3];
        }
        return new Triangles(v, triangles.corners(), triangles.normals(), triangles.cornerNormals());
    }

    private static Triangles soup(Random random, int count) {
        double[] v = new double[9 * count];
        int[] c = new int[3 * count];
        for (int i = 0; i < v.length; i++) {
            v[i] = (float) (i % 9 < 3 ? random.nextGaussian() : v[i - 3] + random.nextGaussian() / 3);
        }
        for (int i = 0; i < c.length; i++) {
            c[i] = i;
        }
        return new Triangles(v, c, new double[0], null);
    }

    /** {@return the unit sphere: an icosahedron whose triangles are cut in four, that many times} */
    private static Triangles icosphere(int cuts) {
        double g = (1 + Math.sqrt(5)) / 2;
        List<double[]> points = new ArrayList<>();
        for (int i = 0; i < 12; i++) {
            double one = i % 2 == 0 ? 1 : -1;
            double golden = i / 2 % 2 == 0 ? g : -g;
            add(points, i < 4 ? new double[] {one, golden, 0} : i < 8 ? new double[] {0, one, golden} : new double[] {golden, 0, one});
        }
        // the faces are the triples of neighbours; an icosahedron's edge between these points is 2 long, scaled
        double edge = 2 / Math.sqrt(1 + g * g) + 1e-5;
        List<int[]> faces = new ArrayList<>();
        for (int a = 0; a < 12; a++) {
            for (int b = a + 1; b < 12; b++) {
                for (int c = b + 1; c < 12; c++) {
                    if (distance(points, a, b) < edge && distance(points, b, c) < edge && distance(points, c, a) < edge) {
                        faces.add(new int[] {a, b, c});
                    }
                }
            }
        }
        for (int cut = 0; cut < cuts; cut++) {
            Map<Long, Integer> middles = new HashMap<>();
            List<int[]> smaller = new ArrayList<>();
            for (int[] f : faces) {
                int ab = middle(points, middles, f[0], f[1]);
                int bc = middle(points, middles, f[1], f[2]);
                int ca = middle(points, middles, f[2], f[0]);
                smaller.addAll(List.of(new int[] {f[0], ab, ca}, new int[] {ab, f[1], bc}, new int[] {ca, bc, f[2]},
                    new int[] {ab, bc, ca}));
            }
            faces = smaller;
        }
        return new Triangles(points.stream().flatMapToDouble(Arrays::stream).toArray(),
            faces.stream().flatMapToInt(Arrays::stream).toArray(), new double[0], null);
    }

    private static int middle(List<double[]> points, Map<Long, Integer> middles, int a, int b) {
        return middles.computeIfAbsent((long) Math.min(a, b) << 32 | Math.max(a, b), key -> {
            double[] p = points.get(a);
            double[] q = points.get(b);
            add(points, new double[] {p[0] + q[0], p[1] + q[1], p[2] + q[2]});
            return points.size() - 1;
        });
    }

    private static void add(List<double[]> points, double[] p) {
        double length = Math.sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]);
        points.add(new double[] {(float) (p[0] / length), (float) (p[1] / length), (float) (p[2] / length)});
    }

    private static double distance(List<double[]> points, int a, int b) {
        double[] p = points.get(a);
        double[] q = points.get(b);
        return Math.sqrt((p[0] - q[0]) * (p[0] - q[0]) + (p[1] - q[1]) * (p[1] - q[1]) + (p[2] - q[2]) * (p[2] - q[2]));
    }
}
