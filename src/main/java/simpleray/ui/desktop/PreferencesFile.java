package simpleray.ui.desktop;

import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.Locale;
import java.util.function.UnaryOperator;

/** Where the preferences lie: where the user says, else where the system wants such files. */
public final class PreferencesFile {
    /** The system property that names the file. */
    static final String PROPERTY = "simpleray.preferences";
    /** The environment variable that names the file. */
    static final String VARIABLE = "SIMPLERAY_PREFERENCES";
    /** In place of a file's name: nothing is remembered. */
    static final String NONE = "none";

    private static final String NAME = "window.properties";
    private static final String FOLDER = "simpleray";

    private PreferencesFile() {
    }

    /** {@return the file; null if nothing is to be remembered} */
    public static Path find() {
        return find(System::getProperty, System::getenv);
    }

    static Path find(UnaryOperator<String> property, UnaryOperator<String> environment) {
        String said = first(property.apply(PROPERTY), environment.apply(VARIABLE));
        try {
            if (said != null && !said.isEmpty()) {
                return said.equals(NONE) ? null : Path.of(said).toAbsolutePath();
            }
            Path folder = folder(property, environment);
            return folder.isAbsolute() ? folder.resolve(FOLDER).resolve(NAME) : null;   // a user without a home
        } catch (InvalidPathException e) {
            return null;
        }
    }

    private static Path folder(UnaryOperator<String> property, UnaryOperator<String> environment) {
        String system = first(property.apply("os.name"), "").toLowerCase(Locale.ROOT);
        Path home = Path.of(first(property.apply("user.home"), ""));
        if (system.startsWith("windows")) {
            String roaming = first(environment.apply("APPDATA"), null);
            return roaming != null ? Path.of(roaming) : home.resolve("AppData").resolve("Roaming");
        }
        Path said = Path.of(first(environment.apply("HOME"), ""));
        home = said.isAbsolute() ? said : home;               // Java's own is that of /etc/passwd
        if (system.startsWith("mac")) {
            return home.resolve("Library").resolve("Application Support");
        }
        String asked = first(environment.apply("XDG_CONFIG_HOME"), null);
        // the XDG base directory specification has relative ones ignored
        return asked != null && Path.of(asked).isAbsolute() ? Path.of(asked) : home.resolve(".config");
    }

    private static String first(String one, String other) {
        return one != null && !one.isEmpty() ? one : other;
    }
}
