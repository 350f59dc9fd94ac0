package simpleray.scene;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import simpleray.math.Point;
import simpleray.math.Vector;

/** Where rays go on from, and in which direction. */
class OpticsTest {
    private static final double ROUNDING = 1e-15;
    private static final Vector NORMAL = new Vector(0.6, 0, 0.8);

    @Test
    void aShadowRayEndsBeforeTheLightByMoreThanItsRoundings() {
        assertThat(Optics.margin(new Point(1, 2, 3), 4)).isEqualTo(Object.THRESHOLD);
        assertThat(Optics.margin(new Point(1, 2, 3), Double.POSITIVE_INFINITY)).isZero();
        assertThat(Optics.margin(new Point(-0x1p40, 2, 3), 4)).isEqualTo(1);
        assertThat(Optics.margin(new Point(1, -0x1p41, 3), 4)).isEqualTo(2);
        assertThat(Optics.margin(new Point(1, 2, -0x1p42), 4)).isEqualTo(4);
        assertThat(Optics.margin(new Point(1, 2, 3), 0x1p43)).isEqualTo(8);
    }

    @Test
    void theMirrorDirectionLeavesAtTheAngleAtWhichTheRayCame() {
        Vector mirror = new Vector();
        Optics.mirror(mirror, new Vector(0.6, 0, -0.8), new Vector(0, 0, 1));

        assertThat(mirror).hasToString("[0.6,0.0,0.8]");
    }

    /** Sines of 0.6 outside and 0.3 inside glass of index 2. */
    @Test
    void theBentDirectionHasLengthOneAndTheSinesOfSnell() {
        Vector bent = new Vector();

        assertThat(Optics.refract(bent, new Vector(0.36, 0.48, -0.8), new Vector(0, 0, 1), 0.5)).isTrue();
        assertThat(bent.x).isEqualTo(0.18, within(ROUNDING));
        assertThat(bent.y).isEqualTo(0.24, within(ROUNDING));
        assertThat(bent.z).isEqualTo(-Math.sqrt(1 - 0.09), within(ROUNDING));
    }

    @Test
    void atTheCriticalAngleTheRayRunsAlongTheSurface() {
        Vector bent = new Vector();

        assertThat(Optics.refract(bent, new Vector(0, 1, 0), new Vector(0, 0, 1), 1)).isTrue();
        assertThat(bent.y).isEqualTo(1);
        assertThat(bent.z).isZero();
    }

    @ParameterizedTest
    @CsvSource({"10000, 0, 0, 1", "0, -10000, 0, 1", "0, 0, 1e4, 10000", "Infinity, 0, 0, 1", "0, 0, 0, Infinity", "NaN, 0, 0, 1"})
    void upToTenThousandAndWhereNothingIsKnownAPointStays(double x, double y, double z, double t) {
        Point point = new Point(x, y, z);

        assertThat(Optics.lift(point, NORMAL, t)).isZero();
        assertThat(point).hasToString(new Point(x, y, z).toString());
    }

    @ParameterizedTest
    @CsvSource({"32768, 0, 0, 1", "-32768, 5, 5, 1", "0, 32768, 0, 0", "0, -32768, 1, 0", "1, 2, 32768, 0", "0, 0, -32768, 0",
        "1, 2, 3, 32768"})
    void farOutItIsLiftedByAShareOfTheLargestNumber(double x, double y, double z, double t) {
        Point point = new Point(x, y, z);
        double height = Math.scalb(1.0, 15 - 48);

        assertThat(Optics.lift(point, NORMAL, t)).isEqualTo(height);
        assertThat(point.x).isEqualTo(x + height * 0.6);
        assertThat(point.y).isEqualTo(y);
        assertThat(point.z).isEqualTo(z + height * 0.8);
    }

    @ParameterizedTest
    @ValueSource(doubles = {10_001, 1e6, 1e12})
    void whatGoesOnThroughASurfaceBeginsAsFarBelowItAsTheRestAbove(double size) {
        Point point = new Point(size, 1, -2);
        double height = Optics.lift(point, new Vector(0, 0.6, 0.8), 5);

        Point below = new Point(point);
        Optics.sink(below, new Vector(0, 0.6, 0.8), height);

        assertThat(height).isPositive();
        assertThat(below.x).isEqualTo(size);
        assertThat(below.y).isEqualTo(1 - height * 0.6, within(1e-15 * (1 + height)));
        assertThat(below.z).isEqualTo(-2 - height * 0.8, within(1e-15 * (1 + height)));
        assertThat(point.y).isGreaterThan(1);
    }

    @Test
    void aPointIsSunkAlongEachAxis() {
        Point point = new Point(1, 2, 3);
        Optics.sink(point, new Vector(0.5, 0.25, -1), 2);
        assertThat(point).hasToString("[-1.0,1.0,7.0]");

        Optics.sink(point, new Vector(0.5, 0.25, -1), 0);
        assertThat(point).hasToString("[-1.0,1.0,7.0]");
    }
}
