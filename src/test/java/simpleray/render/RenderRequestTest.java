package simpleray.render;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.lang.reflect.RecordComponent;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import simpleray.SettingSamples;
import simpleray.image.Picture;
import simpleray.image.PictureText;
import simpleray.math.Colour;
import simpleray.scene.PictureScene;
import simpleray.scene.Scene;
import simpleray.scene.SceneFile;
import simpleray.scene.SceneSettings;
import simpleray.scene.Setting;

/** What is asked for decides about the picture, and leaves the scene as it is; nothing of it is missing in the picture's description. */
class RenderRequestTest {
    private static final String SCENE = "1  0 0 0 -1 1  1 1 1  0.5 0.5 0.5  0.1 0.1 0.1  5  0.2 0.2 0.2  0\n";
    /** A request that differs from the plain one in this component alone, for each that decides about pixels, beside the settings. */
    private static final Map<String, RenderRequest> OTHERS = Map.of("stage", new RenderRequest().with(Stage.DIFFUSE),
        "adaptive", new RenderRequest(new SceneSettings(), Stage.FINAL, true, 1),
        "region", new RenderRequest().with(new Region(1, 2, 3, 4)), "band", new RenderRequest().with(new Band(2, 3)));

    static List<Setting<?>> all() {
        return SettingSamples.withOption();
    }

    private static Map<String, String> identity(RenderRequest request, String settings) throws IOException {
        return PictureIdentity.of("1.2", request, SceneFile.parse(SCENE + settings).scene());
    }

    private static String told(RenderRequest request, String settings) throws IOException {
        List<PictureText> texts = Provenance.of(request, SceneFile.parse(SCENE + settings));
        return texts.stream().filter(text -> text.keyword().equals("simpleray.options")).findFirst().orElseThrow().string();
    }

    private static RenderRequest again(String told) throws IOException {
        Map<Boolean, List<String>> lines = told.lines().collect(Collectors.partitioningBy(
            line -> Setting.keywords().contains(line.split(" ")[0]) && !line.endsWith("adaptive")));
        SceneSettings settings = SceneSettings.of(String.join("\n", lines.get(true)), "a.png");
        return Provenance.request(new PictureScene("a.png", "SimpleRay", settings, lines.get(false), null), Accel.AUTO, 1);
    }

    @ParameterizedTest
    @MethodSource("all")
    void aSettingIsPartOfAPicturesIdentity(Setting<?> setting) throws IOException {
        SceneSettings only = SettingSamples.inScene(setting);
        Map<String, String> asked = identity(new RenderRequest().with(only), "");

        assertThat(asked).containsKey(setting.name()).isNotEqualTo(identity(new RenderRequest(), ""));
        assertThat(identity(new RenderRequest(), only.lines())).as("of a scene file").isEqualTo(asked);
        assertThat(PictureIdentity.difference(asked, identity(new RenderRequest(), ""))).contains(setting.name());
    }

    @ParameterizedTest
    @MethodSource("all")
    void aPictureTellsASetting(Setting<?> setting) throws IOException {
        SceneSettings only = SettingSamples.inScene(setting);
        String told = told(new RenderRequest().with(only), "");

        assertThat(told).contains('\n' + only.lines());
        assertThat(told(new RenderRequest(), only.lines())).as("of a scene file").isEqualTo(told);
        assertThat(setting.text(again(told).settings())).isEqualTo(setting.text(only));
    }

    @Test
    void whatElseIsAskedForIsToldAsWell() throws IOException {
        assertThat(Arrays.stream(RenderRequest.class.getRecordComponents()).map(RecordComponent::getName))
            .as("what is new here and decides about pixels has an example above, and stands in PictureIdentity, Provenance and CommandWords")
            .containsExactlyInAnyOrder("settings", "stage", "adaptive", "region", "band", "accel", "threads");
        for (RenderRequest other : OTHERS.values()) {
            assertThat(identity(other, "")).isNotEqualTo(identity(new RenderRequest(), ""));
            assertThat(told(other, "")).isNotEqualTo(told(new RenderRequest(), ""));
            RenderRequest again = again(told(other, ""));
            assertThat(List.of(again.stage(), again.adaptive())).isEqualTo(List.of(other.stage(), other.adaptive()));
            assertThat(again.region()).isEqualTo(other.region());
            assertThat(again.band()).isEqualTo(other.band());
        }
    }

    @Test
    void theSceneStaysAsItIs() throws IOException {
        Scene scene = SceneFile.parse(SCENE + "resolution 5 4\nbackground 1 0 0\ncamera 9 9 9 0 0 0 40\n").scene();
        SceneSettings own = scene.settings;
        String before = own.lines();
        SceneSettings asked = new SceneSettings();
        asked.resolution = new SceneSettings.Resolution(2, 1);
        asked.background = new Colour(0, 1, 0);
        asked.cop = 3.0;

        Picture green = new RenderRequest().with(asked).renderer(scene).render(RenderListener.NONE);
        Picture red = new RenderRequest().renderer(scene).render(RenderListener.NONE);

        assertThat(scene.settings).isSameAs(own);
        assertThat(own.lines()).isEqualTo(before);
        assertThat(List.of(green.width(), green.height(), red.width(), red.height())).containsExactly(2, 1, 5, 4);
        assertThat(red.row(0)).startsWith(1, 0, 0);
        assertThat(new RenderRequest().with(asked).applyTo(scene).settings.lines())
            .isEqualTo("background 0.0 1.0 0.0\ncop 3.0\nresolution 2 1\n");
    }

    @Test
    void aBackgroundThatIsAskedForIsSeen() throws IOException {
        Scene empty = SceneFile.parse("0 0 0 0 0\nresolution 1 1").scene();
        RenderRequest request = new RenderRequest().with(SettingSamples.only(Setting.BACKGROUND));

        Picture picture = request.renderer(empty).render(RenderListener.NONE);

        assertThat(picture.row(0)).containsExactly(0.1, 0.2, 0.4);
    }

    @Test
    void whatIsOutOfItsRangeIsRefusedWithoutAScene() {
        SceneSettings depth = new SceneSettings();
        depth.depth = 2000;
        SceneSettings both = new SceneSettings();
        both.depth = 2000;
        both.cop = 0.0;

        new RenderRequest().check();
        assertThatThrownBy(() -> new RenderRequest().with(depth).check()).isInstanceOf(IllegalArgumentException.class)
            .hasMessage("the depth must be 0 to 1000, and is 2000");
        assertThatThrownBy(() -> new RenderRequest().with(both).check()).isInstanceOf(IllegalArgumentException.class)
            .hasMessage("the centre of projection must be above 0, and is 0.0");
    }
}
