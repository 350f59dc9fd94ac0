package simpleray.render;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import simpleray.image.Picture;
import simpleray.scene.Scene;
import simpleray.scene.SceneFile;
import simpleray.scene.SceneSettings;

/** Pictures by parallel rays. */
class ParallelPicturesTest {
    private static Scene scene(String name) throws IOException {
        return SceneFile.read(Path.of(System.getProperty("simpleray.scenes"), name + ".scene")).scene();
    }

    private static Picture picture(Scene scene, String settings, Accel accel, int threads) throws IOException {
        return new RenderRequest(SceneSettings.of(settings, "a"), Stage.FINAL, false, threads).with(accel).renderer(scene)
            .render(RenderListener.NONE);
    }

    private static void assertSame(Picture actual, Picture expected) {
        for (int y = 0; y < expected.height(); y++) {
            assertThat(actual.row(y)).as("row %d", y).isEqualTo(expected.row(y));
        }
    }

    /** Scenes with a grid, with a tree, with a mesh and with few objects. */
    @ParameterizedTest
    @CsvSource({"many-spheres", "sphere-flake", "mesh", "thesis", "impossible-triangle"})
    void theyAreTheSameWithoutStructuresAndOnAnyNumberOfThreads(String name) throws IOException {
        String settings = "parallel 4 3 5 0 -0.5 -3 5\nup 0.3 1 0.1\nresolution 40 30\n";
        Picture plain = picture(scene(name), settings, Accel.NONE, 1);

        assertSame(picture(scene(name), settings, Accel.AUTO, 1), plain);
        assertSame(picture(scene(name), settings, Accel.AUTO, 3), plain);
    }

    /** What is compiled for an eye, parallel rays and another eye is right for each of them. */
    @ParameterizedTest
    @EnumSource(value = Accel.class, names = {"AUTO"})
    void aPreparedSceneServesBothKindsOfRays(Accel accel) throws IOException {
        Scene scene = scene("many-spheres");
        PreparedScene prepared = new PreparedScene(scene);
        for (String camera : new String[] {"camera 0 0 9 0 0 0 40", "parallel 0 0 9 0 0 0 6", "parallel 9 0 0 0 0 0 6", "camera 9 0 0 0 0 0 40"}) {
            SceneSettings asked = SceneSettings.of(camera + "\nresolution 24 18\n", "a");
            RenderRequest request = new RenderRequest(asked, Stage.FINAL, false, 2).with(accel);

            assertSame(prepared.renderer(request).render(RenderListener.NONE), picture(scene, asked.lines(), Accel.NONE, 1));
        }
    }

    /** From very far away, perspective is none: a field of view that is 4 high at a distance of 1e7. */
    @Test
    void aPerspectiveCameraFarAwaySeesTheSame() throws IOException {
        double fov = Math.toDegrees(2 * Math.atan(2e-7));
        Picture far = picture(scene("ball-pyramid"), "camera 0 6000000 8000000 0 0 0 " + fov + "\nresolution 40 40\n", Accel.AUTO, 2);
        Picture parallel = picture(scene("ball-pyramid"), "parallel 0 60 80 0 0 0 4\nresolution 40 40\n", Accel.AUTO, 2);

        int different = 0;
        for (int y = 0; y < 40; y++) {
            byte[] expected = far.levels(y);
            byte[] actual = parallel.levels(y);
            for (int i = 0; i < expected.length; i++) {
                different += Math.abs((expected[i] & 0xFF) - (actual[i] & 0xFF)) > 1 ? 1 : 0;
            }
        }
        assertThat(different).as("levels beside edges").isLessThanOrEqualTo(40 * 40 * 3 / 200);
    }
}
