package simpleray.scene;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static simpleray.scene.Scenes.ray;

import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import simpleray.math.Bounds;
import simpleray.math.Point;
import simpleray.math.Vector;

class TriangleTest {
    /** A few roundings of numbers near 1. */
    private static final double ROUNDING = 1e-15;
    private static final long SEED = 2013;

    /** Under the line x + y = 1, at z = 0. */
    private final Triangle half = new Triangle();

    @Test
    void aNewTriangleIsHalfTheUnitSquare() {
        assertThat(half.a).hasToString("[0.0,0.0,0.0]");
        assertThat(half.b).hasToString("[1.0,0.0,0.0]");
        assertThat(half.c).hasToString("[0.0,1.0,0.0]");
        assertThat(half.surfaceMaterial).isNotNull();
    }

    @Test
    void aTriangleKeepsWhatItIsMadeOfAndCopiesNothing() {
        Material material = new Material();
        Point[] p = {new Point(1, 2, 3), new Point(4, 5, 6), new Point(7, 8, 10)};
        Triangle triangle = new Triangle(material, p[0], p[1], p[2]);

        assertThat(triangle.surfaceMaterial).isSameAs(material);
        assertThat(triangle.a).isSameAs(p[0]);
        assertThat(triangle.b).isSameAs(p[1]);
        assertThat(triangle.c).isSameAs(p[2]);
    }

    @Test
    void rayFromTheFrontHits() {
        assertThat(half.intersect(ray(0.25, 0.25, 5, 0, 0, -1))).isEqualTo(5);
    }

    @Test
    void rayFromBehindTheTriangleHitsToo() {
        assertThat(half.intersect(ray(0.25, 0.25, -5, 0, 0, 1))).isEqualTo(5);
    }

    @Test
    void theOrderOfTheVerticesDoesNotMatter() {
        Point[] p = {new Point(), new Point(1, 0, 0), new Point(0, 1, 0)};
        int[][] orders = {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}};
        for (int[] order : orders) {
            Triangle triangle = new Triangle(new Material(), p[order[0]], p[order[1]], p[order[2]]);
            assertThat(triangle.intersect(ray(0.25, 0.5, 5, 0, 0, -1))).isEqualTo(5);
            assertThat(triangle.intersect(ray(0.75, 0.5, 5, 0, 0, -1))).isEqualTo(Object.MISS);
        }
    }

    @Test
    void slantedRayHitsFurtherAway() {
        // 4 down at 0.8 a step, and 3 aside to (0.25, 0.25)
        assertThat(half.intersect(ray(-2.75, 0.25, 4, 0.6, 0, -0.8))).isEqualTo(5, within(5 * ROUNDING));
    }

    @Test
    void aTriangleAcrossEachAxisIsHit() {
        // x = 2, y = 2, z = 2 at 1 of each; the rays come along that axis, from either side
        Triangle acrossX = new Triangle(new Material(), new Point(2, 0, 0), new Point(2, 3, 0), new Point(2, 0, 3));
        assertThat(acrossX.intersect(ray(5, 1, 1, -1, 0, 0))).isEqualTo(3);
        assertThat(acrossX.intersect(ray(-5, 1, 1, 1, 0, 0))).isEqualTo(7);
        assertThat(acrossX.intersect(ray(-5, 2, 2, 1, 0, 0))).isEqualTo(Object.MISS);
        Triangle acrossY = new Triangle(new Material(), new Point(0, 2, 0), new Point(3, 2, 0), new Point(0, 2, 3));
        assertThat(acrossY.intersect(ray(1, 5, 1, 0, -1, 0))).isEqualTo(3);
        assertThat(acrossY.intersect(ray(1, -5, 1, 0, 1, 0))).isEqualTo(7);
        assertThat(acrossY.intersect(ray(2, -5, 2, 0, 1, 0))).isEqualTo(Object.MISS);
    }

    @Test
    void aSlantedTriangleIsWhereItsPlaneIs() {
        // x + y + z = 3 holds at (1,1,1), its middle; from there 5 back along (0.6,0,0.8)
        Triangle triangle = new Triangle(new Material(), new Point(3, 0, 0), new Point(0, 3, 0), new Point(0, 0, 3));
        assertThat(triangle.intersect(ray(1 - 3, 1, 1 - 4, 0.6, 0, 0.8))).isEqualTo(5, within(5 * ROUNDING));
    }

    @Test
    void rayPastAnyEdgeMisses() {
        assertThat(half.intersect(ray(-0.001, 0.25, 5, 0, 0, -1))).isEqualTo(Object.MISS);
        assertThat(half.intersect(ray(0.25, -0.001, 5, 0, 0, -1))).isEqualTo(Object.MISS);
        assertThat(half.intersect(ray(0.501, 0.501, 5, 0, 0, -1))).isEqualTo(Object.MISS);
        assertThat(half.intersect(ray(1.001, 0, 5, 0, 0, -1))).isEqualTo(Object.MISS);
    }

    @Test
    void rayThroughAnEdgeHits() {
        assertThat(half.intersect(ray(0, 0.25, 5, 0, 0, -1))).isEqualTo(5);
        assertThat(half.intersect(ray(0.25, 0, 5, 0, 0, -1))).isEqualTo(5);
        assertThat(half.intersect(ray(0.5, 0.5, 5, 0, 0, -1))).isEqualTo(5);
    }

    @Test
    void rayThroughAVertexHits() {
        assertThat(half.intersect(ray(0, 0, 5, 0, 0, -1))).isEqualTo(5);
        assertThat(half.intersect(ray(1, 0, 5, 0, 0, -1))).isEqualTo(5);
        assertThat(half.intersect(ray(0, 1, 5, 0, 0, -1))).isEqualTo(5);
    }

    @Test
    void ofTwoTrianglesOnEitherSideOfAnEdgeARayBesideItHitsTheRightOne() {
        // with e = 2^-52, the products (1+e)(1+3e) and (1+2e)(1+2e) differ by e², and are the same double: the ray passes the edge
        // at a distance of e²/2.8, on the side of (1,-1)
        double e = Math.ulp(1.0);
        Point p = new Point(1 + e, 1 + 2 * e, 0);
        Point q = new Point(-1 - 2 * e, -1 - 3 * e, 0);
        assertThat(new Triangle(new Material(), p, q, new Point(1, -1, 0)).intersect(ray(0, 0, 5, 0, 0, -1))).isEqualTo(5);
        assertThat(new Triangle(new Material(), p, q, new Point(-1, 1, 0)).intersect(ray(0, 0, 5, 0, 0, -1))).isEqualTo(Object.MISS);
    }

    @Test
    void rayWithinThePlaneMisses() {
        assertThat(half.intersect(ray(-1, 0.25, 0, 1, 0, 0))).isEqualTo(Object.MISS);
        assertThat(half.intersect(ray(0.25, 0.25, 0, 0.6, 0.8, 0))).as("from inside").isEqualTo(Object.MISS);
        assertThat(half.intersect(ray(-1, 0, 0, 1, 0, 0))).as("along an edge").isEqualTo(Object.MISS);
    }

    @Test
    void rayAlongThePlaneMisses() {
        assertThat(half.intersect(ray(-1, 0.25, 1, 1, 0, 0))).isEqualTo(Object.MISS);
    }

    @Test
    void triangleBehindTheRayIsMissed() {
        assertThat(half.intersect(ray(0.25, 0.25, 5, 0, 0, 1))).isEqualTo(Object.MISS);
        assertThat(half.intersect(ray(0.25, 0.25, -5, 0.1, 0, -1))).isEqualTo(Object.MISS);
    }

    @Test
    void rayFromTheTriangleDoesNotHitIt() {
        assertThat(half.intersect(ray(0.25, 0.25, 0, 0, 0, -1))).isEqualTo(Object.MISS);
        assertThat(half.intersect(ray(0.25, 0.25, 0.9e-7, 0, 0, -1))).isEqualTo(Object.MISS);
        assertThat(half.intersect(ray(0.25, 0.25, 1.1e-7, 0, 0, -1))).isEqualTo(1.1e-7, within(ROUNDING));
    }

    @Test
    void aLongerDirectionCountsFewerOfIts() {
        assertThat(half.intersect(ray(0.25, 0.25, 5, 0, 0, -4))).isEqualTo(1.25);
        assertThat(half.intersect(ray(0.25, 0.25, 5, 0, 0, -0.5))).isEqualTo(10);
        assertThat(half.intersect(ray(-0.25, 0.25, 5, 0, 0, -4))).isEqualTo(Object.MISS);
    }

    @Test
    void aRayThatNeedsInfinitelyLongOrGoesNowhereMisses() {
        assertThat(half.intersect(ray(0.25, 0.25, 1, 0, 0, -Double.MIN_VALUE))).isEqualTo(Object.MISS);
        assertThat(half.intersect(ray(0.25, 0.25, 1, 0, 0, 0))).isEqualTo(Object.MISS);
    }

    @Test
    void theNormalPointsWhereTheVerticesRunCounterClockwise() {
        assertThat(half.normal(new Point(0.25, 0.25, 0))).hasToString("[0.0,0.0,1.0]");
        assertThat(new Triangle(new Material(), half.a, half.c, half.b).normal(new Point(0.25, 0.25, 0))).hasToString("[0.0,0.0,-1.0]");
    }

    @Test
    void theNormalIsAtRightAnglesAndHasLengthOne() {
        // (1,2,2)/3 is at right angles to (0,-3,3) and (-6,3,0)
        Triangle triangle = new Triangle(new Material(), new Point(1, 4, 5), new Point(1, 1, 8), new Point(-5, 7, 5));
        Vector normal = triangle.normal(triangle.a);
        assertThat(normal.x).isEqualTo(-1.0 / 3, within(ROUNDING));
        assertThat(normal.y).isEqualTo(-2.0 / 3, within(ROUNDING));
        assertThat(normal.z).isEqualTo(-2.0 / 3, within(ROUNDING));
    }

    @Test
    void theNormalMayBeChanged() {
        half.normal(half.a).negate();
        assertThat(half.normal(half.a)).hasToString("[0.0,0.0,1.0]");
    }

    @ParameterizedTest
    @ValueSource(doubles = {Double.MIN_VALUE, 1e-320, 1e-200, 1e-100, 1e100, 1e200, Double.MAX_VALUE})
    void theNormalIsRightAtAnyScale(double scale) {
        Triangle triangle = new Triangle(new Material(), new Point(-scale, 0, 0), new Point(scale, 0, 0), new Point(0, 0, scale));
        assertThat(triangle.normal(triangle.a)).hasToString("[0.0,-1.0,0.0]");
    }

    @Test
    void theBoundsHoldTheTriangleAndNoMore() {
        Random random = new Random(SEED);
        Triangle triangle = new Triangle(new Material(), new Point(1, -2, 3), new Point(-4, 5, 6), new Point(7, 8, -9));
        assertThat(triangle.bounds()).isEqualTo(new Bounds(-4, -2, -9, 7, 8, 6));
        for (int i = 0; i < 1000; i++) {
            double s = random.nextDouble();
            double t = random.nextDouble() * (1 - s);
            Point p = Point.add(triangle.a, Vector.scale(Vector.subtract(triangle.b, triangle.a), s));
            p.add(Vector.scale(Vector.subtract(triangle.c, triangle.a), t));
            assertThat(triangle.bounds().contains(p)).as("seed " + SEED + ", " + p).isTrue();
        }
    }

    @Test
    void theBoundsOfATriangleAcrossAnAxisAreFlat() {
        assertThat(half.bounds()).isEqualTo(new Bounds(0, 0, 0, 1, 1, 0));
    }
}
