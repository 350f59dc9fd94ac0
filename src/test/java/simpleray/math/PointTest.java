package simpleray.math;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

class PointTest {
    @Test
    void aNewPointIsTheOrigin() {
        assertThat(new Point()).hasToString("[0.0,0.0,0.0]");
    }

    @Test
    void aPointIsMadeOfThreeNumbersOrOfAnother() {
        Point p = new Point(1, 2, 3);
        Point copy = new Point(p);
        p.z = 9;

        assertThat(p).hasToString("[1.0,2.0,9.0]");
        assertThat(copy).hasToString("[1.0,2.0,3.0]");
    }

    @Test
    void setAndCopyReplaceAllThree() {
        Point p = new Point(1, 2, 3);
        p.set(4, 5, 6);
        assertThat(p).hasToString("[4.0,5.0,6.0]");

        p.copy(new Point(7, 8, 9));
        assertThat(p).hasToString("[7.0,8.0,9.0]");
    }

    @Test
    void addMovesByAVectorInItsThreeForms() {
        Point p = new Point(1, 2, 3);
        Vector v = new Vector(10, 20, 30);
        Point d = new Point();

        assertThat(Point.add(p, v)).hasToString("[11.0,22.0,33.0]");
        assertThat(p).hasToString("[1.0,2.0,3.0]");
        Point.add(d, p, v);
        assertThat(d).hasToString("[11.0,22.0,33.0]");
        Point.add(d, d, v);
        assertThat(d).hasToString("[21.0,42.0,63.0]");
        p.add(v);
        assertThat(p).hasToString("[11.0,22.0,33.0]");
    }

    @Test
    void pointsAreEqualWhenAllThreeNumbersAre() {
        Point p = new Point(1, 2, 3);

        assertThat(p.equals(new Point(1, 2, 3))).isTrue();
        assertThat(p.equals(new Point(9, 2, 3))).isFalse();
        assertThat(p.equals(new Point(1, 9, 3))).isFalse();
        assertThat(p.equals(new Point(1, 2, 9))).isFalse();
    }

    @Test
    void aPointAlongARayIsTDirectionsFromItsOrigin() {
        // (1,2,3) + 2.5 (0,0,-2)
        Ray ray = new Ray(new Point(1, 2, 3), new Vector(0, 0, -2));

        assertThat(ray.getPointAt(2.5)).hasToString("[1.0,2.0,-2.0]");
        assertThat(ray.getPointAt(0)).hasToString("[1.0,2.0,3.0]");
        assertThat(ray.origin).hasToString("[1.0,2.0,3.0]");
        assertThat(ray.direction).hasToString("[0.0,0.0,-2.0]");
    }

    @Test
    void aRayKeepsItsPointAndVectorAndCopiesNeither() {
        Point origin = new Point();
        Vector direction = new Vector(1, 0, 0);
        Ray ray = new Ray(origin, direction);

        assertThat(ray.origin).isSameAs(origin);
        assertThat(ray.direction).isSameAs(direction);
    }

    @Test
    void aNewRayLooksDownTheZAxisFromTheOrigin() {
        assertThat(new Ray().origin).hasToString("[0.0,0.0,0.0]");
        assertThat(new Ray().direction).hasToString("[0.0,0.0,-1.0]");
    }
}
