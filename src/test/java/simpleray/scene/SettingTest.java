package simpleray.scene;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.lang.reflect.Field;
import java.lang.reflect.Modifier;
import java.nio.file.Files;
import java.util.Arrays;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import simpleray.Project;
import simpleray.SettingSamples;

/** The table of settings is whole, and each entry reads what it writes. */
class SettingTest {
    static List<Setting<?>> all() {
        return Setting.ALL;
    }

    private static List<Field> fields() {
        return Arrays.stream(SceneSettings.class.getFields()).filter(field -> !Modifier.isStatic(field.getModifiers())).toList();
    }

    @Test
    void everyFieldOfTheSettingsHasItsEntry() throws IllegalAccessException {
        Set<String> set = new TreeSet<>();
        for (Setting<?> setting : Setting.ALL) {
            SceneSettings only = SettingSamples.only(setting);
            for (Field field : fields()) {
                if (field.get(only) != null) {
                    set.add(field.getName());
                }
            }
        }

        assertThat(set).hasSameSizeAs(Setting.ALL).containsExactlyInAnyOrderElementsOf(fields().stream().map(Field::getName).toList());
    }

    @Test
    void everyEntryStandsInBothLists() throws IllegalAccessException {
        List<java.lang.Object> declared = Arrays.stream(Setting.class.getFields()).filter(field -> field.getType() == Setting.class)
            .map(SettingTest::value).toList();

        assertThat(Setting.ALL).doesNotHaveDuplicates().hasSameElementsAs(Setting.LINES).isEqualTo(declared);
        assertThat(Setting.LINES).hasSameSizeAs(Setting.ALL);
        assertThat(new HashSet<>(Setting.ALL.stream().map(Setting::name).toList())).hasSameSizeAs(Setting.ALL);
        assertThat(Setting.keywords()).hasSameSizeAs(Setting.ALL);
    }

    private static java.lang.Object value(Field field) {
        try {
            return field.get(null);
        } catch (IllegalAccessException e) {
            throw new AssertionError(e);
        }
    }

    @ParameterizedTest
    @MethodSource("all")
    void aSceneFileAndACommandLineSayTheSame(Setting<?> setting) throws IOException {
        SceneSettings asked = SettingSamples.only(setting);
        String line = asked.lines();

        assertThat(line).startsWith(setting.keyword() + ' ').endsWith("\n");
        assertThat(SceneSettings.isSetting(line.strip())).isTrue();
        assertThat(setting.isSet(SceneSettings.of(line, "a.scene"))).isTrue();
        assertThat(SceneSettings.of(line, "a.scene").lines()).isEqualTo(line);
        assertThat(setting.text(SceneSettings.of(line, "a.scene"))).isEqualTo(SettingSamples.value(setting));
    }

    @ParameterizedTest
    @MethodSource("all")
    void whatIsAskedForWinsOverTheFile(Setting<?> setting) {
        SceneSettings none = new SceneSettings();
        SceneSettings asked = SettingSamples.only(setting);

        assertThat(none.under(asked).lines()).isEqualTo(asked.lines()).isNotEmpty();
        assertThat(asked.under(none).lines()).isEqualTo(asked.lines());
    }

    @ParameterizedTest
    @MethodSource("all")
    void theDefaultIsWhatTheHelpSays(Setting<?> setting) {
        SceneSettings none = new SceneSettings();
        SceneSettings usual = new SceneSettings();
        setting.reset(usual);

        assertThat(setting.isSet(none)).isFalse();
        assertThat(setting.text(none)).isNull();
        assertThat(setting.description()).doesNotContain("%");
        if (setting.isSet(usual)) {
            assertThat(setting.description()).contains("(default: " + setting.text(usual) + ')');
            assertThat(setting.identity(none)).isEqualTo(setting.identity(usual));
            assertThat(setting.in(none)).isNotNull().isSameAs(setting.get(usual));
        }
    }

    @Test
    void settingsOfDifferentCamerasExcludeEachOther() {
        assertThat(Setting.ALL.stream().filter(Setting.CAMERA::excludes)).containsExactly(Setting.COP, Setting.WINDOW, Setting.PARALLEL);
        assertThat(Setting.ALL.stream().filter(Setting.PARALLEL::excludes)).containsExactly(Setting.COP, Setting.WINDOW, Setting.CAMERA);
        assertThat(Setting.ALL.stream().filter(Setting.UP::excludes)).containsExactly(Setting.COP, Setting.WINDOW);
        assertThat(Stream.of(Setting.COP, Setting.WINDOW)).allSatisfy(setting ->
            assertThat(Setting.ALL.stream().filter(setting::excludes)).containsExactly(Setting.CAMERA, Setting.PARALLEL, Setting.UP));
        assertThat(Setting.ALL.stream().filter(setting -> setting.excludes(setting))).isEmpty();
    }

    @Test
    void theCameraOfOthersReplacesAll() {
        SceneSettings settings = SettingSamples.only(Setting.COP);
        settings.depth = 4;
        settings.setCamera(SettingSamples.only(Setting.CAMERA));

        assertThat(settings.lines()).isEqualTo("camera 3.0 2.0 5.0 0.0 0.5 0.0 40.0\ndepth 4\n");
        assertThat(settings.hasCamera()).isTrue();

        settings.setCamera(new SceneSettings());
        assertThat(settings.lines()).isEqualTo("depth 4\n");
        assertThat(settings.hasCamera()).isFalse();
    }

    @Test
    void numbersOfACommandLineAreExact() {
        SceneSettings asked = new SceneSettings();
        asked.window = new SceneSettings.Window(-0.0, 1.0 / 3, -2147483647.0, 1e300);

        assertThat(Setting.WINDOW.text(asked)).isEqualTo("-0.0,0.3333333333333333,-2.147483647E9,1.0E300");
        assertThat(Setting.WINDOW.parse(Setting.WINDOW.text(asked))).isEqualTo(asked.window);
    }

    @ParameterizedTest
    @MethodSource("all")
    void thePageOfTheSceneFormatNamesTheKeyword(Setting<?> setting) throws IOException {
        assertThat(Files.readString(Project.root().resolve("docs/scene-format.md"))).contains("| `" + setting.keyword() + ' ');
    }

    @ParameterizedTest
    @CsvSource(delimiter = ' ', value = {"resolution 640", "resolution 640x", "resolution x480", "resolution 0x1", "resolution 1x0",
        "depth a", "samples 0", "samples 17", "cop a", "camera 1,2,3,0,0,0", "camera 1,2,3,1,2,3,40", "camera 1,2,3,0,0,0,180",
        "parallel 1,2,3,0,0,0,0", "parallel 1,2,3,0,0,0", "up 0,0,0", "up 1,2", "up 1,2,a",
        "background 1,2", "background 1,-2,3", "background some"})
    void whatAnOptionCannotBeIsRefusedByName(String keyword, String value) {
        assertThatThrownBy(() -> Setting.of(keyword).parse(value, new SceneSettings())).isInstanceOf(IllegalArgumentException.class)
            .hasMessageContaining(value);
    }

    @Test
    void sizesAndNumbersAreTakenAtTheirEnds() {
        SceneSettings settings = new SceneSettings();
        Setting.RESOLUTION.parse("1X1", settings);
        Setting.SAMPLES.parse("16", settings);
        Setting.DEPTH.parse("0", settings);

        assertThat(settings.lines()).isEqualTo("resolution 1 1\ndepth 0\nsamples 16\n");
        assertThat(Setting.ALL.stream().filter(Setting::isAlwaysTold)).containsExactly(Setting.RESOLUTION, Setting.DEPTH, Setting.SAMPLES);
    }
}
