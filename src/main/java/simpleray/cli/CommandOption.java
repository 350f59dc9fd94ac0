package simpleray.cli;

import java.util.ArrayList;
import java.util.List;
import simpleray.scene.SceneSettings;
import simpleray.scene.Setting;

/**
 * An option of a command, declared once: {@link PlainLine} reads it from here, and so does picocli, by {@link OptionGroup}.
 * <em>Mutable:</em> it keeps the value that it is given.
 *
 * @param <T> the type of its value
 */
abstract class CommandOption<T> {
    /** Its names, such as -o and --output. */
    final List<String> names;
    /** What the help calls its value; null for an option without one. */
    final String label;
    /** Its description in the help, in picocli's form. */
    final String description;
    /** Its value unless it is given; null for none. */
    final T initial;
    /** Whether it must be given. */
    boolean required;

    private T value;

    /** Declares an option. */
    CommandOption(T initial, String label, String description, String... names) {
        this.names = List.of(names);
        this.label = label;
        this.description = description;
        this.initial = initial;
        value = initial;
    }

    /** {@return an option without a value} */
    static CommandOption<Boolean> flag(String description, String... names) {
        return new CommandOption<>(false, null, description, names) {
            @Override Boolean parse(String text) { return Boolean.valueOf(text); }
        };
    }

    /** {@return an option whose value may be any text} */
    static CommandOption<String> text(String label, String description, String... names) {
        return new CommandOption<>(null, label, description, names) {
            @Override String parse(String text) { return text; }
        };
    }

    /** {@return an option whose value is an integer} */
    static CommandOption<Integer> integer(String label, String description, String... names) {
        return new CommandOption<>(null, label, description, names) {
            @Override Integer parse(String text) { return Integer.valueOf(text); }
        };
    }

    /** {@return an option whose value is one of these, whatever its case} */
    static <E> CommandOption<E> choice(E[] all, E initial, String label, String description, String... names) {
        return new CommandOption<>(initial, label, description, names) {
            @Override E parse(String text) { return Values.constant(all, text); }

            @Override
            List<String> candidates() {
                List<String> candidates = new ArrayList<>();
                for (E one : all) {
                    candidates.add(one.toString());
                }
                return candidates;
            }
        };
    }

    /** {@return the option of a setting, which is set by it} */
    static <S> CommandOption<S> of(Setting<S> setting, SceneSettings settings) {
        return new CommandOption<>(null, setting.label(), setting.description(), setting.option()) {
            @Override S parse(String text) { return setting.parse(text); }

            @Override
            void take(String text) {
                super.take(text);
                setting.set(settings, value());
            }
        };
    }

    /** Makes this an option that must be given. {@return this} */
    CommandOption<T> required() {
        required = true;
        return this;
    }

    /**
     * Reads a value.
     *
     * @throws IllegalArgumentException if it cannot have that value; the message says what was expected, and what was found
     * @throws NumberFormatException if it is no integer, and ought to be one
     */
    abstract T parse(String text);

    /** {@return the values that the help and the completion name; none if there are too many} */
    List<String> candidates() {
        return List.of();
    }

    /** Gives it a value, as {@link #parse}. */
    void take(String text) {
        value = parse(text);
    }

    /** {@return the value that it was given, else the initial one; null for none} */
    final T value() {
        return value;
    }

    final boolean isFlag() {
        return label == null;
    }
}
