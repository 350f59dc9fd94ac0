package simpleray.cli;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.InputStream;
import java.io.OutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;

/** The program within the virtual machine of the tests, for what needs no process of its own. */
final class InProcess {
    private InProcess() {
    }

    /** {@return the result of a command line} */
    static Program.Result run(String... args) {
        return runWithInput("", args);
    }

    /** {@return the result of a command line with this text on standard input} */
    static Program.Result runWithInput(String in, String... args) {
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        Program.Result result = run(new ByteArrayInputStream(in.getBytes(StandardCharsets.UTF_8)), out, args);
        return new Program.Result(result.exitCode(), out.toByteArray(), result.err());
    }

    /** {@return the result of a command line with these streams, but for what it wrote to standard output} */
    static Program.Result run(InputStream in, OutputStream out, String... args) {
        ByteArrayOutputStream err = new ByteArrayOutputStream();
        int exitCode = Main.run(args, in, out, new PrintStream(err, true, StandardCharsets.UTF_8));
        return new Program.Result(exitCode, new byte[0], Program.unix(err.toString(StandardCharsets.UTF_8)));
    }
}
