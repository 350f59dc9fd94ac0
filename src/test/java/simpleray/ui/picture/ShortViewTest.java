package simpleray.ui.picture;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Random;
import org.junit.jupiter.api.Test;
import simpleray.math.Point;
import simpleray.math.Ray;
import simpleray.math.Vector;
import simpleray.scene.PerspectiveCamera;
import simpleray.scene.PerspectiveCamera.Pose;

class ShortViewTest {
    private static final int WIDTH = 640;
    private static final int HEIGHT = 480;

    @Test
    void numbersThatAreShortStay() {
        Pose pose = new Pose(3, 2.5, 5, 0, 0.25, 0, 40);

        assertThat(ShortView.of(pose, WIDTH, HEIGHT)).isEqualTo(pose);
    }

    @Test
    void roundingErrorsGo() {
        assertThat(ShortView.of(new Pose(0, 0, 1.7000000000000002, 1e-17, 0, -1, 89.99999999999999), WIDTH, HEIGHT))
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
            Pose rounded = ShortView.of(pose, WIDTH, HEIGHT);
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
