package simpleray;

import static java.util.Map.entry;
import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.List;
import java.util.Map;
import simpleray.scene.SceneSettings;
import simpleray.scene.Setting;

/** A value for each setting of the table, other than its default, so that tests can walk the table. */
public final class SettingSamples {
    private static final Map<String, String> VALUES = Map.ofEntries(entry("resolution", "16x12"), entry("depth", "3"),
        entry("samples", "2"), entry("cop", "3.5"), entry("window", "-1,1.25,-0.5,1"), entry("camera", "3,2,5,0,0.5,0,40"),
        entry("parallel", "3,2,5,0,0.5,0,4"), entry("up", "0.5,2,-0.25"), entry("background", "0.1,0.2,0.4"),
        entry("frames", "24,12.5"), entry("curve", "linear"), entry("key", "1.5,camera,3,2,5,0,0.5,0,40"));

    private SettingSamples() {
    }

    /** {@return the settings that an option sets, too; others belong to a film, not to a picture} */
    public static List<Setting<?>> withOption() {
        return Setting.ALL.stream().<Setting<?>>map(setting -> setting).filter(setting -> setting.option() != null).toList();
    }

    /** {@return a setting's value as on a command line} */
    public static String value(Setting<?> setting) {
        assertThat(VALUES).as("a new setting has a value here").containsKey(setting.keyword());
        return VALUES.get(setting.keyword());
    }

    /** {@return settings of which only this one is set} */
    public static SceneSettings only(Setting<?> setting) {
        if (setting.option() == null) {
            try {
                return SceneSettings.of(setting.keyword() + ' ' + value(setting).replace(',', ' '), "a.scene");
            } catch (IOException e) {
                throw new UncheckedIOException(e);
            }
        }
        SceneSettings settings = new SceneSettings();
        setting.parse(value(setting), settings);
        return settings;
    }

    /** {@return settings as {@link #only}, and a camera beside up, which a scene file must have} */
    public static SceneSettings inScene(Setting<?> setting) {
        SceneSettings settings = only(setting);
        if (setting == Setting.UP) {
            Setting.CAMERA.parse(value(Setting.CAMERA), settings);
        }
        return settings;
    }
}
