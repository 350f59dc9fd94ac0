package simpleray.ui.widget;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Whether the desktop is dark, by what desktops answer. */
class DesktopThemeTest {
    @TempDir
    private Path home;

    @ParameterizedTest
    @CsvSource({
        "color-scheme, 'prefer-dark', default, true", "color-scheme, 'default', Adwaita, false",
        "color-scheme, 'default', Yaru-dark, true", "color-scheme, 'prefer-light', Yaru-dark, false"})
    void gnomeIsAskedForItsSchemeAndThenItsTheme(String key, String scheme, String theme, boolean dark) {
        assertThat(new DesktopTheme("Linux", name -> null, words -> words.contains(key) ? scheme : theme, home).isDark()).isEqualTo(dark);
    }

    @ParameterizedTest
    @CsvSource({"Adwaita:dark, true", "Adwaita, false"})
    void aThemeOfTheEnvironmentWins(String theme, boolean dark) {
        assertThat(new DesktopTheme("Linux", Map.of("GTK_THEME", theme)::get, words -> "prefer-" + (dark ? "light" : "dark"), home)
            .isDark())
            .isEqualTo(dark);
    }

    @Test
    void kdeKeepsItInAFile() throws IOException {
        DesktopTheme kde = new DesktopTheme("Linux", Map.of("XDG_CURRENT_DESKTOP", "KDE")::get, words -> "prefer-dark", home);
        assertThat(kde.isDark()).isFalse();

        Files.createDirectory(home.resolve(".config"));
        Files.writeString(home.resolve(".config/kdeglobals"), "[General]\nColorScheme=BreezeDark\n");
        assertThat(kde.isDark()).isTrue();
    }

    @ParameterizedTest
    @CsvSource({"'    AppsUseLightTheme    REG_DWORD    0x0\r\n', true",
        "'    AppsUseLightTheme    REG_DWORD    0x1\r\n', false", "'', false"})
    void windowsKeepsItInTheRegistry(String answer, boolean dark) {
        assertThat(new DesktopTheme("Windows 11", name -> null, words -> words.get(0).equals("reg") ? answer : "", home).isDark())
            .isEqualTo(dark);
    }

    @ParameterizedTest
    @CsvSource({"Dark, true", "'', false"})
    void aMacTellsItIfItIsDark(String answer, boolean dark) {
        assertThat(new DesktopTheme("Mac OS X", name -> null, words -> words.get(0).equals("defaults") ? answer : "", home).isDark())
            .isEqualTo(dark);
    }

    @Test
    void itIsLightWhereNobodyAnswers() {
        assertThat(new DesktopTheme("Linux", name -> null, words -> "", home).isDark()).isFalse();
    }
}
