package simpleray.ui.widget;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.TimeUnit;
import java.util.function.Function;
import java.util.function.UnaryOperator;

/**
 * Asks the desktop whether it is dark.
 *
 * @param system the system's name, as Java has it
 * @param environment answers what an environment variable holds; null if there is none
 * @param command runs a command and answers what it prints; empty if it cannot be run
 * @param home the user's own folder
 */
record DesktopTheme(String system, UnaryOperator<String> environment, Function<List<String>, String> command, Path home) {
    private static final long PATIENCE = 500;                 // milliseconds
    private static final String DARK = "dark";
    private static final List<String> GNOME = List.of("gsettings", "get", "org.gnome.desktop.interface", "color-scheme");
    private static final List<String> GNOME_THEME = List.of("gsettings", "get", "org.gnome.desktop.interface", "gtk-theme");
    private static final List<String> MAC = List.of("defaults", "read", "-g", "AppleInterfaceStyle");
    private static final List<String> WINDOWS = List.of("reg", "query",
        "HKCU\\Software\\Microsoft\\Windows\\CurrentVersion\\Themes\\Personalize", "/v", "AppsUseLightTheme");

    static DesktopTheme ofThisDesktop() {
        return new DesktopTheme(System.getProperty("os.name"), System::getenv, DesktopTheme::run, Path.of(System.getProperty("user.home")));
    }

    /** {@return whether it is dark; false where that cannot be known} */
    boolean isDark() {
        String name = system.toLowerCase(Locale.ROOT);
        if (name.startsWith("windows")) {
            return command.apply(WINDOWS).strip().endsWith("0x0");
        }
        if (name.startsWith("mac")) {
            return saysDark(command.apply(MAC));
        }
        String theme = environment.apply("GTK_THEME");
        if (theme != null && !theme.isBlank()) {
            return saysDark(theme);
        }
        String desktop = environment.apply("XDG_CURRENT_DESKTOP");
        if (desktop != null && desktop.contains("KDE")) {
            return kdeIsDark();
        }
        String scheme = command.apply(GNOME);                 // 'default' leaves it to the theme, as all older desktops do
        return saysDark(scheme) || !scheme.contains("light") && saysDark(command.apply(GNOME_THEME));
    }

    private boolean kdeIsDark() {
        try {
            return Files.readAllLines(home.resolve(".config/kdeglobals"), StandardCharsets.ISO_8859_1).stream()
                .anyMatch(line -> line.startsWith("ColorScheme=") && saysDark(line));
        } catch (IOException e) {
            return false;
        }
    }

    private static boolean saysDark(String words) {
        return words.toLowerCase(Locale.ROOT).contains(DARK);
    }

    /** Runs a command, for half a second at most. */
    private static String run(List<String> command) {
        Process process = null;
        try {
            ProcessBuilder builder = new ProcessBuilder(command).redirectError(ProcessBuilder.Redirect.DISCARD);
            builder.environment().putIfAbsent("HOME", System.getProperty("user.home"));     // else it keeps files where we were started
            process = builder.start();
            process.getOutputStream().close();
            return !process.waitFor(PATIENCE, TimeUnit.MILLISECONDS) ? ""
                : new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
        } catch (IOException e) {
            return "";
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            return "";
        } finally {
            if (process != null) {
                process.destroyForcibly();
            }
        }
    }
}
