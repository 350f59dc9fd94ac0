package simpleray.cli;

import java.io.FileDescriptor;
import java.io.FileOutputStream;
import java.io.InputStream;
import java.io.OutputStream;
import java.io.PrintStream;
import java.nio.file.InvalidPathException;
import picocli.CommandLine.Command;
import picocli.CommandLine.IVersionProvider;
import simpleray.io.Sha256;
import simpleray.render.OutOfMemory;

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
    exitCodeList = {"0:done", "1:verify and compare: the pictures differ", "2:wrong usage", "65:the scene has errors",
        "66:the scene cannot be read", "69:no display for a window, a Java without windows, or no ffmpeg", "70:internal error",
        "71:too large for the memory", "73:the output cannot be created",
        "74:the output cannot be written", "75:output or checkpoint are being written by another run",
        "130:interrupted (Ctrl+C)", "143:told to stop (SIGTERM)"})
public final class Main implements Runnable {
    private final InputStream in;
    private final OutputStream out;
    private final PrintStream err;
    private String[] args = {};
    private OpenJobLines lines;                               // null unless asked for

    Main(InputStream in, OutputStream out, PrintStream err) {
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
        Sha256.preload();
        int code = run(args, System.in, new FileOutputStream(FileDescriptor.out), System.err);
        if (code == ExitCode.DIFFERENT) {                     // which the script may have to tell from Java's own 1
            code = Integer.getInteger("simpleray.different", code);
        }
        System.exit(code);
    }

    /**
     * Runs the program.
     *
     * @param args the command line
     * @param in standard input
     * @param out standard output, only for results
     * @param err standard error, for messages and progress
     * @return the exit code
     */
    public static int run(String[] args, InputStream in, OutputStream out, PrintStream err) {
        Main main = new Main(in, out, err);
        main.args = args;
        main.lines = OpenJobLines.areAskedFor(args) ? new OpenJobLines(out) : null;
        try {
            PlainCommand plain = PlainLine.read(main, args);
            return plain == null ? new Commands(main).execute(args) : main.run(plain);
        } catch (Error e) {
            return main.internal(e);
        }
    }

    private int run(PlainCommand command) {
        try {
            return command.call();
        } catch (Exception e) {
            return report(e, "simpleray " + command.name());
        }
    }

    /** Reports the exception that ended a command. {@return the exit code} */
    int report(Exception e, String command) {
        if (e instanceof InvalidPathException name) {
            return usage(command, "no file can be called '" + name.getInput() + "' here: " + name.getReason());
        }
        if (!(e instanceof CommandException failure)) {
            return internal(e);
        }
        if (failure.exitCode() == ExitCode.USAGE) {
            return usage(command, failure.getMessage());
        }
        return fail(failure.exitCode(), failure.getMessage());
    }

    /** Reports a mistake in a command line. {@return the exit code} */
    int usage(String command, String message) {
        return fail(ExitCode.USAGE, command + ": " + message.strip().replace('\n', ' ') + " (see " + command + " --help)");
    }

    private int fail(int exitCode, String message) {
        err.println(message);
        if (lines != null) {
            lines.fail(message);
        }
        return exitCode;
    }

    private int internal(Throwable e) {
        if (e instanceof OutOfMemoryError || OutOfMemory.isBehind(e)) {   // the first test loads no class
            return fail(ExitCode.NO_MEMORY, "simpleray: " + OutOfMemory.MESSAGE);
        }
        if (e instanceof LinkageError && !WindowSupport.hasModule()) {
            return fail(ExitCode.UNAVAILABLE, "simpleray: this Java lacks the module java.desktop, which is needed here: "
                + WindowSupport.INSTALL);
        }
        if (e instanceof NoClassDefFoundError && e.getCause() instanceof ClassNotFoundException || e instanceof ClassFormatError) {
            return fail(ExitCode.INTERNAL, "simpleray: a part of the program is missing or damaged, so install or build it again: "
                + e.getMessage());
        }
        fail(ExitCode.INTERNAL, "simpleray: internal error, which should not happen whatever the input: " + e);
        e.printStackTrace(err);
        return ExitCode.INTERNAL;
    }

    /** {@return the command line} */
    String[] args() {
        return args;
    }

    /** {@return the lines for a scheduler; null unless they are asked for} */
    OpenJobLines lines() {
        return lines;
    }

    /** {@return the version in the jar's manifest} */
    static String version() {
        String version = Main.class.getPackage().getImplementationVersion();
        return version == null ? "(not packaged)" : version;
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

    /** The version in the jar's manifest. */
    static final class Version implements IVersionProvider {
        @Override
        public String[] getVersion() {
            return new String[] {"SimpleRay " + version(),
                "Java " + System.getProperty("java.version") + ", " + System.getProperty("java.vm.name")};
        }
    }
}
