package simpleray;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Random;
import java.util.function.UnaryOperator;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import simpleray.image.Picture;
import simpleray.math.Colour;
import simpleray.math.Point;
import simpleray.math.Vector;
import simpleray.scene.AreaLight;
import simpleray.scene.Camera;
import simpleray.scene.Cone;
import simpleray.scene.Cylinder;
import simpleray.scene.DirectionalLight;
import simpleray.scene.Light;
import simpleray.scene.Material;
import simpleray.scene.Mesh;
import simpleray.scene.Object;
import simpleray.scene.PerspectiveCamera;
import simpleray.scene.Plane;
import simpleray.scene.PointLight;
import simpleray.scene.Scene;
import simpleray.scene.SceneSettings;
import simpleray.scene.Sphere;
import simpleray.scene.Triangle;

/** What may be done to a scene without changing its picture, or with a change that is known: of all shapes, mirrors, glass and lights. */
class MetamorphicTest {
    private static final long SEED = 20261122;
    private static final int SCENES = 2;
    private static final int SIDE = 48;
    /** The share of pixels that may lie at edges, where nothing is asked of them. */
    private static final double EDGES = 0.03;
    /** A few roundings of sums of light. */
    private static final double ROUNDINGS = 1e-13;

    @TempDir
    Path folder;

    @ParameterizedTest
    @ValueSource(doubles = {1, 30, 90, 123.4, 180, 270})
    void turningSceneAndFreeCameraAboutTheVerticalChangesNothing(double degrees) throws IOException {
        assertSame(Move.turned(new Vector(0, 1, 0), degrees), true);
    }

    @ParameterizedTest
    @ValueSource(doubles = {10, 90, 200})
    void turningSceneAndViewerAboutAnyAxisChangesNothing(double degrees) throws IOException {
        assertSame(Move.turned(new Vector(1, 0, 0), degrees), false);
        assertSame(Move.turned(new Vector(-1, 3, 2), degrees), false);
    }

    @Test
    void shiftingSceneAndCameraChangesNothing() throws IOException {
        assertSame(Move.NONE.shifted(1, 2, 4), true);
        assertSame(Move.NONE.shifted(-17.3, 1234.5, 0.1), true);
        assertSame(Move.NONE.shifted(0, 0, -1e5), true);
    }

    @ParameterizedTest
    @ValueSource(doubles = {1e-3, 0.1, 0.5, 3, 1e3, 1e6})
    void enlargingSceneAndCameraChangesNothing(double factor) throws IOException {
        assertSame(Move.NONE.scaled(factor), true);
    }

    @Test
    void allOfThatTogetherChangesNothing() throws IOException {
        assertSame(Move.turned(new Vector(1, 1, -1), 77).scaled(40).shifted(-300, 20, 7), false);
    }

    @Test
    void mirroringTheSceneMirrorsThePicture() throws IOException {
        assertSame(Move.NONE.mirrored(), true);
        assertSame(Move.turned(new Vector(0, 1, 0), 50).mirrored(), true);
    }

    /** @param free whether the program's own free camera can look from where the scene comes to lie, with the same side up */
    private void assertSame(Move move, boolean free) throws IOException {
        boolean mirrors = Vector.cross(move.x(), move.y()).dot(move.z()) < 0;
        for (long seed = SEED; seed < SEED + SCENES; seed++) {
            String which = "seed " + seed + ", " + move;
            Scene scene = MixedScenes.of(seed, folder);
            Camera camera = camera(MixedScenes.POSE);
            StablePixels there = new StablePixels(scene, camera);
            Picture moved = StablePixels.render(move.scene(scene, folder),
                free ? camera(move.pose(MixedScenes.POSE)) : move.camera(camera));
            int edges = 0;
            for (int y = 0; y < SIDE; y++) {
                for (int x = 0; x < SIDE; x++) {
                    if (!there.isStable(x, y)) {
                        edges++;
                        continue;
                    }
                    assertThat(StablePixels.difference(there.picture, x, moved, mirrors ? SIDE - 1 - x : x, y))
                        .as("%s, column %d, row %d", which, x, y).isLessThanOrEqualTo(1);
                }
            }
            assertThat(edges).as(which).isLessThan((int) (EDGES * SIDE * SIDE));
        }
    }

    @Test
    void theOrderOfObjectsAndLightsChangesNothing() throws IOException {
        assertNear(1, scene -> {
            Scene other = copy(scene, 0);
            List<Object> objects = new ArrayList<>();
            for (int i = 0; i < scene.getNumberObjects(); i++) {
                objects.add(scene.getObject(i));
            }
            Collections.shuffle(objects, new Random(SEED));
            for (int i = 0; i < objects.size(); i++) {
                other.setObject(i, objects.get(i));
            }
            return other;
        });
        assertNear(1, scene -> {
            Scene other = copy(scene, 0);
            for (int i = 0; i < scene.getNumberLights(); i++) {
                other.setLight(i, scene.getLight((i + 1) % scene.getNumberLights()));
            }
            return other;
        });
    }

    @Test
    void aLightMayBeSplitInTwoOfHalfItsIntensity() throws IOException {
        assertNear(1, scene -> {
            Scene other = copy(scene, 0);
            int n = scene.getNumberLights();
            other.setNumberLights(2 * n);
            for (int i = 0; i < n; i++) {
                other.setLight(i, scaled(scene.getLight(i), 0.5));
                other.setLight(n + i, scaled(scene.getLight(i), 0.5));
            }
            return other;
        });
    }

    @Test
    void twiceTheLightIsTwiceThePicture() throws IOException {
        assertNear(2, scene -> {
            Scene other = copy(scene, 0);
            for (int i = 0; i < scene.getNumberLights(); i++) {
                other.setLight(i, scaled(scene.getLight(i), 2));
            }
            other.ambient = Colour.scale(scene.ambient, 2);
            other.settings = new SceneSettings();
            other.settings.background = Colour.scale(scene.settings.background, 2);
            return other;
        });
    }

    /** Small things of each shape within the opaque cube, and behind the floor, where neither eye nor light comes. */
    @Test
    void whatCannotBeSeenChangesNothing() throws IOException {
        assertNear(1, scene -> {
            Scene other = copy(scene, 6);
            int n = scene.getNumberObjects();
            Point middle = scene.getObject(5) instanceof Mesh cube ? cube.offset : null;
            Material bright = scene.getObject(1).surfaceMaterial;
            other.setObject(n, new Sphere(bright, middle, 0.1));
            other.setObject(n + 1, new Cylinder(bright, middle, Point.add(middle, new Vector(0, 0.1, 0.1)), 0.05));
            other.setObject(n + 2, new Triangle(bright, middle, Point.add(middle, new Vector(0.1, 0.1, 0)),
                Point.add(middle, new Vector(0, 0.1, -0.1))));
            other.setObject(n + 3, new Plane(bright, ((Plane) scene.getObject(0)).normal, -5));
            other.setObject(n + 5, new Cone(bright, middle, 0.1, Point.add(middle, new Vector(0.1, 0, 0.1)), 0));
            try {
                other.setObject(n + 4, new Mesh(bright, Bodies.box(folder).toString(), middle, 0.1));
            } catch (IOException e) {
                throw new UncheckedIOException(e);
            }
            return other;
        });
    }

    /** Asserts that light is so many times as much in each pixel, at edges too, but for roundings of sums in another order. */
    private void assertNear(double times, UnaryOperator<Scene> change) throws IOException {
        for (long seed = SEED; seed < SEED + SCENES; seed++) {
            Scene scene = MixedScenes.of(seed, folder);
            Picture before = StablePixels.render(scene, camera(MixedScenes.POSE));
            Picture after = StablePixels.render(change.apply(scene), camera(MixedScenes.POSE));
            for (int y = 0; y < SIDE; y++) {
                for (int i = 0; i < 3 * SIDE; i++) {
                    assertThat(after.row(y)[i]).as("seed %d, column %d, row %d", seed, i / 3, y)
                        .isCloseTo(times * before.row(y)[i], within(ROUNDINGS));
                }
            }
        }
    }

    /** {@return a scene of the same things, with room for some more objects} */
    private static Scene copy(Scene scene, int more) {
        Scene other = new Scene();
        other.ambient = scene.ambient;
        other.settings = scene.settings;
        other.setNumberObjects(scene.getNumberObjects() + more);
        for (int i = 0; i < scene.getNumberObjects(); i++) {
            other.setObject(i, scene.getObject(i));
        }
        other.setNumberLights(scene.getNumberLights());
        for (int i = 0; i < scene.getNumberLights(); i++) {
            other.setLight(i, scene.getLight(i));
        }
        return other;
    }

    private static Light scaled(Light of, double times) {
        Light light = of instanceof PointLight p ? new PointLight(p.origin) : of instanceof AreaLight a
            ? new AreaLight(a.corner, a.u, a.v, a.side) : new DirectionalLight(((DirectionalLight) of).direction);
        light.intensity = Colour.scale(of.intensity, times);
        return light;
    }

    private static Camera camera(PerspectiveCamera.Pose pose) {
        return new PerspectiveCamera(pose, SIDE, SIDE);
    }
}
