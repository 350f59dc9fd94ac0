package simpleray.render;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import simpleray.Project;
import simpleray.image.Picture;
import simpleray.scene.PerspectiveCamera.Pose;
import simpleray.scene.Film;
import simpleray.scene.Reach;
import simpleray.scene.Scene;
import simpleray.scene.SceneFile;
import simpleray.scene.SceneSettings;

/** A scene that is rendered again and again. */
class PreparedSceneTest {
    private static final Pose[] POSES = {null, new Pose(1, 2, 3, 0, 0, -1, 60), new Pose(-2, 0.5, 4, 0, 0, 0, 40), null};

    @ParameterizedTest
    @ValueSource(strings = {"thesis", "many-spheres", "light-ring", "free-camera"})
    void eachRequestGivesThePictureOfASceneJustRead(String name) throws IOException {
        PreparedScene prepared = new PreparedScene(scene(name));
        for (Pose pose : POSES) {
            Picture again = rendered(prepared.renderer(request(pose)));
            Picture anew = request(pose).renderer(scene(name)).render(RenderListener.NONE);

            for (int y = 0; y < anew.height(); y++) {
                assertThat(again.row(y)).as("row " + y + " of " + pose).isEqualTo(anew.row(y));
            }
        }
    }

    @Test
    void optionsOfOneRequestDoNotAffectTheNext() throws IOException {
        PreparedScene prepared = new PreparedScene(scene("free-camera"));
        SceneSettings own = scene("free-camera").settings;
        SceneSettings other = new SceneSettings();
        other.cop = 3.0;
        other.depth = 1;
        other.resolution = new SceneSettings.Resolution(10, 20);

        Picture narrow = rendered(prepared.renderer(new RenderRequest(other, Stage.FINAL, false, 1)));
        Renderer plain = prepared.renderer(new RenderRequest(new SceneSettings(), Stage.FINAL, false, 1));

        assertThat(narrow.width()).isEqualTo(10);
        assertThat(plain.picture().width()).isEqualTo(own.resolution == null ? 200 : own.resolution.width());
    }

    @Test
    void withoutAccelerationAllObjectsAreTested() throws IOException {
        Picture all = rendered(new PreparedScene(scene("thesis")).renderer(request(null).with(Accel.NONE)));
        Picture some = rendered(new PreparedScene(scene("thesis")).renderer(request(null)));

        assertThat(all.row(11)).isEqualTo(some.row(11));
    }

    /** A film of a mesh, a ball, the camera and a light that move, and stand still now and then. */
    @Test
    void framesInTurnAreTheFramesAlone() throws IOException {
        String text = Files.readString(Project.scene("mesh")).replaceAll("camera .*|depth .*", "") + "frames 5 24\ncurve linear\n"
            + "key 0 camera 0 0.75 3.4 0 -0.12 -0.6 43\nkey 1 camera 0.5 0.75 3.4 0 -0.12 -0.6 43\n"
            + "key 1 light 1 0 0 0\nkey 2 light 1 1 0 0\nkey 2 object 3 0 0 0\nkey 3 object 3 0 0.1 0\nkey 3 colour 2 1 0 0\nkey 4 colour 2 0 1 0\n";
        Film film = SceneFile.read(new ByteArrayInputStream(text.getBytes(StandardCharsets.UTF_8)), Project.scene("mesh"), Reach.FOLDER).scene().film();
        PreparedScene prepared = new PreparedScene(film.still(0));
        for (int frame : new int[] {0, 1, 2, 3, 4, 4, 0}) {
            Picture alone = request(null).renderer(film.still(frame)).render(RenderListener.NONE);
            Picture inTurn = prepared.renderer(request(null), film.still(frame)).render(RenderListener.NONE);

            for (int y = 0; y < alone.height(); y++) {
                assertThat(inTurn.row(y)).as("frame %d, row %d", frame, y).isEqualTo(alone.row(y));
            }
        }
    }

    private static Picture rendered(Renderer renderer) {
        return renderer.renderPasses(new PassListener() {
            @Override
            public void runFinished(PixelRun run, double[] rgb) {
                assertThat(rgb).hasSize(3 * run.count());
            }

            @Override
            public void coarseFinished() {
                // known by the picture's pixels
            }

            @Override
            public void rowFailed(int y, Throwable fault) {
                throw new IllegalStateException(fault);
            }

            @Override
            public void rowFinished(int y) {
                assertThat(renderer.picture().row(y)).isNotNull();
            }
        }, null, false);
    }

    private static RenderRequest request(Pose camera) {
        SceneSettings asked = new SceneSettings();
        asked.resolution = new SceneSettings.Resolution(32, 24);
        asked.camera = camera;
        return new RenderRequest(asked, Stage.FINAL, false, 2);
    }

    private static Scene scene(String name) throws IOException {
        return SceneFile.read(Project.scene(name)).scene();
    }
}
