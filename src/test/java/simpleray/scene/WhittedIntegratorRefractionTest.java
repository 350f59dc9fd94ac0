package simpleray.scene;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static simpleray.scene.Scenes.LIGHTING;
import static simpleray.scene.Scenes.ahead;
import static simpleray.scene.Scenes.ball;
import static simpleray.scene.Scenes.glass;
import static simpleray.scene.Scenes.glowing;
import static simpleray.scene.Scenes.grey;
import static simpleray.scene.Scenes.lit;
import static simpleray.scene.Scenes.ray;
import static simpleray.scene.Scenes.seen;
import static simpleray.scene.Scenes.wall;

import org.assertj.core.data.Offset;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import simpleray.math.Colour;
import simpleray.math.Point;
import simpleray.math.Vector;

/**
 * Snell's law: sin 45° / 1.5 = √2/3 is the sine inside, √7/3 its cosine. The glass lies below z = 0, for the plane's normal is
 * (0,0,1). A ray hits a glowing ball of radius 0.000001 only if it goes where it should.
 */
class WhittedIntegratorRefractionTest {
    private static final Offset<Double> ROUNDING = within(1e-14);
    private static final int DEPTH = 10;
    private static final double S = Math.sqrt(0.5);
    private static final double SIN = Math.sqrt(2) / 3;
    private static final double COS = Math.sqrt(7) / 3;

    @Test
    void aRayAt45DegreesBendsTowardsTheNormal() {
        Vector bent = new Vector();
        Optics.refract(bent, new Vector(S, 0, -S), new Vector(0, 0, 1), 1 / 1.5);

        assertThat(Vector.add(bent, new Vector(-SIN, 0, COS)).norm()).isEqualTo(0, ROUNDING);
    }

    @Test
    void aRayThatEntersGlassSeesWhatLiesAlongTheBentRay() {
        Scene scene = lit(wall(glass(0, 0.5, 1.5), 0), ball(10 * SIN, 0, -10 * COS));

        assertThat(seen(scene, ray(-1, 0, 1, S, 0, -S), DEPTH, Terms.ALL)).hasToString("(0.5,0.5,0.5)");
    }

    @Test
    void aRayThatLeavesGlassBendsBack() {
        Scene scene = lit(wall(glass(0, 0.5, 1.5), 0), ball(10 * S, 0, 10 * S));

        assertThat(seen(scene, ray(-SIN, 0, -COS, SIN, 0, COS), DEPTH, Terms.ALL)).hasToString("(0.5,0.5,0.5)");
    }

    @Test
    void theInsideOfAPlaneIsWhereItsNormalDoesNotPoint() {
        // the same plane turned over: the ray from above now leaves, into the 45 degrees
        Scene scene = lit(new Plane(glass(0, 0.5, 1.5), new Vector(0, 0, -3), 0), ball(10 * S, 0, -10 * S));

        assertThat(seen(scene, ray(-SIN, 0, COS, SIN, 0, -COS), DEPTH, Terms.ALL)).hasToString("(0.5,0.5,0.5)");
    }

    @Test
    void aSlabShiftsARayAndDoesNotBendIt() {
        // between z = 0 and z = -1 the ray goes aside by tan = SIN/COS, and leaves at 45 degrees
        Material glass = glass(0, 0.5, 1.5);
        Scene scene = lit(wall(glass, 0), new Plane(glass, new Vector(0, 0, -1), 1), ball(SIN / COS + 5, 0, -6));

        assertThat(seen(scene, ray(-1, 0, 1, S, 0, -S), DEPTH, Terms.ALL)).hasToString("(0.25,0.25,0.25)");
    }

    @Test
    void aRayToTheCentreOfASphereGoesStraightThrough() {
        Scene scene = lit(new Sphere(glass(0, 0.5, 1.5), new Point(), 1), ball(0, 0, -20));

        assertThat(seen(scene, ahead(), DEPTH, Terms.ALL)).hasToString("(0.25,0.25,0.25)");
    }

    @Test
    void outsideOfGlassCountsAsOneWithinOtherGlassToo() {
        // all below z = 20 is glass too, and yet the ray leaves z = 0 as into air; and enters z = -1 below as from air
        Scene leaving = lit(wall(glass(0, 0.5, 1.5), 0), wall(glass(0, 1, 1.5), 20), ball(10 * S, 0, 10 * S));
        Scene entering = lit(wall(glass(0, 0.5, 1.5), 0), wall(glass(0, 1, 2), 20), ball(10 * SIN, 0, -10 * COS));

        assertThat(seen(leaving, ray(-SIN, 0, -COS, SIN, 0, COS), DEPTH, Terms.ALL)).hasToString("(0.5,0.5,0.5)");
        assertThat(seen(entering, ray(-1, 0, 1, S, 0, -S), DEPTH, Terms.ALL)).hasToString("(0.5,0.5,0.5)");
    }

    /** Twelve panes that glow and pass half on: with n refractions the ray sees 1 + 1/2 + ... + 1/2^n = 2 - 1/2^n. */
    @ParameterizedTest
    @CsvSource({"0, 10, 1", "1, 10, 1.5", "2, 10, 1.75", "10, 10, 1.9990234375", "10, 0, 1", "10, 0.9, 1", "10, 1, 1.5",
        "10, 1.999, 1.5", "10, 2, 1.75", "10, 3.5, 1.875", "2, 3, 1.75", "3, 2, 1.75"})
    void theLesserOfDepthAndShininessCountsTheRefractions(int depth, double shininess, double expected) {
        Object[] panes = new Object[12];
        for (int i = 0; i < panes.length; i++) {
            panes[i] = wall(glass(0, 0.5, 1), -i);
            panes[i].surfaceMaterial.ambient = grey(1);
            panes[i].surfaceMaterial.shininess = shininess;
        }

        assertThat(seen(lit(panes), ahead(), depth, Terms.ALL).g).isEqualTo(expected, ROUNDING);
    }

    @Test
    void mirrorAndRefractedRayAddUp() {
        // Ks 0.25 of the light of 1 above, Kt (0.5,0,1) of the 0.5 below
        Material glass = glass(0.25, 0, 1.5);
        glass.transmission = new Colour(0.5, 0, 1);
        Scene scene = lit(wall(glass, 0), wall(glowing(1), 4), wall(glowing(0.5), -4));

        assertThat(seen(scene, ahead(), DEPTH, Terms.ALL)).hasToString("(0.5,0.25,0.75)");
        assertThat(seen(scene, ahead(), DEPTH, LIGHTING)).as("without reflections").hasToString("(0.0,0.0,0.0)");
    }

    @Test
    void glassWithoutSpecularColourMirrorsNothing() {
        Scene scene = lit(wall(glass(0, 0.5, 1.5), 0), wall(glowing(1), 4), wall(glowing(0.5), -4));

        assertThat(seen(scene, ahead(), DEPTH, Terms.ALL)).hasToString("(0.25,0.25,0.25)");
    }
}
