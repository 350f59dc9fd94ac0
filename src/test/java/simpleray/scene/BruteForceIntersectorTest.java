package simpleray.scene;

import static org.assertj.core.api.Assertions.assertThat;
import static simpleray.scene.Scenes.grey;
import static simpleray.scene.Scenes.ray;
import static simpleray.scene.Scenes.wall;

import org.junit.jupiter.api.Test;
import simpleray.math.Colour;
import simpleray.math.Point;
import simpleray.math.Ray;

/** The thesis's loop over all objects. */
class BruteForceIntersectorTest {
    private static Sphere ball(Colour transmission, double z) {
        Material material = new Material();
        material.transmission = transmission;
        return new Sphere(material, new Point(0, 0, z), 1);
    }

    /** A wall at z = -2, tinted balls from -1 to 1 and from 4 to 6, and one that is opaque from 9 to 11. */
    private static final Scene ROOM = Scenes.of(wall(new Material(), -2), ball(new Colour(0.9, 0.5, 0.25), 0), ball(grey(0.5), 5),
        ball(grey(0), 10));
    private static final Ray AHEAD = ray(0, 0, 8, 0, 0, -1);

    private final BruteForceIntersector intersector = new BruteForceIntersector(ROOM);
    private final Hit hit = new Hit();

    @Test
    void theNearestHitIsFound() {
        assertThat(intersector.intersect(AHEAD, hit)).isTrue();
        assertThat(hit.t).isEqualTo(2);
        assertThat(hit.place).isEqualTo(2);
    }

    @Test
    void aMissLeavesNoHitOfTheRayBefore() {
        intersector.intersect(AHEAD, hit);

        assertThat(intersector.intersect(ray(9, 9, 0, 0, 0, 1), hit)).isFalse();
        assertThat(hit.place).isEqualTo(Hit.NONE);
        assertThat(hit.t).isEqualTo(Double.POSITIVE_INFINITY);
    }

    @Test
    void ofTwoHitsAtTheSameTTheObjectListedFirstWins() {
        new BruteForceIntersector(Scenes.of(wall(new Material(), 0), wall(new Material(), 0))).intersect(AHEAD, hit);

        assertThat(hit.place).isZero();
    }

    @Test
    void aLightIsDimmedByEachObjectBetween() {
        Colour left = new Colour(1, 2, 4);

        assertThat(intersector.occluded(AHEAD, 9.5, 0, left)).isFalse();
        assertThat(left).hasToString("(0.45,0.5,0.5)");
        assertThat(intersector.between(AHEAD, 9.5)).containsExactly(1, 2);
    }

    @Test
    void whatIsBehindTheLightIsNotBetween() {
        Colour left = new Colour(1, 2, 4);

        assertThat(intersector.occluded(AHEAD, 2, 0, left)).as("the light is on the ball").isFalse();
        assertThat(left).hasToString("(1.0,2.0,4.0)");
        assertThat(intersector.between(AHEAD, 2)).isEmpty();
    }

    @Test
    void nothingIsLeftBehindSomethingOpaque() {
        Colour left = new Colour(1, 2, 4);

        assertThat(intersector.occluded(AHEAD, Double.POSITIVE_INFINITY, 0, left)).isTrue();
        assertThat(left.isBlack()).isTrue();
        assertThat(intersector.between(AHEAD, Double.POSITIVE_INFINITY)).as("up to what lets nothing through").containsExactly(0);
    }

    /** A mesh is made ready for one ray at a time. */
    @Test
    void eachRayIsAskedAnewWhatIsBetween() {
        Triangles square = new Triangles(new double[] {-1, -1, 0, 1, -1, 0, 0, 2, 0}, new int[] {0, 1, 2}, new double[0], null);
        BruteForceIntersector mesh = new BruteForceIntersector(Scenes.of(new Mesh(new Material(), "x", new Point(), 1, square)));

        assertThat(mesh.between(AHEAD, 20)).containsExactly(0);
        assertThat(mesh.between(ray(9, 9, 8, 0, 0, -1), 20)).isEmpty();
        assertThat(mesh.between(ray(0.1, 0, -3, 0, 0, 1), 20)).containsExactly(0);
    }
}
