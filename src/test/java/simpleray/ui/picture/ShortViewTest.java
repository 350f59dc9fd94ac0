package simpleray.ui.picture;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.util.Random;
import org.junit.jupiter.api.Test;
import simpleray.math.Point;
import simpleray.math.Ray;
import simpleray.math.Vector;
import simpleray.scene.PerspectiveCamera;
import simpleray.scene.PerspectiveCamera.Pose;
import simpleray.scene.SceneSettings;

class ShortViewTest {
    private static final int WIDTH = 640;
    private static final int HEIGHT = 480;

    private static Pose of(Pose pose, int width, int height) {
        SceneSettings settings = new SceneSettings();
        settings.camera = pose;
        return ShortView.of(settings, width, height).camera;
    }

    @Test
    void parallelRaysAndUpStay() throws IOException {
        SceneSettings parallel = ShortView.of(SceneSettings.of("parallel 1.9999999999999998 1e-17 5 0 0 0 6.000000000001\nup 1 0.3333333333333333 0", "a"),
            WIDTH, HEIGHT);
        SceneSettings camera = ShortView.of(SceneSettings.of("camera 0 2.9999999999999996 0 0 0 0 40\nup 1e-3 0 0", "a"), WIDTH, HEIGHT);

        assertThat(parallel.lines()).isEqualTo("parallel 2.0 0.0 5.0 0.0 0.0 0.0 6.0\nup 1.0 0.3333333333333333 0.0\n");
        assertThat(camera.lines()).isEqualTo("camera 0.0 3.0 0.0 0.0 0.0 0.0 40.0\nup 0.001 0.0 0.0\n");
    }

    /** At the edges, 320 pixels from the middle, a rounding to 6 would be 0.0029 pixels, and one to 6.0001 0.0024. */
    @Test
    void aHeightOfParallelRaysKeepsAThousandthOfAPixel() throws IOException {
        SceneSettings exact = SceneSettings.of("parallel 0 0 5 0 0 0 6.000054321", "a");
        SceneSettings found = ShortView.of(exact, WIDTH, HEIGHT);

        assertThat(found.parallel.height()).isEqualTo(6.00005);
        assertThat(ShortView.shift(exact, found, WIDTH, HEIGHT)).isLessThan(ShortView.MAX_SHIFT);
    }

    @Test
    void numbersThatAreShortStay() {
        Pose pose = new Pose(3, 2.5, 5, 0, 0.25, 0, 40);

        assertThat(of(pose, WIDTH, HEIGHT)).isEqualTo(pose);
    }

    @Test
    void roundingErrorsGo() {
        assertThat(of(new Pose(0, 0, 1.7000000000000002, 1e-17, 0, -1, 89.99999999999999), WIDTH, HEIGHT))
            .isEqualTo(new Pose(0, 0, 1.7, 0, 0, -1, 90));
    }

    @Test
    void aPointMovesByAThousandthOfAPixelAtMost() {
        Random random = new Random(1);
        int digits = 0;
        for (int i = 0; i < 50; i++) {
            double scale = Math.pow(10, random.nextInt(9) - 4);
            Pose pose = new Pose(at(random, scale), at(random, scale), at(random, scale), at(random, scale), at(random, scale),
                at(random, scale), 20 + 100 * random.nextDouble());
            Pose rounded = of(pose, WIDTH, HEIGHT);
            double x = WIDTH * random.nextDouble();
            double y = HEIGHT * random.nextDouble();
            double distance = Math.sqrt(square(pose.lx() - pose.ex()) + square(pose.ly() - pose.ey()) + square(pose.lz() - pose.ez()));

            Ray ray = new PerspectiveCamera(pose, WIDTH, HEIGHT).through(x, y);
            double far = distance * (0.1 + 2 * random.nextDouble());
            Point seen = new Point(ray.origin.x + far * ray.direction.x, ray.origin.y + far * ray.direction.y,
                ray.origin.z + far * ray.direction.z);
            PerspectiveCamera other = new PerspectiveCamera(rounded, WIDTH, HEIGHT);
            Ray near = other.through(x, y);
            double angle = Vector.cross(near.direction, towards(other.eye(), seen)).norm();
            assertThat(angle).as(pose + " and " + rounded).isLessThan(1.2 * ShortView.MAX_SHIFT * widest(other));
            digits += rounded.toString().length();
        }
        assertThat(digits / 50).as("characters of a camera").isLessThan(110);
    }

    /** {@return the angle that a pixel in the middle of a picture has, the largest of all} */
    private static double widest(PerspectiveCamera camera) {
        return camera.up().norm() / HEIGHT;
    }

    private static Vector towards(Point eye, Point seen) {
        Vector v = Vector.subtract(seen, eye);
        v.normalise();
        return v;
    }

    private static double at(Random random, double scale) {
        return scale * (random.nextDouble() - 0.5);
    }

    private static double square(double d) {
        return d * d;
    }
}
