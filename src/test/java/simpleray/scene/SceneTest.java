package simpleray.scene;

import static org.assertj.core.api.Assertions.assertThat;
import static simpleray.scene.Scenes.ahead;
import static simpleray.scene.Scenes.glowing;
import static simpleray.scene.Scenes.grey;
import static simpleray.scene.Scenes.ray;
import static simpleray.scene.Scenes.seen;
import static simpleray.scene.Scenes.wall;
import static simpleray.text.SceneText.written;

import org.junit.jupiter.api.Test;
import simpleray.math.Colour;
import simpleray.math.Point;
import simpleray.math.Ray;
import simpleray.math.Vector;

class SceneTest {
    @Test
    void aNewSceneIsEmptyAndDark() {
        Scene scene = new Scene();

        assertThat(scene.getNumberObjects()).isZero();
        assertThat(scene.getNumberLights()).isZero();
        assertThat(scene.ambient.isBlack()).isTrue();
        assertThat(scene.intersect(ahead(), new Colour(), 0)).isFalse();
    }

    @Test
    void aMissIsToldAndBlack() {
        Scene scene = Scenes.of(wall(glowing(1), 3));
        scene.ambient = grey(1);
        Colour colour = new Colour(7, 7, 7);

        assertThat(scene.intersect(ahead(), colour, 0)).isFalse();
        assertThat(colour).hasToString("(0.0,0.0,0.0)");
    }

    @Test
    void aHitIsToldAndReplacesTheColour() {
        Scene scene = Scenes.of(wall(glowing(0.5), 0));
        scene.ambient = grey(1);
        Colour colour = new Colour(7, 7, 7);

        assertThat(scene.intersect(ahead(), colour, 0)).isTrue();
        assertThat(colour).hasToString("(0.5,0.5,0.5)");
    }

    @Test
    void theNearestObjectIsSeenWhereverItIsListed() {
        Plane near = wall(glowing(0.5), 1);
        Plane far = wall(glowing(0.25), 0);
        Plane behind = wall(glowing(0.125), 3);
        for (Scene scene : new Scene[] {Scenes.of(near, far, behind), Scenes.of(behind, far, near), Scenes.of(far, near, behind)}) {
            scene.ambient = grey(1);
            assertThat(seen(scene, ahead(), 0, Terms.ALL)).hasToString("(0.5,0.5,0.5)");
        }
    }

    @Test
    void ofTwoAtTheSamePlaceTheFirstListedIsSeen() {
        Plane plane = wall(glowing(0.5), 0);
        Sphere sphere = new Sphere(glowing(0.25), new Point(0, 0, -1), 1);
        Scene planeFirst = Scenes.of(plane, sphere);
        planeFirst.ambient = grey(1);
        Scene sphereFirst = Scenes.of(sphere, plane);
        sphereFirst.ambient = grey(1);

        assertThat(seen(planeFirst, ahead(), 0, Terms.ALL)).hasToString("(0.5,0.5,0.5)");
        assertThat(seen(sphereFirst, ahead(), 0, Terms.ALL)).hasToString("(0.25,0.25,0.25)");
    }

    @Test
    void theRayAndTheNormalOfThePlaneStayAsTheyAre() {
        Plane plane = new Plane(Scenes.material(grey(0), grey(1), grey(0.5), 5), new Vector(0, 0, -1), 0);
        Scene scene = Scenes.of(plane);
        Scenes.light(scene, Scenes.pointLight(3, 0, 4));
        Ray ray = ray(0, 0, 2, 0, 0, -1);

        seen(scene, ray, 3, Terms.ALL);

        assertThat(ray.origin).hasToString("[0.0,0.0,2.0]");
        assertThat(ray.direction).hasToString("[0.0,0.0,-1.0]");
        assertThat(plane.normal).hasToString("[0.0,0.0,-1.0]");
        assertThat(plane.surfaceMaterial.specular).hasToString("(0.5,0.5,0.5)");
        assertThat(scene.getLight(0).intensity).hasToString("(1.0,1.0,1.0)");
    }

    @Test
    void anEmptySceneIsPrintedAsSuch() {
        assertThat(written(new Scene()::print)).isEqualTo("""
            Scene has 0 objects
            Scene has 0 lights
            Number of objects 0
            Ambient light is 0.0 0.0 0.0
            Number of lights 0
            """);
    }
}
