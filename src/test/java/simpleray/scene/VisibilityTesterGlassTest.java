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

import org.assertj.core.data.Offset;
import org.junit.jupiter.api.Test;
import simpleray.math.Colour;
import simpleray.math.Point;
import simpleray.math.Vector;

/**
 * The ray comes down the z axis onto the plane z = 0 at the origin, and the light is at (3,0,4), 5 away along (0.6,0,0.8). Lit, the
 * place is 0.25 + 0.5 · 0.8 = 0.65; behind glass it is 0.25 + 0.4 Kt.
 */
class VisibilityTesterGlassTest {
    private static final Offset<Double> ROUNDING = within(1e-15);
    private static final Colour TINT = new Colour(0.5, 0.25, 1);

    @Test
    void aGlassSphereDimsOnceAndNotOnEachSide() {
        sees(pointLight(3, 0, 4), 0.45, 0.35, 0.65, sphere(1.5, 0, 2));
    }

    @Test
    void aGlassPlaneDims() {
        sees(pointLight(3, 0, 4), 0.45, 0.35, 0.65, pane(1));
    }

    @Test
    void twoDimTwice() {
        // 0.4 (0.25, 0.0625, 1)
        sees(pointLight(3, 0, 4), 0.35, 0.275, 0.65, sphere(1.5, 0, 2), sphere(0.75, 0, 1));
        sees(pointLight(3, 0, 4), 0.35, 0.275, 0.65, pane(1), pane(2));
        sees(pointLight(3, 0, 4), 0.35, 0.275, 0.65, pane(1), sphere(1.5, 0, 2));
    }

    @Test
    void aDirectionalLightIsDimmedToo() {
        sees(new DirectionalLight(new Vector(-3, 0, -4)), 0.35, 0.275, 0.65, pane(1), sphere(1500, 0, 2000));
    }

    @Test
    void whatIsNotBetweenDimsNothing() {
        sees(pointLight(3, 0, 4), 0.65, 0.65, 0.65, sphere(6, 0, 8), sphere(1.5, 0.6, 2), pane(3.001), pane(-1));
    }

    @Test
    void aLightWithinGlassIsDimmedOnce() {
        sees(pointLight(3, 0, 4), 0.45, 0.35, 0.65, sphere(3, 0, 4));
    }

    @Test
    void glassAroundPlaceAndLightDimsNothing() {
        Scene scene = shadowedBy(new Sphere(glass(), new Point(), 100));
        light(scene, pointLight(3, 0, 4));

        assertThat(seen(scene, ahead(), 0, Terms.ALL).g).isEqualTo(0.65, ROUNDING);
    }

    @Test
    void anythingElseStillStopsTheLight() {
        Sphere black = new Sphere(glowing(0), new Point(1.5, 0, 2), 0.5);

        sees(pointLight(3, 0, 4), 0.25, 0.25, 0.25, pane(1), black);
        sees(pointLight(3, 0, 4), 0.25, 0.25, 0.25, black, pane(1));
    }

    @Test
    void theRefractiveIndexBendsNoShadowRay() {
        Sphere diamond = sphere(1.5, 0.1, 2);
        diamond.surfaceMaterial.index = 2.4;

        sees(pointLight(3, 0, 4), 0.45, 0.35, 0.65, diamond);
    }

    @Test
    void aHighlightIsDimmedAsWell() {
        // the light comes back along the ray: N·H = 1, so Ks alone
        Scene scene = Scenes.of(wall(material(grey(0), grey(0), grey(0.5), 0), 0), new Sphere(glass(), new Point(0, 0, 3), 0.5));
        light(scene, pointLight(0, 0, 4));

        assertThat(seen(scene, ahead(), 0, Terms.ALL)).hasToString("(0.25,0.125,0.5)");
    }

    @Test
    void lightingLeavesTintedShadowsOut() {
        Scene scene = shadowedBy(sphere(1.5, 0, 2));
        light(scene, pointLight(3, 0, 4));

        assertThat(seen(scene, ahead(), 0, LIGHTING).g).isEqualTo(0.65, ROUNDING);
    }

    @Test
    void theLightItselfIsNotChanged() {
        Scene scene = shadowedBy(pane(1));
        light(scene, pointLight(3, 0, 4));
        seen(scene, ahead(), 0, Terms.ALL);

        assertThat(scene.getLight(0).intensity).hasToString("(1.0,1.0,1.0)");
        assertThat(scene.getObject(1).surfaceMaterial.transmission).hasToString(TINT.toString());
    }

    private static void sees(Light light, double r, double g, double b, Object... obstacles) {
        Scene scene = shadowedBy(obstacles);
        light(scene, light);
        Colour colour = seen(scene, ahead(), 0, Terms.ALL);
        assertThat(colour.r).isEqualTo(r, ROUNDING);
        assertThat(colour.g).isEqualTo(g, ROUNDING);
        assertThat(colour.b).isEqualTo(b, ROUNDING);
    }

    private static Material glass() {
        Material glass = glowing(0);
        glass.transmission = new Colour(TINT);
        glass.index = 1.5;
        return glass;
    }

    private static Sphere sphere(double x, double y, double z) {
        return new Sphere(glass(), new Point(x, y, z), 0.5);
    }

    /** {@return the glass plane at this x, along the ray that sees the place} */
    private static Plane pane(double x) {
        return new Plane(glass(), new Vector(1, 0, 0), x);
    }
}
