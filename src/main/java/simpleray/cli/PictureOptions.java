package simpleray.cli;

import java.util.Locale;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Model.ISetter;
import picocli.CommandLine.Model.OptionSpec;
import picocli.CommandLine.Spec;
import picocli.CommandLine.TypeConversionException;
import simpleray.render.RenderRequest;
import simpleray.render.Stage;
import simpleray.scene.SceneSettings;
import simpleray.scene.Setting;

/** The options that say which picture is made of a scene: those of the table of settings. What they say wins over the scene file. */
@Command
final class PictureOptions {
    private static final String ADAPTIVE = "adaptive";

    private final SceneSettings asked = new SceneSettings();
    private String samples;                                   // a number, or adaptive, which no scene file says

    /** Adds the options to a command; picocli calls this. */
    @Spec(Spec.Target.MIXEE)
    void addTo(CommandSpec command) {
        for (Setting<?> setting : Setting.ALL) {
            if (setting.option() != null) {
                command.addOption(Model.option(setting, this));
            }
        }
    }

    /** Picocli's model of the options: a class of its own, so that a plain line loads no class of picocli. */
    private static final class Model {
        static OptionSpec option(Setting<?> setting, PictureOptions options) {
            return OptionSpec.builder(setting.option()).paramLabel(setting.label()).description(setting.description()).type(String.class)
                .converters(value -> checked(setting, value)).setter(new ISetter() {
                    @Override
                    public <V> V set(V value) {
                        if (value != null) {                  // as before it is parsed
                            options.take(setting.option(), (String) value);
                        }
                        return value;
                    }
                }).build();
        }

        private static String checked(Setting<?> setting, String value) {
            try {
                if (setting != Setting.SAMPLES) {
                    setting.parse(value);
                }
                return value;
            } catch (IllegalArgumentException e) {
                throw new TypeConversionException(e.getMessage());
            }
        }
    }

    /**
     * Takes an option.
     *
     * @return whether it is one of these
     * @throws IllegalArgumentException if it cannot have that value
     */
    boolean take(String name, String value) {
        for (Setting<?> setting : Setting.ALL) {
            if (name.equals(setting.option())) {
                if (setting == Setting.SAMPLES) {
                    samples = value;
                } else {
                    setting.parse(value, asked);
                }
                return true;
            }
        }
        return false;
    }

    /**
     * Puts together what was asked for.
     *
     * @throws CommandException if something is out of its range
     */
    RenderRequest request(Stage stage, int threads) throws CommandException {
        try {
            boolean adaptive = samples != null && samples.toLowerCase(Locale.ROOT).equals(ADAPTIVE);
            if (samples != null && !adaptive) {
                Setting.SAMPLES.parse(samples, asked);
            }
            if (asked.camera != null && (asked.cop != null || asked.window != null)) {
                throw CommandException.usage("--camera takes the place of --cop and --window: give one or the other");
            }
            RenderRequest request = new RenderRequest(asked, stage, adaptive, threads);
            request.check();                                  // what is out of its range is known before the scene is read
            return request;
        } catch (IllegalArgumentException e) {
            throw CommandException.usage(e.getMessage());
        }
    }
}
