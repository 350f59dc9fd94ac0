package simpleray.scene;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static simpleray.scene.Scenes.ahead;
import static simpleray.scene.Scenes.grey;
import static simpleray.scene.Scenes.light;
import static simpleray.scene.Scenes.material;
import static simpleray.scene.Scenes.pointLight;
import static simpleray.scene.Scenes.seen;
import static simpleray.scene.Scenes.wall;

import org.junit.jupiter.api.Test;
import simpleray.math.Colour;
import simpleray.math.Vector;

/**
 * The terms of the colour, by hand. Nearly everywhere the ray comes down the z axis onto the plane z = 0 at the origin, and the light
 * is at (3,0,4): N = V = (0,0,1), L = (0.6,0,0.8), N·L = 0.8; L + V = (0.6,0,1.8), whose square is 3.6, so (N·H)² = 3.24 / 3.6 = 0.9.
 */
class WhittedIntegratorLocalTest {
    private static final double ROUNDING = 1e-15;
    private static final Colour BLACK = grey(0);

    @Test
    void theAmbientTermIsTheMaterialsTimesTheScenes() {
        Scene scene = Scenes.of(wall(material(new Colour(0.5, 0.25, 1), BLACK, BLACK, 0), 0));
        scene.ambient = new Colour(0.5, 0.5, 0.25);

        assertThat(seen(scene, ahead(), 0, Terms.ALL)).hasToString("(0.25,0.125,0.25)");
    }

    @Test
    void theDiffuseTermFallsWithTheSlantOfTheLight() {
        Scene scene = Scenes.of(wall(material(BLACK, new Colour(0.5, 0.25, 1), BLACK, 0), 0));
        PointLight light = pointLight(3, 0, 4);
        light.intensity = new Colour(1, 0.5, 0.25);
        light(scene, light);

        // Kd LC = (0.5,0.125,0.25), times 0.8
        sees(scene, 0.4, 0.1, 0.2);
    }

    @Test
    void lightDoesNotFallOffWithDistance() {
        Scene scene = Scenes.of(wall(material(BLACK, grey(0.5), BLACK, 0), 0));
        light(scene, pointLight(3e6, 0, 4e6));

        sees(scene, 0.4, 0.4, 0.4);
    }

    @Test
    void theSpecularTermIsThePowerOfTheHalfwayAngle() {
        Scene scene = Scenes.of(wall(material(BLACK, BLACK, new Colour(0.5, 0.25, 1), 2), 0));
        PointLight light = pointLight(3, 0, 4);
        light.intensity = new Colour(1, 0.5, 0.25);
        light(scene, light);

        // Ks LC = (0.5,0.125,0.25), times 0.9
        sees(scene, 0.45, 0.1125, 0.225);
    }

    @Test
    void aHigherShininessMakesASmallerHighlight() {
        Scene scene = Scenes.of(wall(material(BLACK, BLACK, grey(1), 4), 0));
        light(scene, pointLight(3, 0, 4));

        // 0.9²
        sees(scene, 0.81, 0.81, 0.81);
    }

    @Test
    void aShininessOfZeroMakesAHighlightWhereverLightFalls() {
        Scene scene = Scenes.of(wall(material(BLACK, BLACK, grey(0.5), 0), 0));
        light(scene, pointLight(3, 0, 4));

        sees(scene, 0.5, 0.5, 0.5);
    }

    @Test
    void aDirectionalLightShinesAgainstItsDirection() {
        Scene scene = Scenes.of(wall(material(BLACK, grey(0.5), BLACK, 0), 0));
        light(scene, new DirectionalLight(new Vector(-3, 0, -4)));

        sees(scene, 0.4, 0.4, 0.4);
    }

    @Test
    void theLightsAddUp() {
        Scene scene = Scenes.of(wall(material(grey(0.25), grey(0.5), grey(1), 2), 0));
        scene.ambient = grey(1);
        light(scene, pointLight(3, 0, 4), new DirectionalLight(new Vector(0, 0, -1)));

        // 0.25 + 0.5 (0.8 + 1) + (0.9 + 1)
        sees(scene, 3.05, 3.05, 3.05);
    }

    @Test
    void coloursAreNotClamped() {
        Scene scene = Scenes.of(wall(material(grey(3), BLACK, BLACK, 0), 0));
        scene.ambient = grey(2);

        assertThat(seen(scene, ahead(), 0, Terms.ALL)).hasToString("(6.0,6.0,6.0)");
    }

    private static void sees(Scene scene, double r, double g, double b) {
        Colour colour = seen(scene, ahead(), 0, Terms.ALL);
        assertThat(colour.r).isEqualTo(r, within(ROUNDING));
        assertThat(colour.g).isEqualTo(g, within(ROUNDING));
        assertThat(colour.b).isEqualTo(b, within(ROUNDING));
    }
}
