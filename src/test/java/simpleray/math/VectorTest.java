package simpleray.math;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

class VectorTest {
    @Test
    void aNewVectorIsZero() {
        assertThat(new Vector()).hasToString("[0.0,0.0,0.0]");
    }

    @Test
    void aVectorIsMadeOfThreeNumbersOrOfAPointOrOfAnother() {
        Vector v = new Vector(1, 2, 3);
        Vector copy = new Vector(v);
        v.x = 9;

        assertThat(v).hasToString("[9.0,2.0,3.0]");
        assertThat(copy).hasToString("[1.0,2.0,3.0]");
        assertThat(new Vector(new Point(4, 5, 6))).hasToString("[4.0,5.0,6.0]");
    }

    @Test
    void setAndCopyReplaceAllThree() {
        Vector v = new Vector(1, 2, 3);
        v.set(4, 5, 6);
        assertThat(v).hasToString("[4.0,5.0,6.0]");

        v.copy(new Vector(7, 8, 9));
        assertThat(v).hasToString("[7.0,8.0,9.0]");
    }

    @Test
    void addHasItsThreeForms() {
        Vector a = new Vector(1, 2, 3);
        Vector b = new Vector(10, 20, 30);
        Vector d = new Vector();

        assertThat(Vector.add(a, b)).hasToString("[11.0,22.0,33.0]");
        Vector.add(d, a, b);
        assertThat(d).hasToString("[11.0,22.0,33.0]");
        a.add(b);
        assertThat(a).hasToString("[11.0,22.0,33.0]");
        assertThat(b).hasToString("[10.0,20.0,30.0]");
    }

    @Test
    void subtractTakesTheSecondFromTheFirst() {
        Vector a = new Vector(1, 2, 3);
        Vector b = new Vector(10, 30, 50);
        Vector d = new Vector();

        Vector.subtract(d, a, b);
        assertThat(d).hasToString("[-9.0,-28.0,-47.0]");
        a.subtract(b);
        assertThat(a).hasToString("[-9.0,-28.0,-47.0]");
    }

    @Test
    void theVectorFromOnePointToAnotherIsTheirDifference() {
        Point to = new Point(1, 2, 3);
        Point from = new Point(10, 30, 50);
        Vector d = new Vector();

        assertThat(Vector.subtract(to, from)).hasToString("[-9.0,-28.0,-47.0]");
        Vector.subtract(d, to, from);
        assertThat(d).hasToString("[-9.0,-28.0,-47.0]");
    }

    @Test
    void crossFollowsTheRightHandsRule() {
        assertThat(Vector.cross(new Vector(1, 0, 0), new Vector(0, 1, 0))).hasToString("[0.0,0.0,1.0]");
        assertThat(Vector.cross(new Vector(0, 1, 0), new Vector(0, 0, 1))).hasToString("[1.0,0.0,0.0]");
        assertThat(Vector.cross(new Vector(0, 0, 1), new Vector(1, 0, 0))).hasToString("[0.0,1.0,0.0]");
    }

    @Test
    void crossHasItsThreeForms() {
        // (2·7 - 3·6, 3·5 - 1·7, 1·6 - 2·5) = (-4, 8, -4)
        Vector a = new Vector(1, 2, 3);
        Vector b = new Vector(5, 6, 7);
        Vector d = new Vector();

        assertThat(Vector.cross(a, b)).hasToString("[-4.0,8.0,-4.0]");
        Vector.cross(d, a, b);
        assertThat(d).hasToString("[-4.0,8.0,-4.0]");
        a.cross(b);
        assertThat(a).hasToString("[-4.0,8.0,-4.0]");
    }

    @Test
    void dotSumsTheProducts() {
        // 1·4 + 2·(-5) + 3·6 = 12
        Vector a = new Vector(1, 2, 3);
        Vector b = new Vector(4, -5, 6);

        assertThat(a.dot(b)).isEqualTo(12);
        assertThat(Vector.dot(a, b)).isEqualTo(12);
        assertThat(a.dot(new Point(4, -5, 6))).isEqualTo(12);
    }

    @Test
    void negateTurnsRound() {
        Vector a = new Vector(1, -2, 3);

        assertThat(Vector.negate(a)).hasToString("[-1.0,2.0,-3.0]");
        assertThat(a).hasToString("[1.0,-2.0,3.0]");
        a.negate();
        assertThat(a).hasToString("[-1.0,2.0,-3.0]");
    }

    @Test
    void scaleHasItsThreeForms() {
        Vector a = new Vector(1, -2, 3);
        Vector d = new Vector();

        assertThat(Vector.scale(a, 2)).hasToString("[2.0,-4.0,6.0]");
        Vector.scale(d, a, 2);
        assertThat(d).hasToString("[2.0,-4.0,6.0]");
        a.scale(2);
        assertThat(a).hasToString("[2.0,-4.0,6.0]");
    }

    @Test
    void theDestinationMayBeAnyOperand() {
        Vector b = new Vector(5, 6, 7);

        Vector left = new Vector(1, 2, 3);
        Vector.cross(left, left, b);
        assertThat(left).hasToString("[-4.0,8.0,-4.0]");
        Vector right = new Vector(5, 6, 7);
        Vector.cross(right, new Vector(1, 2, 3), right);
        assertThat(right).hasToString("[-4.0,8.0,-4.0]");
        Vector.add(right, b, right);
        assertThat(right).hasToString("[1.0,14.0,3.0]");
        Vector.subtract(right, b, right);
        assertThat(right).hasToString("[4.0,-8.0,4.0]");
        Vector.add(right, right, right);
        assertThat(right).hasToString("[8.0,-16.0,8.0]");
        Vector.scale(right, right, 0.5);
        assertThat(right).hasToString("[4.0,-8.0,4.0]");
        right.cross(right);
        assertThat(right).hasToString("[0.0,0.0,0.0]");
    }
}
