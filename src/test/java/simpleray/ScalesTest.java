package simpleray;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.stream.IntStream;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import simpleray.image.Picture;
import simpleray.math.Colour;
import simpleray.math.Point;
import simpleray.math.Ray;
import simpleray.math.Vector;
import simpleray.render.Accel;
import simpleray.render.RenderListener;
import simpleray.render.RenderSettings;
import simpleray.render.Renderer;
import simpleray.render.Stage;
import simpleray.scene.Camera;
import simpleray.scene.DirectionalLight;
import simpleray.scene.Light;
import simpleray.scene.Material;
import simpleray.scene.Object;
import simpleray.scene.PerspectiveCamera;
import simpleray.scene.PointLight;
import simpleray.scene.Scene;
import simpleray.scene.Sphere;

/**
 * Scenes of a thousandth of a unit to a million units and beyond. A convex body throws no shadow on itself, and lets no light in: so
 * the picture of one is known from its picture without shadows, or is black.
 */
class ScalesTest {
    private static final int SIDE = 36;
    /** The cosine at which light may leave specks on a sphere of radius 1 that is far larger than where it is seen. */
    private static final double VAST = 3e-9;
    private static final Move TILT = Move.turned(new Vector(1, 2, 3), 40);
    private static final PerspectiveCamera.Pose WITHOUT = new PerspectiveCamera.Pose(0.5, 1.5, 3.5, 0, 0, 0, 50);
    private static final PerspectiveCamera.Pose WITHIN = new PerspectiveCamera.Pose(-0.3, -0.35, 0.2, 0.3, 0.4, -0.7, 100);
    private static final PointLight LAMP = new PointLight(new Point(0.3, 0.4, 0.2));
    private static final PointLight LAMP_OUTSIDE = new PointLight(new Point(2, 3, 4));
    private static final DirectionalLight SUN = new DirectionalLight(new Vector(-2, -3, -4));

    @TempDir
    Path folder;

    @ParameterizedTest
    @ValueSource(doubles = {1e-3, 1, 1e3, 1e5, 1e6, 1e12})
    void aBodyThrowsNoShadowOnItself(double scale) throws IOException {
        for (Light light : List.of(LAMP_OUTSIDE, SUN)) {
            for (Lit lit : lit(scale, WITHOUT, light)) {
                if (!lit.name.startsWith("box of planes")) {      // whose planes go on beyond it
                    lit.assertNoSpecks();
                }
            }
        }
    }

    @ParameterizedTest
    @ValueSource(doubles = {1e-3, 1, 1e3, 1e5, 1e6, 1e12})
    void theWallsOfARoomThrowNoShadowOnThemselves(double scale) throws IOException {
        for (Lit lit : lit(scale, WITHIN, LAMP)) {
            lit.assertNoSpecks();
        }
    }

    @ParameterizedTest
    @ValueSource(doubles = {1e-3, 1, 1e3, 1e5, 1e6, 1e12})
    void noLightComesIntoAClosedRoom(double scale) throws IOException {
        for (Light light : List.of(LAMP_OUTSIDE, SUN)) {
            for (Lit lit : lit(scale, WITHIN, light)) {
                lit.assertDark();
            }
        }
    }

    /** The ground as a sphere: its own roundings are those of its radius, however near the origin it is seen. */
    @ParameterizedTest
    @ValueSource(doubles = {1e3, 1e5, 1e6, 1e7})
    void aVastSphereHasSpecksOnlyWhereLightFallsAtAnAngleThatIsSmallForIt(double radius) {
        Scene scene = Bodies.scene(List.of(new Sphere(matt(), new Point(0, -radius, 0), radius)));
        scene.setNumberLights(1);
        for (double low = 1; low > 1e-7; low /= 4) {
            scene.setLight(0, new DirectionalLight(new Vector(-1, -low, -0.7)));
            Lit lit = new Lit("radius " + radius + ", light from " + low, scene,
                new PerspectiveCamera(new PerspectiveCamera.Pose(0.3, 2, 6, 0, 0, 0, 50), SIDE, SIDE));
            lit.assertNoSpecksAbove(radius * VAST);
        }
    }

    /** {@return each body, upright, tilted, and tilted beside the origin} */
    private List<Lit> lit(double scale, PerspectiveCamera.Pose pose, Light light) throws IOException {
        List<Lit> all = new ArrayList<>();
        for (Move move : List.of(Move.NONE, TILT, TILT.shifted(3, -2, 5))) {
            for (Map.Entry<String, Scene> body : Bodies.all(matt(), folder).entrySet()) {
                body.getValue().setNumberLights(1);
                body.getValue().setLight(0, light);
                Move place = move.scaled(scale);
                all.add(new Lit(body.getKey() + " at " + scale + ", " + move, place.scene(body.getValue(), folder),
                    place.camera(new PerspectiveCamera(pose, SIDE, SIDE))));
            }
        }
        return all;
    }

    private static Material matt() {
        Material material = new Material();
        material.ambient = new Colour();
        material.diffuse = new Colour(0.8, 0.8, 0.8);
        material.specular = new Colour(0.5, 0.5, 0.5);
        material.shininess = 0.9;                             // bright where light grazes, and no mirror
        return material;
    }

    /** A body that is lit. */
    private record Lit(String name, Scene scene, Camera camera) {
        /** Asserts that no pixel is darker than without shadows, however low the light stands. */
        void assertNoSpecks() {
            Picture shadowed = picture();
            Picture lit = render(Stage.LIGHTING, Accel.NONE);
            assertThat(isBlack(lit)).as(name).isFalse();          // else there would be nothing to be seen
            for (int y = 0; y < SIDE; y++) {
                assertThat(shadowed.row(y)).as("%s, row %d", name, y).isEqualTo(lit.row(y));
            }
        }

        /** Asserts the same where the cosine of light and normal is above a limit; for one object. */
        void assertNoSpecksAbove(double limit) {
            Picture shadowed = picture();
            Picture lit = render(Stage.LIGHTING, Accel.NONE);
            for (int y = 0; y < SIDE; y++) {
                for (int x = 0; x < SIDE; x++) {
                    if (shadowed.row(y)[3 * x] != lit.row(y)[3 * x]) {
                        Ray in = camera.through(x + 0.5, y + 0.5);
                        Point point = in.getPointAt(hit(in));
                        Vector towards = new Vector();
                        scene.getLight(0).towards(point, towards);
                        assertThat(scene.getObject(0).normal(point).dot(towards)).as("%s, column %d, row %d", name, x, y).isLessThan(limit);
                    }
                }
            }
        }

        /** Asserts that all is black, but for points so near a corner that the wall beside them is nearer than any hit may be. */
        void assertDark() {
            Picture picture = picture();
            for (int y = 0; y < SIDE; y++) {
                for (int x = 0; x < SIDE; x++) {
                    if (picture.row(y)[3 * x] != 0) {
                        assertThat(hit(beyondThreshold(x, y))).as("%s, column %d, row %d", name, x, y).isInfinite();
                    }
                }
            }
        }

        /** {@return the ray to the light from where a pixel shows, but for its beginning} */
        private Ray beyondThreshold(int x, int y) {
            Ray in = camera.through(x + 0.5, y + 0.5);
            Point point = in.getPointAt(hit(in));
            Vector towards = new Vector();
            scene.getLight(0).towards(point, towards);
            return new Ray(Point.add(point, Vector.scale(towards, 1.01 * Object.THRESHOLD)), towards);
        }

        private static boolean isBlack(Picture picture) {
            return IntStream.range(0, SIDE).allMatch(y -> Arrays.stream(picture.row(y)).allMatch(light -> light == 0));
        }

        private double hit(Ray ray) {
            double nearest = Double.POSITIVE_INFINITY;
            for (int i = 0; i < scene.getNumberObjects(); i++) {
                double t = scene.getObject(i).intersect(ray);
                if (t >= 0) {
                    nearest = Math.min(nearest, t);
                }
            }
            return nearest;
        }

        /** {@return the picture with shadows, which is that of the loop over all objects} */
        private Picture picture() {
            Picture plain = render(Stage.FINAL, Accel.NONE);
            Picture fast = render(Stage.FINAL, Accel.AUTO);
            for (int y = 0; y < SIDE; y++) {
                assertThat(fast.row(y)).as("%s, row %d", name, y).isEqualTo(plain.row(y));
            }
            return plain;
        }

        private Picture render(Stage stage, Accel accel) {
            return new Renderer(scene, camera, new RenderSettings(stage, 0, 1, accel, 1, null)).render(RenderListener.NONE);
        }
    }
}
