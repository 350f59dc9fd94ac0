package simpleray.cli;

import java.io.File;
import java.io.OutputStream;
import java.io.PrintWriter;
import java.nio.charset.Charset;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.Function;
import picocli.AutoComplete.GenerateCompletion;
import picocli.CommandLine;
import picocli.CommandLine.HelpCommand;
import picocli.CommandLine.TypeConversionException;
import simpleray.convert.ForeignFormat;
import simpleray.pov.PovChannel;
import simpleray.render.Accel;
import simpleray.text.Misspelling;

/** All commands, and how picocli is to read their options. */
final class Commands {
    private static final String COMPLETION = "generate-completion";
    private static final String HELP = "help";
    /** What looks at all commands. */
    private static final Set<String> ABOUT_ALL = Set.of("-h", "--help", "-V", "--version", COMPLETION, HELP);
    /** The commands that stand alone, in the order of the help. */
    private static final Map<String, Class<?>> ALONE = alone();

    private final Main main;

    Commands(Main main) {
        this.main = main;
    }

    private static Map<String, Class<?>> alone() {
        Map<String, Class<?>> alone = new LinkedHashMap<>();
        alone.put("view", ViewCommand.class);
        alone.put("render", RenderCommand.class);
        alone.put("animate", AnimateCommand.class);
        alone.put("merge", MergeCommand.class);
        alone.put("figures", FiguresCommand.class);
        alone.put("explain", ExplainCommand.class);
        alone.put("print", PrintCommand.class);
        alone.put("check", CheckCommand.class);
        alone.put("convert", ConvertCommand.class);
        alone.put("still", StillCommand.class);
        alone.put("import", ImportCommand.class);
        alone.put("export", ExportCommand.class);
        alone.put("job", JobCommand.class);
        alone.put("verify", VerifyCommand.class);
        alone.put("compare", CompareCommand.class);
        alone.put("bench", BenchCommand.class);
        return alone;
    }

    private static PrintWriter writer(OutputStream out) {
        return new PrintWriter(out, true, Charset.defaultCharset());
    }

    /** Does what a command line wants. {@return the exit code} */
    int execute(String[] args) {
        String meant = args.length > 0 ? meant(args[0]) : null;
        if (meant != null) {
            return main.usage("simpleray", "unknown command '" + args[0] + "': did you mean " + meant + "?");
        }
        String[] all = withCommand(Arrays.stream(counted(args)).map(Commands::named).toArray(String[]::new));
        PrintWriter results = writer(main.out());             // for help, version and completion; it notes errors and throws none
        int exitCode = line(all[0]).setOut(results).setErr(writer(main.err())).execute(all);
        if (results.checkError() && exitCode == ExitCode.DONE) {
            main.err().println("simpleray: standard output cannot be written");
            return ExitCode.WRITE_ERROR;
        }
        return exitCode;
    }

    /** {@return the command that a word may stand for, which is neither a command nor a file; null for none} */
    private static String meant(String word) {
        boolean other = word.startsWith("-") || ABOUT_ALL.contains(word) || ALONE.containsKey(word) || new File(word).exists();
        return other ? null : Misspelling.meant(word, ALONE.keySet());
    }

    /** Puts {@code view} before a command line that begins with no command of ours. */
    private static String[] withCommand(String[] args) {
        if (args.length > 0 && (ABOUT_ALL.contains(args[0]) || ALONE.containsKey(args[0]))) {
            return args;
        }
        List<String> all = new ArrayList<>(Arrays.asList(args));
        all.add(0, "view");
        return all.toArray(new String[0]);
    }

    /** {@return the words, in which {@code --turntable} without a number is told from a scene behind it} Picocli would take that for the number. */
    private static String[] counted(String[] args) {
        String[] words = args.clone();
        for (int i = 0; i < words.length && !words[i].equals("--"); i++) {
            if (words[i].equals(AnimateCommand.TURNTABLE) && (i + 1 == words.length || !words[i + 1].matches("\\d+"))) {
                words[i] += '=';
            }
        }
        return words;
    }

    /** {@return a word in which a file's name behind = begins with no -, so that picocli does not take it for an option} */
    private static String named(String word) {
        return word.matches("--(output|checkpoint|heatmap|directory|scene)=-.+") ? word.replaceFirst("=-", "=./-") : word;
    }

    /** Adds to a message what a word may stand for that was taken for an option. */
    private static String hinted(String message, String[] args) {
        for (String word : args) {
            if (word.equals("--")) {
                break;
            }
            if (word.matches("-.*\\.(scene|txt|png)") && !word.matches("-o.*|.*=.*")) {
                return message + ": a file whose name begins with - is named last, behind --: -- " + word;
            }
        }
        return message;
    }

    /** {@return what reads a command line that begins with this word} */
    CommandLine line(String first) {
        CommandLine line = new CommandLine(main);
        if (ALONE.containsKey(first)) {
            line.addSubcommand(first, ALONE.get(first));      // without the others, because each takes its time
        } else {
            ALONE.forEach(line::addSubcommand);
            line.addSubcommand(COMPLETION, GenerateCompletion.class).addSubcommand(HELP, HelpCommand.class);
            line.getSubcommands().get(COMPLETION).getCommandSpec().usageMessage().description("Prints a script that completes "
                + "simpleray's commands and options in bash and zsh: source <(simpleray generate-completion)");
        }
        line.setExpandAtFiles(false);                         // a file name may begin with @
        convert(line, PovChannel.class, word -> Values.constant(PovChannel.values(), word));
        convert(line, ForeignFormat.class, word -> Values.constant(ForeignFormat.values(), word));
        convert(line, Accel.class, word -> Values.constant(Accel.values(), word));
        convert(line, Stats.Format.class, word -> Values.constant(Stats.Format.values(), word));
        convert(line, ExplainCommand.Format.class, word -> Values.constant(ExplainCommand.Format.values(), word));
        convert(line, ExplainCommand.Pixel.class, Values::pixel);
        line.setParameterExceptionHandler((e, args) -> main.usage(e.getCommandLine().getCommandSpec().qualifiedName(),
            hinted(e.getMessage(), args)));
        line.setExecutionExceptionHandler((e, command, result) -> main.report(e, command.getCommandSpec().qualifiedName()));
        return line;
    }

    private static <T> void convert(CommandLine line, Class<T> type, Function<String, T> reader) {
        line.registerConverter(type, value -> {
            try {
                return reader.apply(value);
            } catch (IllegalArgumentException e) {
                throw new TypeConversionException(e.getMessage());
            }
        });
    }
}
