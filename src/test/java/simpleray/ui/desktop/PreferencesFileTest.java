package simpleray.ui.desktop;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.HashMap;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Where the preferences lie. */
class PreferencesFileTest {
    private final Map<String, String> properties = new HashMap<>(Map.of("os.name", "Linux", "user.home", "/home/ada"));
    private final Map<String, String> environment = new HashMap<>();

    @ParameterizedTest
    @CsvSource({"Linux, /home/ada/.config/simpleray/window.properties", "FreeBSD, /home/ada/.config/simpleray/window.properties",
        "Mac OS X, /home/ada/Library/Application Support/simpleray/window.properties",
        "Windows 11, /home/ada/AppData/Roaming/simpleray/window.properties"})
    void eachSystemHasItsOwnFolderForThem(String system, String expected) {
        properties.put("os.name", system);

        assertThat(found()).isEqualTo(Path.of(expected));
    }

    @Test
    void windowsMayNameAnother() {
        properties.put("os.name", "Windows 10");
        environment.put("APPDATA", "/d/roaming");

        assertThat(found()).isEqualTo(Path.of("/d/roaming/simpleray/window.properties"));
    }

    @ParameterizedTest
    @CsvSource({"/etc/ada, /etc/ada", "relative, /home/ada/.config", "'', /home/ada/.config"})
    void xdgConfigHomeCountsIfItIsAbsolute(String value, String expected) {
        environment.put("XDG_CONFIG_HOME", value);

        assertThat(found()).isEqualTo(Path.of(expected, "simpleray", "window.properties"));
    }

    @ParameterizedTest
    @CsvSource({"Linux, /srv/ada, /srv/ada/.config", "Mac OS X, /srv/ada, /srv/ada/Library/Application Support",
        "Linux, relative, /home/ada/.config", "Linux, '', /home/ada/.config", "Windows 11, /srv/ada, /home/ada/AppData/Roaming"})
    void theHomeIsThatOfTheVariable(String system, String value, String expected) {
        properties.put("os.name", system);
        environment.put("HOME", value);

        assertThat(found()).isEqualTo(Path.of(expected, "simpleray", "window.properties"));
    }

    @Test
    void xdgConfigHomeCountsBeforeTheVariableHome() {
        environment.putAll(Map.of("HOME", "/srv/ada", "XDG_CONFIG_HOME", "/etc/ada"));

        assertThat(found()).isEqualTo(Path.of("/etc/ada/simpleray/window.properties"));
    }

    @Test
    void theUserMayNameAFileByAVariableOrAProperty() {
        environment.put("SIMPLERAY_PREFERENCES", "/tmp/by-variable");
        assertThat(found()).isEqualTo(Path.of("/tmp/by-variable"));

        properties.put("simpleray.preferences", "/tmp/by-property");
        assertThat(found()).isEqualTo(Path.of("/tmp/by-property"));
    }

    @ParameterizedTest
    @CsvSource({"none", "'/nul\0'"})
    void noFileIsUsedWhereTheUserWantsNoneOrThereCanBeNone(String said) {
        environment.put("SIMPLERAY_PREFERENCES", said);

        assertThat(found()).isNull();
    }

    @ParameterizedTest
    @CsvSource({"?", "''"})
    void aUserWithoutAHomeHasNoFile(String home) {
        properties.put("user.home", home);

        assertThat(found()).isNull();
    }

    private Path found() {
        return PreferencesFile.find(properties::get, environment::get);
    }
}
