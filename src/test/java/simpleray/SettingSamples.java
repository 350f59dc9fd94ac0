package simpleray;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Map;
import simpleray.scene.SceneSettings;
import simpleray.scene.Setting;

/** A value for each setting of the table, other than its default, so that tests can walk the table. */
public final class SettingSamples {
    private static final Map<String, String> VALUES = Map.of("resolution", "16x12", "depth", "3", "samples", "2", "cop", "3.5",
        "window", "-1,1.25,-0.5,1", "camera", "3,2,5,0,0.5,0,40", "background", "0.1,0.2,0.4");

    private SettingSamples() {
    }

    /** {@return a setting's value as on a command line} */
    public static String value(Setting<?> setting) {
        assertThat(VALUES).as("a new setting has a value here").containsKey(setting.keyword());
        return VALUES.get(setting.keyword());
    }

    /** {@return settings of which only this one is set} */
    public static SceneSettings only(Setting<?> setting) {
        SceneSettings settings = new SceneSettings();
        setting.parse(value(setting), settings);
        return settings;
    }
}
