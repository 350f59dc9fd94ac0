package simpleray.trace;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import simpleray.math.Point;
import simpleray.math.Vector;
import simpleray.scene.DirectionalLight;
import simpleray.scene.Light;
import simpleray.scene.Material;
import simpleray.scene.Object;
import simpleray.scene.PointLight;
import simpleray.scene.Scene;
import simpleray.scene.Sphere;

/** Scenes that follow one another, as the frames of a film: what stays is kept. */
class CompiledSceneFramesTest {
    private static final Point EYE = new Point(0, 0, 9);

    private final Object[] balls = new Object[12];
    private final Light lamp = new PointLight(new Point(0, 5, 0));

    @BeforeEach
    void makeBalls() {
        for (int i = 0; i < balls.length; i++) {
            balls[i] = new Sphere(new Material(), new Point(i % 4, i / 4, 0), 0.3);
        }
    }

    private Scene scene(Light... lights) {
        Scene scene = new Scene();
        scene.setNumberObjects(balls.length);
        for (int i = 0; i < balls.length; i++) {
            scene.setObject(i, balls[i]);
        }
        scene.setNumberLights(lights.length);
        for (int i = 0; i < lights.length; i++) {
            scene.setLight(i, lights[i]);
        }
        return scene;
    }

    private CompiledScene compiled(Scene scene) {
        return new CompiledScene(scene, EYE, 1, CompiledScene.Structure.BVH, true);
    }

    @Test
    void ofTheSameObjectsTheTreeIsKept() {
        CompiledScene first = compiled(scene(lamp));
        Scene other = scene(lamp);

        CompiledScene next = first.with(other);

        assertThat(first.bvh).isNotNull();
        assertThat(next.bvh).isSameAs(first.bvh);
        assertThat(next.scene).isSameAs(other);
        assertThat(next.eyeBuffer).isNotNull().isSameAs(first.eyeBuffer);
        assertThat(next.lightBuffers[0]).isNotNull().isSameAs(first.lightBuffers[0]);
    }

    @Test
    void ofLightsOnlyThoseThatMoveGetNewBuffers() {
        Light other = new PointLight(new Point(1, 1, 5));
        CompiledScene first = compiled(scene(lamp, other, new DirectionalLight()));

        CompiledScene next = first.with(scene(new PointLight(new Point(0, 5, 0)), new PointLight(new Point(1, 1, 6)),
            new DirectionalLight()));

        assertThat(next.lightBuffers[0]).as("of the same place").isSameAs(first.lightBuffers[0]);
        assertThat(next.lightBuffers[1]).isNotNull().isNotSameAs(first.lightBuffers[1]);
        assertThat(next.lightBuffers[2]).as("has no place").isNull();
        assertThat(first.with(scene(lamp)).lightBuffers).hasSize(1);
        assertThat(first.with(scene(lamp, other, other, other)).lightBuffers[3]).isNotNull();
    }

    @Test
    void ofOtherObjectsNothingIsKept() {
        CompiledScene first = compiled(scene(lamp));
        balls[11] = balls[11].moved(new Vector(0, 0, 1));

        assertThat(first.with(scene(lamp))).isNull();
        Scene fewer = scene(lamp);
        fewer.setNumberObjects(11);
        assertThat(first.with(fewer)).isNull();
    }

    @Test
    void anEyeThatMovesGetsItsBufferIfItIsAskedFor() {
        CompiledScene next = compiled(scene(lamp)).with(scene(lamp)).seenFrom(new Point(1, 0, 9));

        assertThat(next.eyeBuffer).isNull();
        assertThat(next.listed().eyeBuffer).isNotNull();
    }
}
