package simpleray.math;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

class ColourTest {
    @Test
    void aNewColourIsBlack() {
        assertThat(new Colour()).hasToString("(0.0,0.0,0.0)");
        assertThat(new Colour().isBlack()).isTrue();
    }

    @Test
    void aColourWithAnyLightIsNotBlack() {
        assertThat(new Colour(0.1, 0, 0).isBlack()).isFalse();
        assertThat(new Colour(0, 0.1, 0).isBlack()).isFalse();
        assertThat(new Colour(0, 0, 0.1).isBlack()).isFalse();
    }

    @Test
    void aColourIsMadeOfThreeNumbersOrOfAnother() {
        Colour c = new Colour(0.25, 0.5, 2);
        Colour copy = new Colour(c);
        c.r = 9;

        assertThat(c).hasToString("(9.0,0.5,2.0)");
        assertThat(copy).hasToString("(0.25,0.5,2.0)");
    }

    @Test
    void copyReplacesAndResetBlackens() {
        Colour c = new Colour(1, 1, 1);
        c.copy(new Colour(0.25, 0.5, 2));
        assertThat(c).hasToString("(0.25,0.5,2.0)");

        c.reset();
        assertThat(c).hasToString("(0.0,0.0,0.0)");
    }

    @Test
    void addHasItsThreeForms() {
        Colour a = new Colour(0.25, 0.5, 1);
        Colour b = new Colour(1, 2, 3);
        Colour d = new Colour();

        assertThat(Colour.add(a, b)).hasToString("(1.25,2.5,4.0)");
        Colour.add(d, a, b);
        assertThat(d).hasToString("(1.25,2.5,4.0)");
        a.add(b);
        assertThat(a).hasToString("(1.25,2.5,4.0)");
        assertThat(b).hasToString("(1.0,2.0,3.0)");
    }

    @Test
    void multGoesComponentByComponentInItsThreeForms() {
        Colour a = new Colour(0.25, 0.5, 1);
        Colour b = new Colour(2, 3, 4);
        Colour d = new Colour();

        assertThat(Colour.mult(a, b)).hasToString("(0.5,1.5,4.0)");
        Colour.mult(d, a, b);
        assertThat(d).hasToString("(0.5,1.5,4.0)");
        a.mult(b);
        assertThat(a).hasToString("(0.5,1.5,4.0)");
        assertThat(b).hasToString("(2.0,3.0,4.0)");
    }

    @Test
    void scaleHasItsThreeForms() {
        Colour a = new Colour(0.25, 0.5, 1);
        Colour d = new Colour();

        assertThat(Colour.scale(a, 2)).hasToString("(0.5,1.0,2.0)");
        assertThat(a).hasToString("(0.25,0.5,1.0)");
        Colour.scale(d, a, 2);
        assertThat(d).hasToString("(0.5,1.0,2.0)");
        a.scale(2);
        assertThat(a).hasToString("(0.5,1.0,2.0)");
    }

    @Test
    void theDestinationMayBeAnyOperand() {
        Colour other = new Colour(2, 4, 8);
        Colour c = new Colour(1, 2, 3);

        Colour.add(c, c, other);
        assertThat(c).hasToString("(3.0,6.0,11.0)");
        Colour.add(c, other, c);
        assertThat(c).hasToString("(5.0,10.0,19.0)");
        Colour.mult(c, c, other);
        assertThat(c).hasToString("(10.0,40.0,152.0)");
        Colour.mult(c, other, c);
        assertThat(c).hasToString("(20.0,160.0,1216.0)");
        Colour.scale(c, c, 0.5);
        assertThat(c).hasToString("(10.0,80.0,608.0)");
    }

    @Test
    void clampBringsEachComponentIntoTheRangeZeroToOne() {
        Colour c = new Colour(-0.5, 0.5, 1.5);
        c.clamp();
        assertThat(c).hasToString("(0.0,0.5,1.0)");

        Colour edges = new Colour(1, 0, 1e300);
        edges.clamp();
        assertThat(edges).hasToString("(1.0,0.0,1.0)");
    }
}
