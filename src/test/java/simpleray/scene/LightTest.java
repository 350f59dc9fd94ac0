package simpleray.scene;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;
import static simpleray.text.SceneText.reader;
import static simpleray.text.SceneText.written;

import java.io.IOException;
import org.junit.jupiter.api.Test;
import simpleray.math.Colour;
import simpleray.math.Point;
import simpleray.math.Vector;

class LightTest {
    private static final double ROUNDING = 1e-15;

    @Test
    void aNewPointLightIsWhiteAndAtTheOrigin() {
        assertThat(written(new PointLight()::print)).isEqualTo(
            "Point light with colour: (1.0,1.0,1.0) and origin: [0.0,0.0,0.0]");
    }

    @Test
    void aNewDirectionalLightIsWhiteAndShinesDown() {
        assertThat(written(new DirectionalLight()::print)).isEqualTo(
            "Directional light with colour: (1.0,1.0,1.0) and direction: [0.0,-1.0,0.0]");
    }

    @Test
    void aLightKeepsItsPlaceAndCopiesNothing() {
        Point origin = new Point(1, 2, 3);
        Vector direction = new Vector(1, 2, 3);

        assertThat(new PointLight(origin).origin).isSameAs(origin);
        assertThat(new DirectionalLight(direction).direction).isSameAs(direction);
    }

    @Test
    void aPointLightIsTowardsItsOriginAtItsDistance() {
        // (3,2,4) - (0,2,0) = (3,0,4), 5 long
        Vector l = new Vector();

        assertThat(new PointLight(new Point(3, 2, 4)).towards(new Point(0, 2, 0), l)).isEqualTo(5);
        assertThat(l.x).isEqualTo(0.6, within(ROUNDING));
        assertThat(l.y).isZero();
        assertThat(l.z).isEqualTo(0.8, within(ROUNDING));
    }

    @Test
    void aPointLightAtTheVeryPointIsNowhere() {
        Vector l = new Vector(7, 7, 7);

        assertThat(new PointLight(new Point(1, 2, 3)).towards(new Point(1, 2, 3), l)).isZero();
        assertThat(l).hasToString("[0.0,0.0,0.0]");
    }

    @Test
    void aDirectionalLightIsAgainstItsDirectionInfinitelyFar() {
        DirectionalLight light = new DirectionalLight(new Vector(-3, 0, -4));
        Vector l = new Vector();

        assertThat(light.towards(new Point(9, 9, 9), l)).isEqualTo(Double.POSITIVE_INFINITY);
        assertThat(l.x).isEqualTo(0.6, within(ROUNDING));
        assertThat(l.y).isZero();
        assertThat(l.z).isEqualTo(0.8, within(ROUNDING));
        assertThat(light.direction).hasToString("[-3.0,0.0,-4.0]");
    }

    @Test
    void aPointLightReadsBackBitForBit() throws IOException {
        PointLight before = new PointLight(new Point(-0.0, 1e23, 1.0 / 3));
        before.intensity = new Colour(0.1, Double.MIN_VALUE, 7);
        String text = written(before::write);
        PointLight after = new PointLight();
        after.read(reader(text));

        assertThat(text).isEqualTo("0.1 4.9E-324 7.0  -0.0 1.0E23 0.3333333333333333");
        assertThat(SceneBits.of(after)).isEqualTo(SceneBits.of(before));
    }

    @Test
    void aDirectionalLightReadsBackBitForBit() throws IOException {
        DirectionalLight before = new DirectionalLight(new Vector(-0.0, 1e23, 1.0 / 3));
        before.intensity = new Colour(0.1, Double.MIN_VALUE, 7);
        String text = written(before::write);
        DirectionalLight after = new DirectionalLight();
        after.read(reader(text));

        assertThat(text).isEqualTo("0.1 4.9E-324 7.0  -0.0 1.0E23 0.3333333333333333");
        assertThat(SceneBits.of(after)).isEqualTo(SceneBits.of(before));
    }

    @Test
    void eachMissingPartIsNamed() {
        assertThatThrownBy(() -> new PointLight().read(reader("1 *"))).hasMessage(
            "<stdin>:1:3: error: expected colour green, found '*'\n1 *\n  ^");
        assertThatThrownBy(() -> new PointLight().read(reader("1 1 1 0 *"))).hasMessage(
            "<stdin>:1:9: error: expected origin y, found '*'\n1 1 1 0 *\n        ^");
        assertThatThrownBy(() -> new DirectionalLight().read(reader("1 1"))).hasMessage(
            "<stdin>:1:4: error: expected colour blue, found the end of the file\n1 1\n   ^");
        assertThatThrownBy(() -> new DirectionalLight().read(reader("1 1 1\n0 0"))).hasMessage(
            "<stdin>:2:4: error: expected direction z, found the end of the file\n0 0\n   ^");
    }

    @Test
    void aLightIsNotBelowZero() {
        assertThatThrownBy(() -> new PointLight().read(reader("1 1 -1  0 0 0"))).hasMessage(
            "<stdin>:1:5: error: expected colour blue of 0 or more, found '-1'\n1 1 -1  0 0 0\n    ^");
    }

    @Test
    void aDirectionalLightMustTravelSomewhere() {
        assertThatThrownBy(() -> new DirectionalLight().read(reader("1 1 1\n0 0 0"))).hasMessage(
            "<stdin>:2:1: error: expected direction other than zero, found '0 0 0'\n0 0 0\n^");
    }
}
