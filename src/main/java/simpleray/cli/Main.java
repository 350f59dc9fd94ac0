package simpleray.cli;

import java.io.FileDescriptor;
import java.io.FileOutputStream;
import java.io.InputStream;
import java.io.OutputStream;
import java.io.PrintStream;
import java.io.PrintWriter;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import picocli.AutoComplete.GenerateCompletion;
import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.HelpCommand;
import picocli.CommandLine.IVersionProvider;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.TypeConversionException;
import simpleray.render.Stage;
import simpleray.scene.PovChannel;

/** The program: {@code simpleray SCENE} opens the window, the other commands work without one. */
@Command(name = "simpleray", versionProvider = Main.Version.class, mixinStandardHelpOptions = true,
    description = "Makes realistic pictures of scenes by ray tracing.",
    customSynopsis = {"simpleray SCENE [OPTIONS]", "       simpleray COMMAND ..."},
    header = "SimpleRay: a text file of spheres, planes and lights becomes a picture.%n",
    descriptionHeading = "%n", optionListHeading = "%nOptions:%n", commandListHeading = "%nCommands:%n",
    footerHeading = "%nExamples:%n",
    footer = {"  simpleray scenes/thesis.scene", "  simpleray render scenes/thesis.scene -o thesis.png --size 800x600",
        "%nSCENE alone is short for: simpleray view SCENE. Without arguments an empty window opens."},
    exitCodeListHeading = "%nExit codes:%n",
    exitCodeList = {"0:done", "2:wrong usage", "65:the scene has errors", "66:the scene cannot be read",
        "69:no display for a window", "70:internal error", "71:too large for the memory", "73:the output cannot be created",
        "74:the output cannot be written"},
    subcommands = {ViewCommand.class, RenderCommand.class, FiguresCommand.class, PrintCommand.class, CheckCommand.class,
        ConvertCommand.class, ExportCommand.class, GenerateCompletion.class, HelpCommand.class})
public final class Main implements Runnable {
    private final InputStream in;
    private final OutputStream out;
    private final PrintStream err;

    private Main(InputStream in, OutputStream out, PrintStream err) {
        this.in = in;
        this.out = out;
        this.err = err;
    }

    /**
     * Runs the program and ends the virtual machine.
     *
     * @param args the command line
     */
    public static void main(String[] args) {
        System.exit(run(args, System.in, new FileOutputStream(FileDescriptor.out), System.err));
    }

    /**
     * Runs the program.
     *
     * @param args the command line
     * @param in standard input
     * @param out standard output, for results alone
     * @param err standard error, for messages and progress
     * @return the exit code
     */
    public static int run(String[] args, InputStream in, OutputStream out, PrintStream err) {
        CommandLine line = new CommandLine(new Main(in, out, err));
        PrintWriter results = new PrintWriter(out, true);     // for help, version and completion; it notes errors and throws none
        line.setOut(results).setErr(new PrintWriter(err, true));
        line.setExpandAtFiles(false);                         // a file name may begin with @
        line.registerConverter(Stage.class, word -> constant(Stage.values(), word));
        line.registerConverter(PovChannel.class, word -> constant(PovChannel.values(), word));
        line.registerConverter(ProgressPrinter.Style.class, word -> constant(ProgressPrinter.Style.values(), word));
        line.getSubcommands().get("generate-completion").getCommandSpec().usageMessage().description(
            "Prints a script that completes simpleray's commands and options in bash and zsh: source <(simpleray generate-completion)");
        line.setParameterExceptionHandler((e, a) -> usage(e, err));
        line.setExecutionExceptionHandler((e, commandLine, result) -> report(e, commandLine, err));
        try {
            int exitCode = line.execute(withCommand(line, args));
            if (results.checkError() && exitCode == ExitCode.DONE) {
                err.println("simpleray: standard output cannot be written");
                return ExitCode.WRITE_ERROR;
            }
            return exitCode;
        } catch (OutOfMemoryError e) {
            err.println("simpleray: the scene or the picture is too large for the memory: make it smaller, or give java more by -Xmx");
            return ExitCode.NO_MEMORY;
        } catch (Error e) {
            return internal(e, err);
        }
    }

    /** Puts {@code view} before a command line that begins with no command of ours. */
    private static String[] withCommand(CommandLine line, String[] args) {
        List<String> own = List.of("-h", "--help", "-V", "--version");
        if (args.length > 0 && (own.contains(args[0]) || line.getSubcommands().containsKey(args[0]))) {
            return args;
        }
        List<String> all = new ArrayList<>(Arrays.asList(args));
        all.add(0, "view");
        return all.toArray(new String[0]);
    }

    private static <T> T constant(T[] all, String word) {
        return Arrays.stream(all).filter(t -> t.toString().equals(word.toLowerCase(Locale.ROOT))).findFirst()
            .orElseThrow(() -> new TypeConversionException("expected one of " + Arrays.toString(all) + ", found '" + word + "'"));
    }

    private static int usage(ParameterException e, PrintStream err) {
        String name = e.getCommandLine().getCommandSpec().qualifiedName();
        err.println(name + ": " + e.getMessage().strip().replace('\n', ' ') + " (see " + name + " --help)");
        return ExitCode.USAGE;
    }

    private static int report(Exception e, CommandLine commandLine, PrintStream err) throws Exception {
        if (e instanceof Failure failure) {
            err.println(failure.getMessage());
            return failure.exitCode();
        }
        if (e instanceof ParameterException parameter) {
            return usage(parameter, err);
        }
        return internal(e, err);
    }

    private static int internal(Throwable e, PrintStream err) {
        err.println("simpleray: internal error, which should not happen whatever the input: " + e);
        e.printStackTrace(err);
        return ExitCode.INTERNAL;
    }

    InputStream in() {
        return in;
    }

    OutputStream out() {
        return out;
    }

    PrintStream err() {
        return err;
    }

    @Override
    public void run() {
        throw new IllegalStateException("a command line without command is given the command view");
    }

    /** The version as the jar's manifest has it. */
    static final class Version implements IVersionProvider {
        @Override
        public String[] getVersion() {
            String version = Main.class.getPackage().getImplementationVersion();
            return new String[] {"SimpleRay " + (version == null ? "(not packaged)" : version),
                "Java " + System.getProperty("java.version") + ", " + System.getProperty("java.vm.name")};
        }
    }
}
