package simpleray.cli;

import java.util.ArrayList;
import java.util.List;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Model.ISetter;
import picocli.CommandLine.Model.OptionSpec;
import picocli.CommandLine.Spec;
import picocli.CommandLine.TypeConversionException;

/** Options that stand together in the help of a command, as a mixin of picocli's; several commands may have the same. */
@Command
class OptionGroup {
    private final List<CommandOption<?>> options = new ArrayList<>();

    /** Adds an option behind the others. {@return the option} */
    final <T> CommandOption<T> add(CommandOption<T> option) {
        options.add(option);
        return option;
    }

    /** {@return the options, in the order of the help} */
    final List<CommandOption<?>> options() {
        return options;
    }

    /** Adds the options to a command; picocli calls this. */
    @Spec(Spec.Target.MIXEE)
    final void addTo(CommandSpec command) {
        for (CommandOption<?> option : options) {
            command.addOption(Model.of(option));
        }
    }

    /** Picocli's model of an option: a class of its own, so that a plain line loads no class of picocli. */
    private static final class Model {
        static OptionSpec of(CommandOption<?> option) {
            OptionSpec.Builder model = OptionSpec.builder(option.names.toArray(new String[0])).description(option.description)
                .required(option.required).setter(new ISetter() {
                    @Override
                    public <V> V set(V value) {
                        if (value != null) {                  // as before the line is read
                            option.take(value.toString());
                        }
                        return value;
                    }
                });
            if (option.isFlag()) {
                return model.type(boolean.class).build();
            }
            if (option.initial != null) {
                model.defaultValue(option.initial.toString());
            }
            if (!option.candidates().isEmpty()) {
                model.completionCandidates(option.candidates());
            }
            return model.type(String.class).paramLabel(option.label).converters(text -> checked(option, text)).build();
        }

        private static String checked(CommandOption<?> option, String text) {
            try {
                option.parse(text);
                return text;
            } catch (NumberFormatException e) {
                throw new TypeConversionException("'" + text + "' is not an int");
            } catch (IllegalArgumentException e) {
                throw new TypeConversionException(e.getMessage());
            }
        }
    }
}
