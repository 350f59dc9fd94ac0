package simpleray.math;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class BoundsTest {
    /** From -1 to 2, from -3 to 4, from -5 to 6. */
    private static final Bounds BOX = new Bounds(-1, -3, -5, 2, 4, 6);

    @ParameterizedTest
    @CsvSource({"-1,-3,-5", "2,4,6", "-1,4,6", "2,-3,-5", "0,0,0", "-1,0,0", "2,0,0", "0,-3,0", "0,4,0", "0,0,-5", "0,0,6"})
    void aBoxContainsItsInsideItsSidesAndItsCorners(double x, double y, double z) {
        assertThat(BOX.contains(new Point(x, y, z))).isTrue();
    }

    @ParameterizedTest
    @CsvSource({"-1.001,0,0", "2.001,0,0", "0,-3.001,0", "0,4.001,0", "0,0,-5.001", "0,0,6.001", "NaN,0,0", "0,NaN,0", "0,0,NaN"})
    void aPointBeyondOneSideIsOutside(double x, double y, double z) {
        assertThat(BOX.contains(new Point(x, y, z))).isFalse();
    }

    @Test
    void theBoxOfPointsReachesFromTheSmallestOfEachToTheLargest() {
        assertThat(Bounds.of(new Point(2, -3, 0), new Point(-1, 4, -5), new Point(0, 0, 6))).isEqualTo(BOX);
    }

    @Test
    void theBoxOfOnePointIsThatPoint() {
        assertThat(Bounds.of(new Point(1, 2, 3))).isEqualTo(new Bounds(1, 2, 3, 1, 2, 3));
    }

    @Test
    void theUnionOfTwoBoxesContainsBothInAnyOrder() {
        Bounds other = new Bounds(-2, 0, -4, 1, 5, 5);
        Bounds both = new Bounds(-2, -3, -5, 2, 5, 6);

        assertThat(BOX.with(other)).isEqualTo(both);
        assertThat(other.with(BOX)).isEqualTo(both);
    }
}
