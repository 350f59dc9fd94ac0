package simpleray.scene;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static simpleray.scene.Scenes.LIGHTING;
import static simpleray.scene.Scenes.ahead;
import static simpleray.scene.Scenes.grey;
import static simpleray.scene.Scenes.light;
import static simpleray.scene.Scenes.material;
import static simpleray.scene.Scenes.pointLight;
import static simpleray.scene.Scenes.ray;
import static simpleray.scene.Scenes.seen;
import static simpleray.scene.Scenes.wall;

import org.junit.jupiter.api.Test;
import simpleray.math.Colour;
import simpleray.math.Point;
import simpleray.math.Vector;

/**
 * Which side of a surface a light shines on. The ray comes down the z axis onto the plane z = 0 at the origin; seen from there a light
 * at (3,0,4) has N·L = 0.8 and (N·H)² = 0.9 (see {@link WhittedIntegratorLocalTest}).
 */
class WhittedIntegratorFacingTest {
    private static final double ROUNDING = 1e-15;
    private static final Colour BLACK = grey(0);

    @Test
    void aLightBehindTheSurfaceAddsNothing() {
        Scene scene = Scenes.of(wall(material(BLACK, grey(1), grey(1), 0), 0));
        light(scene, pointLight(3, 0, -4), new DirectionalLight(new Vector(-3, 0, 4)));

        assertThat(seen(scene, ahead(), 0, LIGHTING)).hasToString("(0.0,0.0,0.0)");
    }

    @Test
    void aLightThatGrazesTheSurfaceAddsNothingNotEvenAHighlight() {
        // N·L = 0: not facing, though with shininess 0 the power is 1
        Scene scene = Scenes.of(wall(material(BLACK, grey(1), grey(1), 0), 0));
        light(scene, pointLight(3, 0, 0), new DirectionalLight(new Vector(0, 1, 0)));

        assertThat(seen(scene, ahead(), 0, LIGHTING)).hasToString("(0.0,0.0,0.0)");
    }

    @Test
    void aLightAtTheVeryPointAddsNothing() {
        Scene scene = Scenes.of(wall(material(BLACK, grey(1), grey(1), 0), 0));
        light(scene, pointLight(0, 0, 0));

        assertThat(seen(scene, ahead(), 0, LIGHTING)).hasToString("(0.0,0.0,0.0)");
    }

    @Test
    void aSurfaceIsLitAlikeFromBothOfItsSides() {
        Material material = material(BLACK, grey(0.5), grey(1), 2);
        Scene scene = Scenes.of(new Plane(material, new Vector(0, 0, -5), 0));
        light(scene, pointLight(3, 0, 4));

        // 0.5 · 0.8 + 0.9
        sees(scene, 1.3, 1.3, 1.3);
    }

    @Test
    void aSphereIsLitFromWithin() {
        // from the centre to (0,0,-5); the light is at (3,0,-1), seen from there along (3,0,4)
        Scene scene = Scenes.of(new Sphere(material(BLACK, grey(0.5), BLACK, 0), new Point(), 5));
        light(scene, pointLight(3, 0, -1));

        assertThat(seen(scene, ray(0, 0, 0, 0, 0, -1), 0, Terms.ALL).g).isEqualTo(0.4, within(ROUNDING));
    }

    @Test
    void aSphereIsLitOnItsSlope() {
        // the ray hits the unit sphere at (0.6,0,0.8), which is N; the light shines along the ray: L = (0,0,1), N·L = 0.8
        Scene scene = Scenes.of(new Sphere(material(BLACK, grey(0.5), BLACK, 0), new Point(), 1));
        light(scene, new DirectionalLight(new Vector(0, 0, -7)));

        assertThat(seen(scene, ray(0.6, 0, 5, 0, 0, -1), 0, Terms.ALL).r).isEqualTo(0.4, within(ROUNDING));
    }

    private static void sees(Scene scene, double r, double g, double b) {
        Colour colour = seen(scene, ahead(), 0, Terms.ALL);
        assertThat(colour.r).isEqualTo(r, within(ROUNDING));
        assertThat(colour.g).isEqualTo(g, within(ROUNDING));
        assertThat(colour.b).isEqualTo(b, within(ROUNDING));
    }
}
