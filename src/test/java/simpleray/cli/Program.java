package simpleray.cli;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.io.UncheckedIOException;
import java.nio.charset.Charset;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import simpleray.Project;

/** The program as a process of its own, without a display. */
public final class Program {
    /** No run takes as long; one that does hangs. */
    private static final long MAX_SECONDS = 60;

    private Program() {
    }

    /**
     * How a run ended.
     *
     * @param exitCode its exit code
     * @param out what it wrote to standard output
     * @param err what it wrote to standard error, line breaks as LF
     */
    public record Result(int exitCode, byte[] out, String err) {
        /** {@return what it wrote to standard output, line breaks as LF} */
        public String text() {
            return unix(new String(out, StandardCharsets.UTF_8));
        }
    }

    /** {@return the result of the program in a folder} */
    public static Result run(Path folder, String... args) throws IOException, InterruptedException {
        return finish(program(folder, List.of(), args).start(), new byte[0]);
    }

    /** {@return the result of the program with something on its standard input} */
    static Result runWithInput(Path folder, byte[] in, String... args) throws IOException, InterruptedException {
        return finish(program(folder, List.of(), args).start(), in);
    }

    /** {@return the program, ready to start, with options for the virtual machine} */
    static ProcessBuilder program(Path folder, List<String> options, String... args) {
        return program(Path.of(System.getProperty("java.home")), folder, options, args);
    }

    /** {@return the program, ready to start in the Java of that home} */
    public static ProcessBuilder program(Path javaHome, Path folder, List<String> options, String... args) {
        List<String> all = new ArrayList<>(options);
        all.addAll(List.of("-jar", Project.jar().toString()));
        all.addAll(List.of(args));
        return java(javaHome, folder, all);
    }

    /** {@return java, ready to start, with an environment that changes nothing} */
    public static ProcessBuilder java(Path javaHome, Path folder, List<String> args) {
        // with its performance data, one Java that starts beside another may say on standard output that it cannot have them
        List<String> line = new ArrayList<>(List.of(javaHome.resolve("bin/java").toString(), "-XX:TieredStopAtLevel=1", "-XX:-UsePerfData"));
        line.addAll(args);
        ProcessBuilder builder = new ProcessBuilder(line).directory(folder.toFile());
        builder.environment().keySet().removeAll(List.of("DISPLAY", "JAVA_TOOL_OPTIONS", "_JAVA_OPTIONS", "JDK_JAVA_OPTIONS"));
        return builder;
    }

    /** Waits for a process, and kills it if it hangs. */
    public static Result finish(Process process, byte[] in) throws IOException, InterruptedException {
        return finish(process, in, process.getInputStream());
    }

    /** Waits for a process whose standard output nobody reads any more. */
    static Result finishUnread(Process process, byte[] in) throws IOException, InterruptedException {
        process.getInputStream().close();
        return finish(process, in, InputStream.nullInputStream());
    }

    private static Result finish(Process process, byte[] in, InputStream stdout) throws IOException, InterruptedException {
        try {
            CompletableFuture<byte[]> out = CompletableFuture.supplyAsync(() -> all(stdout), Program::onItsOwn);
            CompletableFuture<byte[]> err = CompletableFuture.supplyAsync(() -> all(process.getErrorStream()), Program::onItsOwn);
            try (OutputStream stdin = process.getOutputStream()) {
                stdin.write(in);
            }
            if (!process.waitFor(MAX_SECONDS, TimeUnit.SECONDS)) {
                throw new AssertionError("the program still runs after " + MAX_SECONDS + " s");
            }
            return new Result(process.exitValue(), out.join(), unix(new String(err.join(), Charset.defaultCharset())));
        } finally {
            process.destroyForcibly();
        }
    }

    /** Runs a task on a thread of its own; the common pool may be busy. */
    private static void onItsOwn(Runnable task) {
        Thread thread = new Thread(task, "reader of a program");
        thread.setDaemon(true);
        thread.start();
    }

    private static byte[] all(InputStream in) {
        try (ByteArrayOutputStream bytes = new ByteArrayOutputStream()) {
            in.transferTo(bytes);
            return bytes.toByteArray();
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    static String unix(String text) {
        return text.replace(System.lineSeparator(), "\n");
    }
}
