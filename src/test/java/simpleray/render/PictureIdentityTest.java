package simpleray.render;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Map;
import org.junit.jupiter.api.Test;
import simpleray.math.Colour;
import simpleray.scene.PerspectiveCamera.Pose;
import simpleray.scene.Scene;
import simpleray.scene.SceneHash;
import simpleray.scene.SceneSettings;
import simpleray.scene.SceneSettings.Resolution;
import simpleray.scene.SceneSettings.Window;

class PictureIdentityTest {
    private static Map<String, String> of(SceneSettings asked, Stage stage, boolean adaptive, Accel accel, int threads) {
        Scene scene = new Scene();
        RenderRequest request = new RenderRequest(asked, stage, adaptive, accel, threads, null, null);
        request.renderer(scene);
        return PictureIdentity.of("1.2", request, scene);
    }

    private static Map<String, String> of(SceneSettings asked) {
        return of(asked, Stage.FINAL, false, Accel.AUTO, 2);
    }

    @Test
    void whatIsNotAskedForHasItsDefault() {
        assertThat(of(new SceneSettings())).containsExactly(Map.entry("version", "1.2"), Map.entry("scene", SceneHash.of(new Scene())),
            Map.entry("size", "200x200"), Map.entry("stage", "final"), Map.entry("depth", "10"), Map.entry("samples", "1"),
            Map.entry("cop", "2.0"), Map.entry("window", "default"), Map.entry("background", "0.0,0.0,0.0"));
    }

    @Test
    void whatIsAskedForIsTold() {
        SceneSettings asked = new SceneSettings();
        asked.resolution = new Resolution(40, 30);
        asked.depth = 3;
        asked.samples = 4;
        asked.cop = 2.5;
        asked.window = new Window(-1, 1, -2, 0.5);
        asked.background = new Colour(0.25, 0, 1);

        assertThat(of(asked)).contains(Map.entry("size", "40x30"), Map.entry("depth", "3"), Map.entry("samples", "4"),
            Map.entry("cop", "2.5"), Map.entry("window", "-1.0,1.0,-2.0,0.5"), Map.entry("background", "0.25,0.0,1.0"));
        assertThat(of(asked, Stage.AMBIENT, true, Accel.AUTO, 1)).contains(Map.entry("stage", "ambient"), Map.entry("samples", "adaptive"));
    }

    @Test
    void aCameraStandsForCopAndWindow() {
        SceneSettings asked = new SceneSettings();
        asked.camera = new Pose(3, 2, 5, 0, 0.5, 0, 40);

        assertThat(of(asked)).contains(Map.entry("camera", "3.0,2.0,5.0,0.0,0.5,0.0,40.0")).doesNotContainKeys("cop", "window");
        assertThat(PictureIdentity.difference(of(asked), of(new SceneSettings()))).isEqualTo("a camera, no cop, no window");
        assertThat(PictureIdentity.difference(of(new SceneSettings()), of(asked))).isEqualTo("a cop, a window, no camera");
    }

    @Test
    void threadsAndTheWayToFindObjectsDoNotCount() {
        Map<String, String> one = of(new SceneSettings(), Stage.FINAL, false, Accel.NONE, 1);

        assertThat(PictureIdentity.difference(one, of(new SceneSettings()))).isEmpty();
    }

    @Test
    void allDifferencesAreTold() {
        Map<String, String> one = Map.of("scene", "abc");

        assertThat(PictureIdentity.difference(one, Map.of("scene", "abd"))).isEqualTo("another scene");
        assertThat(PictureIdentity.difference(of(new SceneSettings(), Stage.FINAL, true, Accel.AUTO, 1),
            of(new SceneSettings(), Stage.DIFFUSE, false, Accel.AUTO, 1))).isEqualTo("stage final (now diffuse), samples adaptive (now 1)");
    }
}
