package simpleray.cli;

import java.util.Locale;
import simpleray.render.RenderRequest;
import simpleray.render.Stage;
import simpleray.scene.SceneSettings;
import simpleray.scene.Setting;

/** The options that say which picture is made of a scene: those of the table of settings. What they say wins over the scene file. */
final class PictureOptions extends OptionGroup {
    private static final String ADAPTIVE = "adaptive";

    private final SceneSettings asked = new SceneSettings();
    /** A number, or adaptive, which no scene file says. */
    private final CommandOption<String> samples =
        CommandOption.text(Setting.SAMPLES.label(), Setting.SAMPLES.description(), Setting.SAMPLES.option());

    PictureOptions() {
        for (Setting<?> setting : Setting.ALL) {
            if (setting == Setting.SAMPLES) {
                add(samples);
            } else if (setting.option() != null) {
                add(CommandOption.of(setting, asked));
            }
        }
    }

    /**
     * Puts together what was asked for.
     *
     * @throws CommandException if something is out of its range
     */
    RenderRequest request(Stage stage, int threads) throws CommandException {
        try {
            boolean adaptive = samples.value() != null && samples.value().toLowerCase(Locale.ROOT).equals(ADAPTIVE);
            if (samples.value() != null && !adaptive) {
                Setting.SAMPLES.parse(samples.value(), asked);
            }
            if (asked.camera != null && (asked.cop != null || asked.window != null)) {
                throw CommandException.usage("--camera takes the place of --cop and --window: give one or the other");
            }
            if (asked.parallel != null && (asked.camera != null || asked.cop != null || asked.window != null)) {
                throw CommandException.usage("--parallel takes the place of --camera, --cop and --window: give one or the other");
            }
            if (asked.up != null && (asked.cop != null || asked.window != null)) {
                throw CommandException.usage("--up goes with --camera or --parallel, not with --cop and --window");
            }
            RenderRequest request = new RenderRequest(asked, stage, adaptive, threads);
            request.check();                                  // what is out of its range is known before the scene is read
            return request;
        } catch (IllegalArgumentException e) {
            throw CommandException.usage(e.getMessage());
        }
    }
}
