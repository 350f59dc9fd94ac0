package simpleray.scene;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import java.util.Random;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import simpleray.math.Point;
import simpleray.math.Vector;

/** One triangle, or a few, tried by the intersector alone. */
class TriangleIntersectorTest {
    private static final long SEED = 2013;
    private static final double NEAR = 1e-9;
    private static final double[] CORNER = {0, 0, 5, 4, 0, 5, 0, 4, 5};       // in the plane z = 5
    private static final double[] FARTHER = {0, 0, 6, 4, 0, 6, 0, 4, 6};

    private final TriangleIntersector triangles = new TriangleIntersector();

    /** The determinants of Möller and Trumbore, "Fast, Minimum Storage Ray/Triangle Intersection", 1997, give the same t and weights. */
    @Test
    void tAndWeightsAreThoseOfTheDeterminants() {
        Random random = new Random(SEED);
        int hits = 0;
        for (int i = 0; i < 3000; i++) {
            double[] v = random.doubles(9, -1, 1).toArray();
            Point origin = point(random.doubles(3, -3, 3).toArray(), 0);
            double[] inside = random.doubles(3, -1, 1).toArray();
            Vector direction = Vector.subtract(point(inside, 0), origin);
            direction.scale(0.2 + random.nextDouble());
            Vector ab = Vector.subtract(point(v, 3), point(v, 0));
            Vector ac = Vector.subtract(point(v, 6), point(v, 0));
            Vector ao = Vector.subtract(origin, point(v, 0));
            double area = Vector.dot(Vector.cross(ab, ac), direction);
            double toB = Vector.dot(Vector.cross(ao, ac), direction) / area;
            double toC = Vector.dot(Vector.cross(ab, ao), direction) / area;
            double t = -Vector.dot(Vector.cross(ab, ac), ao) / area;
            double least = Math.min(Math.min(toB, toC), 1 - toB - toC);
            if (Math.abs(least) < NEAR || Math.abs(t) < NEAR || Math.abs(area) < 1e-4) {
                continue;                                     // too close to tell
            }

            triangles.start(mesh(v), origin.x, origin.y, origin.z, direction.x, direction.y, direction.z);

            if (least < 0 || t < 0) {
                assertThat(triangles.test(0)).as("triangle %d", i).isEqualTo(Object.MISS);
            } else {
                hits++;
                assertThat(triangles.test(0)).as("triangle %d", i).isCloseTo(t, within(NEAR * (1 + t)));
                double sum = triangles.weightA + triangles.weightB + triangles.weightC;
                assertThat(triangles.weightB / sum).isCloseTo(toB, within(NEAR / Math.abs(area)));
                assertThat(triangles.weightC / sum).isCloseTo(toC, within(NEAR / Math.abs(area)));
            }
        }
        assertThat(hits).as("enough of them hit").isGreaterThan(200);
    }

    /** Inside, on each edge and at each corner it is hit, from either side and whichever way its corners go around; outside it is not. */
    @ParameterizedTest
    @ValueSource(doubles = {5, -5})
    void edgesAndCornersBelongToATriangle(double direction) {
        double[][] in = {{1, 1}, {2, 0}, {0, 2}, {2, 2}, {0, 0}, {4, 0}, {0, 4}};
        double[][] out = {{-1, 1}, {1, -1}, {3, 3}, {-1, -1}, {5, 0}, {0, 5}, {-1, 0}, {0, -1}, {-1, 5}, {5, -1}};
        int[][] orders = {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}, {1, 0, 2}, {0, 2, 1}};
        for (int[] order : orders) {
            TriangleMesh mesh = new TriangleMesh(new Triangles(CORNER, order, new double[0], null));
            for (double[] at : in) {
                triangles.start(mesh, at[0], at[1], 5 - 2 * direction, 0, 0, direction);
                assertThat(triangles.test(0)).as("at %s, %s", at[0], at[1]).isEqualTo(2);
            }
            for (double[] at : out) {
                triangles.start(mesh, at[0], at[1], 5 - 2 * direction, 0, 0, direction);
                assertThat(triangles.test(0)).as("at %s, %s", at[0], at[1]).isEqualTo(Object.MISS);
            }
        }
    }

    @Test
    void ofTwoAtTheSameTTheLowerNumberIsHit() {
        triangles.start(mesh(FARTHER, CORNER, CORNER), 1, 1, 0, 0, 0, 1);

        assertThat(triangles.closest(Double.POSITIVE_INFINITY)).isTrue();
        assertThat(triangles.triangle).isEqualTo(1);
        assertThat(triangles.t).isEqualTo(5);
    }

    @Test
    void aNearerOneIsHitAndAFartherOneIsNot() {
        double[] nearer = {0, 0, 4, 4, 0, 4, 0, 4, 4};
        triangles.start(mesh(FARTHER, CORNER), 1, 1, 0, 0, 0, 1);
        assertThat(triangles.closest(Double.POSITIVE_INFINITY)).isTrue();
        assertThat(triangles.triangle).isEqualTo(1);

        triangles.start(mesh(FARTHER, CORNER, nearer), 1, 1, 0, 0, 0, 1);
        assertThat(triangles.closest(Double.POSITIVE_INFINITY)).isTrue();
        assertThat(triangles.triangle).isEqualTo(2);
        assertThat(triangles.t).isEqualTo(4);
    }

    /** One at the limit itself is found: it may be of an object that is listed earlier. */
    @Test
    void nothingIsFoundBeyondTheLimit() {
        triangles.start(mesh(CORNER), 1, 1, 0, 0, 0, 1);

        assertThat(triangles.closest(Math.nextDown(5.0))).isFalse();
        assertThat(triangles.triangle).isEqualTo(TriangleIntersector.NONE);
        assertThat(triangles.closest(5)).isTrue();
        assertThat(triangles.triangle).isZero();
    }

    @Test
    void aTriangleOccludesWhatLiesBehindIt() {
        triangles.start(mesh(CORNER, FARTHER), 1, 1, 0, 0, 0, 1);

        assertThat(triangles.occluded(5)).isFalse();
        assertThat(triangles.occluded(Math.nextUp(5.0))).isTrue();
        assertThat(triangles.occluded(Double.POSITIVE_INFINITY)).isTrue();
    }

    /** A hit at the threshold, or behind the origin, is none. */
    @Test
    void aHitIsBeyondTheThreshold() {
        double[] atOnce = {0, 0, Object.THRESHOLD, 4, 0, Object.THRESHOLD, 0, 4, Object.THRESHOLD};
        triangles.start(mesh(atOnce), 1, 1, 0, 0, 0, 1);
        assertThat(triangles.test(0)).isEqualTo(Object.MISS);
        triangles.start(mesh(atOnce), 1, 1, 0, 0, 0, 0.5);
        assertThat(triangles.test(0)).isEqualTo(2 * Object.THRESHOLD);
        triangles.start(mesh(CORNER), 1, 1, 6, 0, 0, 1);
        assertThat(triangles.test(0)).isEqualTo(Object.MISS);
    }

    /** In the plane of a triangle there is no single hit. */
    @Test
    void aRayInThePlaneHitsNothing() {
        triangles.start(mesh(CORNER), -1, 1, 5, 1, 0, 0);
        assertThat(triangles.test(0)).isEqualTo(Object.MISS);
    }

    /** {@return triangles of their own corners each} */
    private static TriangleMesh mesh(double[]... corners) {
        return new TriangleMesh(new Triangles(Arrays.stream(corners).flatMapToDouble(Arrays::stream).toArray(),
            IntStream.range(0, 3 * corners.length).toArray(), new double[0], null));
    }

    private static Point point(double[] from, int at) {
        return new Point(from[at], from[at + 1], from[at + 2]);
    }
}
