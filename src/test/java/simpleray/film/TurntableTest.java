package simpleray.film;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import simpleray.math.Vector;
import simpleray.render.RenderRequest;
import simpleray.scene.ParallelCamera;
import simpleray.scene.PerspectiveCamera.Pose;
import simpleray.scene.SceneSettings;

class TurntableTest {
    private static final double NEAR = 1e-12;

    private static Turntable table(SceneSettings scene, SceneSettings asked, int frames) {
        return new Turntable(scene, new RenderRequest().with(asked), frames);
    }

    private static SceneSettings camera(double... n) {
        SceneSettings settings = new SceneSettings();
        settings.camera = new Pose(n[0], n[1], n[2], n[3], n[4], n[5], n[6]);
        return settings;
    }

    private static void assertPose(Pose pose, double... n) {
        assertThat(new double[] {pose.ex(), pose.ey(), pose.ez(), pose.lx(), pose.ly(), pose.lz(), pose.fov()})
            .containsExactly(n, within(NEAR));
    }

    @Test
    void theCameraGoesOnceRoundToItsRight() {
        Turntable table = table(camera(1, 3, 6, 1, 2, 2, 40), new SceneSettings(), 4);

        assertThat(table.camera(0).camera).isEqualTo(new Pose(1, 3, 6, 1, 2, 2, 40));
        assertPose(table.camera(1).camera, 5, 3, 2, 1, 2, 2, 40);
        assertPose(table.camera(2).camera, 1, 3, -2, 1, 2, 2, 40);
        assertPose(table.camera(3).camera, -3, 3, 2, 1, 2, 2, 40);
        assertPose(table.camera(4).camera, 1, 3, 6, 1, 2, 2, 40);
    }

    @Test
    void theThesissCameraGoesRoundTheMiddleOfItsWindow() {
        Turntable table = table(new SceneSettings(), new SceneSettings(), 2);

        assertPose(table.camera(0).camera, 0, 0, 2, 0, 0, 0, 90);
        assertPose(table.camera(1).camera, 0, 0, -2, 0, 0, 0, 90);
    }

    @Test
    void parallelRaysKeepTheirHeightAndGoRoundUp() {
        SceneSettings scene = new SceneSettings();
        scene.parallel = new ParallelCamera.View(1, -3, 4, 1, 2, 3, 7);
        scene.up = new Vector(0, 0, 2);
        Turntable table = table(scene, new SceneSettings(), 4);

        assertThat(table.settings(0).lines()).isEqualTo("parallel 1.0 -3.0 4.0 1.0 2.0 3.0 7.0\nup 0.0 0.0 2.0\n");
        ParallelCamera.View quarter = table.settings(1).parallel;
        assertThat(new double[] {quarter.ex(), quarter.ey(), quarter.ez(), quarter.lx(), quarter.ly(), quarter.lz(), quarter.height()})
            .containsExactly(new double[] {6, 2, 4, 1, 2, 3, 7}, within(NEAR));
        assertThat(table.settings(1).up).isSameAs(scene.up);
    }

    @Test
    void whatIsAskedForWinsAndStays() {
        SceneSettings asked = new SceneSettings();
        asked.cop = 4.0;
        asked.depth = 3;

        SceneSettings settings = table(new SceneSettings(), asked, 2).settings(1);

        assertThat(settings.depth).isEqualTo(3);
        assertThat(settings.cop).isNull();
        assertThat(asked.cop).isEqualTo(4);
        assertPose(settings.camera, 0, 0, -4, 0, 0, 0, settings.camera.fov());
        assertThat(table(camera(9, 9, 9, 0, 0, 0, 50), camera(0, 0, 3, 0, 0, 0, 60), 1).settings(0).camera)
            .isEqualTo(new Pose(0, 0, 3, 0, 0, 0, 60));
    }
}
