package simpleray.ui.picture;

import java.net.URISyntaxException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.CodeSource;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import simpleray.render.RenderRequest;
import simpleray.render.Stage;
import simpleray.scene.Reach;
import simpleray.scene.Setting;

/** The command line that makes a window's picture without a window. */
public final class CommandWords {
    private CommandWords() {
    }

    /**
     * Says how to make a picture.
     *
     * @param scene the scene's file
     * @param reach which OBJ files it may name
     * @param name the name of the picture's file
     * @param frame the frame, if the scene is a film; 0 for the first
     * @param request what was asked for; what was not is left to the scene's file, as it was in the window
     * @return a line for this system's shell
     */
    public static String line(Path scene, Reach reach, String name, int frame, RenderRequest request) {
        List<String> words = new ArrayList<>(program());
        words.addAll(render(scene, name, request));
        if (frame > 0) {
            words.addAll(List.of("--frame", Integer.toString(frame)));
        }
        if (reach == Reach.ANYWHERE) {
            words.add("--allow-outside");
        }
        boolean windows = System.getProperty("os.name").toLowerCase(Locale.ROOT).startsWith("windows");
        return windows ? ShellWords.windows(words) : ShellWords.posix(words);
    }

    /**
     * {@return the words behind the program's name}
     *
     * @param scene the scene's file
     * @param name the name of the picture's file
     * @param request what was asked for
     */
    public static List<String> render(Path scene, String name, RenderRequest request) {
        List<String> words = new ArrayList<>(List.of("render", scene.toAbsolutePath().toString(), "-o",
            name.startsWith("-") ? "./" + name : name));
        words.addAll(options(request));
        return words;
    }

    /**
     * {@return the options that say which picture is made}
     *
     * @param request what was asked for
     */
    public static List<String> options(RenderRequest request) {
        List<String> words = new ArrayList<>();
        for (Setting<?> setting : Setting.ALL) {
            if (setting == Setting.BACKGROUND && request.region() != null) {
                words.addAll(List.of("--region", request.region().toString()));
            }
            if (setting == Setting.BACKGROUND && request.band() != null) {
                words.addAll(List.of("--band", request.band().toString()));
            }
            String value = setting == Setting.SAMPLES && request.adaptive() ? "adaptive" : setting.text(request.settings());
            if (value != null && setting.option() != null) {
                words.addAll(List.of(setting.option(), value));
            }
            if (setting == Setting.RESOLUTION && request.stage() != Stage.FINAL) {
                words.addAll(List.of("--stage", request.stage().toString()));
            }
        }
        return words;
    }

    /** {@return the words that start this program again} */
    private static List<String> program() {
        String packaged = System.getProperty("jpackage.app-path");
        if (packaged != null) {
            return List.of(packaged);
        }
        CodeSource source = CommandWords.class.getProtectionDomain().getCodeSource();
        try {
            Path jar = source == null ? Path.of("") : Path.of(source.getLocation().toURI());
            if (jar.toString().endsWith(".jar")) {
                Path script = jar.resolveSibling(Path.of("..", "..", "simpleray")).normalize();   // that of a checkout
                return Files.isRegularFile(script) && Files.isExecutable(script) ? List.of(script.toString())
                    : List.of("java", "-jar", jar.toString());
            }
        } catch (URISyntaxException | RuntimeException e) {
            return List.of("simpleray");
        }
        return List.of("simpleray");
    }
}
