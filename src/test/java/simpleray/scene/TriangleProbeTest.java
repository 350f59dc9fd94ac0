package simpleray.scene;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import simpleray.math.Point;
import simpleray.math.Vector;

/** One triangle after the other, each tried by the probe alone. */
class TriangleProbeTest {
    private static final long SEED = 2013;
    private static final double NEAR = 1e-9;
    private static final double[] CORNER = {0, 0, 5, 4, 0, 5, 0, 4, 5};       // in the plane z = 5

    private final TriangleProbe probe = new TriangleProbe();

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

            probe.start(origin.x, origin.y, origin.z, direction.x, direction.y, direction.z);
            look(v, i);

            if (least < 0 || t < 0) {
                assertThat(probe.triangle).as("triangle %d", i).isEqualTo(-1);
                assertThat(probe.t).isInfinite();
            } else {
                hits++;
                assertThat(probe.triangle).isEqualTo(i);
                assertThat(probe.t).isCloseTo(t, within(NEAR * (1 + t)));
                double sum = probe.weights[0] + probe.weights[1] + probe.weights[2];
                assertThat(probe.weights[1] / sum).isCloseTo(toB, within(NEAR / Math.abs(area)));
                assertThat(probe.weights[2] / sum).isCloseTo(toC, within(NEAR / Math.abs(area)));
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
        int[][] orders = {{0, 3, 6}, {3, 6, 0}, {6, 0, 3}, {6, 3, 0}, {3, 0, 6}, {0, 6, 3}};
        for (int[] order : orders) {
            for (double[] at : in) {
                probe.start(at[0], at[1], 5 - 2 * direction, 0, 0, direction);
                probe.look(CORNER, order[0], order[1], order[2], 7);
                assertThat(probe.triangle).as("at %s, %s", at[0], at[1]).isEqualTo(7);
                assertThat(probe.t).isEqualTo(2);
            }
            for (double[] at : out) {
                probe.start(at[0], at[1], 5 - 2 * direction, 0, 0, direction);
                probe.look(CORNER, order[0], order[1], order[2], 7);
                assertThat(probe.triangle).as("at %s, %s", at[0], at[1]).isEqualTo(-1);
            }
        }
    }

    @Test
    void ofTwoAtTheSameTTheLowerNumberIsHit() {
        probe.start(1, 1, 0, 0, 0, 1);
        look(CORNER, 7);
        look(CORNER, 9);
        assertThat(probe.triangle).isEqualTo(7);
        probe.look(CORNER, 6, 0, 3, 4);
        assertThat(probe.triangle).isEqualTo(4);
        assertThat(probe.t).isEqualTo(5);
    }

    @Test
    void aNearerOneIsHitAndAFartherOneIsNot() {
        double[] farther = {0, 0, 6, 4, 0, 6, 0, 4, 6};
        double[] nearer = {0, 0, 4, 4, 0, 4, 0, 4, 4};
        probe.start(1, 1, 0, 0, 0, 1);
        look(CORNER, 1);
        look(farther, 0);
        assertThat(probe.triangle).isEqualTo(1);
        look(nearer, 2);
        assertThat(probe.triangle).isEqualTo(2);
        assertThat(probe.t).isEqualTo(4);
    }

    /** A hit at the threshold, or behind the origin, is none. */
    @Test
    void aHitIsBeyondTheThreshold() {
        double[] atOnce = {0, 0, Object.THRESHOLD, 4, 0, Object.THRESHOLD, 0, 4, Object.THRESHOLD};
        probe.start(1, 1, 0, 0, 0, 1);
        look(atOnce, 1);
        assertThat(probe.triangle).isEqualTo(-1);
        probe.start(1, 1, 0, 0, 0, 0.5);
        look(atOnce, 1);
        assertThat(probe.triangle).isEqualTo(1);
        probe.start(1, 1, 6, 0, 0, 1);
        look(CORNER, 1);
        assertThat(probe.triangle).isEqualTo(-1);
    }

    /** In the plane of a triangle there is no single hit. */
    @Test
    void aRayInThePlaneHitsNothing() {
        probe.start(-1, 1, 5, 1, 0, 0);
        look(CORNER, 1);
        assertThat(probe.triangle).isEqualTo(-1);
    }

    /** Tries a triangle whose corners stand in this order. */
    private void look(double[] corners, int number) {
        probe.look(corners, 0, 3, 6, number);
    }

    private static Point point(double[] from, int at) {
        return new Point(from[at], from[at + 1], from[at + 2]);
    }
}
