package simpleray.scene;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static simpleray.scene.Scenes.ball;
import static simpleray.scene.Scenes.glass;
import static simpleray.scene.Scenes.glowing;
import static simpleray.scene.Scenes.lit;
import static simpleray.scene.Scenes.ray;
import static simpleray.scene.Scenes.seen;
import static simpleray.scene.Scenes.wall;

import org.assertj.core.data.Offset;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import simpleray.math.Colour;
import simpleray.math.Point;
import simpleray.math.Ray;
import simpleray.math.Vector;

/** Total internal reflection in glass of n = 1.5: beyond the critical angle, whose sine is 1/1.5 = 2/3. The glass lies below z = 0. */
class WhittedIntegratorTotalReflectionTest {
    private static final Offset<Double> ROUNDING = within(1e-14);
    private static final int DEPTH = 10;

    @Test
    void refractTellsOfIt() {
        assertThat(Optics.refract(new Vector(), new Vector(0.8, 0, 0.6), new Vector(0, 0, -1), 1.5)).isFalse();
        assertThat(Optics.refract(new Vector(), new Vector(0.6, 0, 0.8), new Vector(0, 0, -1), 1.5)).isTrue();
    }

    @ParameterizedTest
    @ValueSource(doubles = {-1e-9, -1e-3})
    void justBelowTheCriticalAngleARayPasses(double beside) {
        // Ks · 0.25 below + Kt · 1 above
        assertThat(fromWithin(2 / 3.0 + beside).r).isEqualTo(0.25 * 0.25 + 0.5, ROUNDING);
    }

    @ParameterizedTest
    @ValueSource(doubles = {1e-9, 1e-3, 0.3})
    void justAboveItTheMirrorCarriesKsAndKt(double beside) {
        assertThat(fromWithin(2 / 3.0 + beside).r).isEqualTo((0.25 + 0.5) * 0.25, ROUNDING);
    }

    @Test
    void totalReflectionNeedsNoSpecularColour() {
        Scene below = lit(wall(glass(0, 0.5, 1.5), 0), ball(6, 0, -8));
        Scene above = lit(wall(glass(0, 0.5, 1.5), 0), ball(8, 0, -6));

        assertThat(seen(below, ray(-3, 0, -4, 0.6, 0, 0.8), DEPTH, Terms.ALL)).as("0.6 < 2/3").hasToString("(0.0,0.0,0.0)");
        assertThat(seen(above, ray(-4, 0, -3, 0.8, 0, 0.6), DEPTH, Terms.ALL)).as("0.8 > 2/3").hasToString("(0.5,0.5,0.5)");
    }

    @Test
    void thereIsNoTotalReflectionOnTheWayIn() {
        double flat = 1e-3;
        Ray grazing = new Ray(new Point(-1, 0, flat), new Vector(1, 0, -flat).normalised());

        assertThat(seen(lit(wall(glass(0, 0.5, 1.5), 0), wall(glowing(1), -1)), grazing, DEPTH, Terms.ALL))
            .hasToString("(0.5,0.5,0.5)");
    }

    /** {@return what a ray within glass of Ks 0.25 and Kt 0.5 sees; below the glass there is a light of 0.25, above it one of 1} */
    private static Colour fromWithin(double sin) {
        Scene scene = lit(wall(glass(0.25, 0.5, 1.5), 0), wall(glowing(1), 5), wall(glowing(0.25), -5));
        double cos = Math.sqrt(1 - sin * sin);
        return seen(scene, ray(-sin, 0, -cos, sin, 0, cos), DEPTH, Terms.ALL);
    }
}
