package simpleray.scene;

import static org.assertj.core.api.Assertions.assertThat;
import static simpleray.scene.Scenes.grey;

import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import simpleray.math.Colour;
import simpleray.math.Point;
import simpleray.math.Vector;

/** Which light reaches the point (0,0,0) of a wall that faces (0,0,1). */
class VisibilityTesterTest {
    private static final Light LAMP = Scenes.pointLight(3, 0, 4);

    private final Interaction at = new Interaction();
    private final RayStats stats = new RayStats();
    private final Colour arriving = new Colour(1, 0.5, 0.25);

    @BeforeEach
    void lookAtTheWall() {
        Scene scene = Scenes.shadowedBy();
        Hit hit = new Hit();
        new BruteForceIntersector(scene).intersect(Scenes.ahead(), hit);
        at.set(Scenes.ahead(), hit, scene.getObject(0));
    }

    private VisibilityTester tester(boolean shadows, Object... obstacles) {
        return new VisibilityTester(new BruteForceIntersector(Scenes.shadowedBy(obstacles)), shadows, stats);
    }

    private static Sphere ball(Colour transmission) {
        Material material = new Material();
        material.transmission = transmission;
        return new Sphere(material, new Point(0.75, 0, 1), 0.25);
    }

    @Test
    void aFreeLightReachesWhole() {
        VisibilityTester tester = tester(true);

        assertThat(tester.reaches(LAMP, 0, at, arriving)).isTrue();
        assertThat(arriving).hasToString("(1.0,0.5,0.25)");
        assertThat(tester.distance).isEqualTo(5);
        assertThat(tester.towards).hasToString("[0.6,0.0,0.8]");
        assertThat(tester.facing).isEqualTo(0.8);
        assertThat(stats.shadow).isEqualTo(1);
    }

    @Test
    void glassDimsIt() {
        assertThat(tester(true, ball(grey(0.5))).reaches(LAMP, 0, at, arriving)).isTrue();
        assertThat(arriving).hasToString("(0.5,0.25,0.125)");
    }

    @Test
    void anOpaqueBallStopsItUnlessThereAreNoShadows() {
        assertThat(tester(false, ball(grey(0))).reaches(LAMP, 0, at, arriving)).isTrue();
        assertThat(arriving).hasToString("(1.0,0.5,0.25)");
        assertThat(stats.shadow).isZero();
        assertThat(tester(true, ball(grey(0))).reaches(LAMP, 0, at, arriving)).isFalse();
        assertThat(arriving.isBlack()).isTrue();
    }

    @Test
    void noRayIsSentToALightBehindTheSurfaceOrAlongIt() {
        Light behind = new DirectionalLight(new Vector(0, 0, 1));
        for (Light light : new Light[] {Scenes.pointLight(0, 0, -1), Scenes.pointLight(5, 0, 0), behind}) {
            arriving.copy(grey(1));

            assertThat(tester(true).reaches(light, 0, at, arriving)).isFalse();
            assertThat(arriving.isBlack()).isTrue();
        }
        assertThat(stats.shadow).isZero();
    }

    @Test
    void aBlackLightReachesNothing() {
        arriving.reset();

        assertThat(tester(true).reaches(LAMP, 0, at, arriving)).isFalse();
        assertThat(tester(false).reaches(LAMP, 0, at, arriving)).isFalse();
    }
}
