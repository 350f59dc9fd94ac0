package simpleray.rays;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;
import simpleray.math.Point;
import simpleray.math.Vector;
import simpleray.scene.Camera;
import simpleray.scene.ParallelCamera;
import simpleray.scene.PerspectiveCamera;
import simpleray.scene.SimpleCamera;

/** Where a picture shows a point. */
class ProjectionTest {
    private static final double CLOSE = 1e-6;

    @Test
    void aPointOfARayIsShownWhereTheRayGoesThroughThePicture() {
        SimpleCamera odd = new SimpleCamera(40, 30);
        odd.setVPWindow(-1, 3, -0.5, 1);
        Random random = new Random(20140607);
        for (Camera camera : List.of(new SimpleCamera(200, 100), odd,
                new PerspectiveCamera(new PerspectiveCamera.Pose(1, 2, 3, -4, 0.5, -6, 50), 90, 60),
                new ParallelCamera(new ParallelCamera.View(1, 2, 3, -4, 0.5, -6, 5), new Vector(0.5, 2, 0), 90, 60))) {
            Projection projection = new Projection(camera);
            for (int i = 0; i < 100; i++) {
                double px = random.nextDouble() * camera.width() * 2 - 0.5 * camera.width();
                double py = random.nextDouble() * camera.height() * 2 - 0.5 * camera.height();

                double[] at = projection.of(camera.through(px, py).getPointAt(0.1 + 9 * random.nextDouble()));

                assertThat(at[0]).isCloseTo(px, within(CLOSE));
                assertThat(at[1]).isCloseTo(py, within(CLOSE));
            }
        }
    }

    @Test
    void aPointBehindTheEyeIsNowhere() {
        assertThat(new Projection(new SimpleCamera()).of(new Point(0, 0, 2.5))).isNull();
        Camera parallel = new ParallelCamera(new ParallelCamera.View(0, 0, 2, 0, 0, 0, 5), null, 9, 9);
        assertThat(new Projection(parallel).of(new Point(0, 0, 2.5))).isNull();
        assertThat(new Projection(new SimpleCamera()).of(new Point(0, 0, 0))).containsExactly(new double[] {100, 100}, within(CLOSE));
    }
}
