package simpleray.cli;

import java.util.HashMap;
import java.util.HashSet;
import java.util.Map;
import java.util.Set;

/**
 * The command line of render or view, if it is nothing but known options, each followed by its value, and a scene. It is read here, because
 * picocli alone takes longer to start than a small picture takes to render. All else is left to picocli: help, mistakes, other commands.
 */
final class PlainLine {
    private PlainLine() {
    }

    /** {@return the command as that line wants it; null if picocli is to read the line} */
    static PlainCommand read(Main main, String[] args) {
        PlainCommand command = command(main, args);
        return command != null && takesAll(command, args) ? command : null;
    }

    private static PlainCommand command(Main main, String[] args) {
        String first = args.length == 0 ? "view" : args[0];
        return first.equals("render") ? new RenderCommand(main) : first.equals("view") || isFile(first) ? new ViewCommand(main) : null;
    }

    /** {@return whether a word is a file's name, and surely no command} */
    private static boolean isFile(String word) {
        return isNoOption(word) && word.indexOf('.') >= 0;
    }

    private static boolean takesAll(PlainCommand command, String[] args) {
        Map<String, CommandOption<?>> options = options(command);
        Set<CommandOption<?>> taken = new HashSet<>();
        boolean scene = false;
        for (int i = args.length > 0 && args[0].equals(command.name()) ? 1 : 0; i < args.length; i++) {
            if (isNoOption(args[i])) {
                if (scene) {
                    return false;
                }
                scene = true;
                command.setScene(args[i]);
                continue;
            }
            CommandOption<?> option = options.get(args[i]);
            if (option == null || !taken.add(option) || !option.isFlag() && (++i == args.length || !isValue(args[i]))
                || !takes(option, option.isFlag() ? "true" : args[i])) {
                return false;
            }
        }
        for (CommandOption<?> option : options.values()) {
            if (option.required && !taken.contains(option)) {
                return false;
            }
        }
        return scene || !command.needsScene();
    }

    private static Map<String, CommandOption<?>> options(PlainCommand command) {
        Map<String, CommandOption<?>> options = new HashMap<>();
        for (OptionGroup group : command.options()) {
            for (CommandOption<?> option : group.options()) {
                for (String name : option.names) {
                    options.put(name, option);
                }
            }
        }
        return options;
    }

    private static boolean takes(CommandOption<?> option, String value) {
        try {
            option.take(value);
            return true;
        } catch (IllegalArgumentException e) {
            return false;                                     // picocli says what is wrong with it
        }
    }

    private static boolean isNoOption(String word) {
        return word.equals(SceneArgument.STREAM) || !word.isEmpty() && word.charAt(0) != '-';
    }

    /** {@return whether a word behind an option is its value: a number may be negative} */
    private static boolean isValue(String word) {
        return isNoOption(word) || word.length() > 1 && Character.isDigit(word.charAt(1));
    }
}
