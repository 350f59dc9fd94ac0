package simpleray.scene;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static simpleray.scene.Scenes.LIGHTING;
import static simpleray.scene.Scenes.ahead;
import static simpleray.scene.Scenes.glowing;
import static simpleray.scene.Scenes.grey;
import static simpleray.scene.Scenes.light;
import static simpleray.scene.Scenes.material;
import static simpleray.scene.Scenes.pointLight;
import static simpleray.scene.Scenes.seen;
import static simpleray.scene.Scenes.shadowedBy;
import static simpleray.scene.Scenes.wall;

import org.junit.jupiter.api.Test;
import simpleray.math.Point;
import simpleray.math.Vector;

/**
 * The ray comes down the z axis onto the plane z = 0 at the origin, and the light is at (3,0,4), 5 away along (0.6,0,0.8). Lit, the
 * place is 0.25 + 0.5 · 0.8 = 0.65; in shadow it is 0.25.
 */
class VisibilityTesterShadowTest {
    private static final double LIT = 0.65;
    private static final double SHADOWED = 0.25;
    private static final double ROUNDING = 1e-15;
    private static final Material BLACK = glowing(0);

    @Test
    void nothingInTheWayLeavesThePlaceLit() {
        sees(LIT, pointLight(3, 0, 4));
    }

    @Test
    void aSphereInTheWayCastsItsShadow() {
        sees(SHADOWED, pointLight(3, 0, 4), sphere(1.5, 0, 2, 0.5));
    }

    @Test
    void aSphereBesideTheWayCastsNone() {
        sees(LIT, pointLight(3, 0, 4), sphere(1.5, 0.51, 2, 0.5));
    }

    @Test
    void aPlaneInTheWayCastsItsShadow() {
        sees(SHADOWED, pointLight(3, 0, 4), wall(BLACK, 3));
        sees(SHADOWED, pointLight(3, 0, 4), new Plane(BLACK, new Vector(-1, 0, 0), -2));
    }

    @Test
    void whatIsBeyondThePointLightCastsNone() {
        sees(LIT, pointLight(3, 0, 4), sphere(6, 0, 8, 1), wall(BLACK, 4.001));
    }

    @Test
    void whatIsBehindThePlaceCastsNone() {
        sees(LIT, pointLight(3, 0, 4), sphere(-3, 0, -4, 1), wall(BLACK, -1));
    }

    @Test
    void aLightWithinASphereShinesOnNothingOutside() {
        sees(SHADOWED, pointLight(3, 0, 4), sphere(3, 0, 4, 0.5));
    }

    @Test
    void aSphereAroundPlaceAndLightCastsNone() {
        Scene scene = Scenes.of(wall(material(grey(0.25), grey(0.5), grey(0), 0), 0), sphere(0, 0, 0, 100));
        scene.ambient = grey(1);
        light(scene, pointLight(3, 0, 4));

        assertThat(seen(scene, ahead(), 0, Terms.ALL).r).isEqualTo(LIT, within(ROUNDING));
    }

    @Test
    void aDirectionalLightIsShadowedHoweverFarTheObject() {
        DirectionalLight light = new DirectionalLight(new Vector(-3, 0, -4));
        sees(LIT, light);
        sees(SHADOWED, light, sphere(3e6, 0, 4e6, 1));
        sees(SHADOWED, light, wall(BLACK, 1e6));
        sees(LIT, light, sphere(-3e6, 0, -4e6, 1), wall(BLACK, -1e6));
    }

    @Test
    void theSurfaceDoesNotShadowItself() {
        // (0.6,0,0.8) of the unit sphere looks at the light at (0.6,0,4)
        Scene scene = Scenes.of(new Sphere(material(grey(0), grey(0.5), grey(0), 0), new Point(), 1));
        light(scene, pointLight(0.6, 0, 4));

        assertThat(seen(scene, Scenes.ray(0.6, 0, 5, 0, 0, -1), 0, Terms.ALL).r).isEqualTo(0.4, within(ROUNDING));
    }

    @Test
    void eachLightHasItsOwnShadow() {
        // the wall x = -2 hides the second light only, the third adds 0.5 · 1: 0.25 + 0.4 + 0.5
        Scene scene = shadowedBy(new Plane(BLACK, new Vector(1, 0, 0), -2));
        light(scene, pointLight(3, 0, 4), pointLight(-3, 0, 4), pointLight(0, 0, 1));

        assertThat(seen(scene, ahead(), 0, Terms.ALL).r).isEqualTo(1.15, within(ROUNDING));
    }

    @Test
    void lightingLeavesShadowsOut() {
        Scene scene = shadowedBy(sphere(1.5, 0, 2, 0.5));
        light(scene, pointLight(3, 0, 4));

        assertThat(seen(scene, ahead(), 0, LIGHTING).r).isEqualTo(LIT, within(ROUNDING));
    }

    private static void sees(double expected, Light light, Object... obstacles) {
        Scene scene = shadowedBy(obstacles);
        light(scene, light);
        assertThat(seen(scene, ahead(), 0, Terms.ALL).r).isEqualTo(expected, within(ROUNDING));
    }

    private static Sphere sphere(double x, double y, double z, double radius) {
        return new Sphere(BLACK, new Point(x, y, z), radius);
    }
}
