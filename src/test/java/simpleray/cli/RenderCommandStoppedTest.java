package simpleray.cli;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.BufferedReader;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** A rendering that is told to stop (SIGINT, SIGTERM) says how to go on, and leaves nothing half done but its checkpoint. */
@Timeout(value = 120, threadMode = Timeout.ThreadMode.SEPARATE_THREAD)
class RenderCommandStoppedTest {
    private static final int SIGINT = 2;
    private static final List<String> SLOW = List.of("render", "my slow.scene", "-o", "slow.png", "--depth", "1000", "--threads", "1",
        "--samples", "2");

    @TempDir
    Path folder;

    @BeforeEach
    void writeScene() throws IOException {
        String mirror = " 0.001 0.001 0.001  0 0 0  1 1 1  1000 ";
        Files.writeString(folder.resolve("my slow.scene"), "2  1 0 0 1 -2" + mirror + "1 0 0 1 4" + mirror + "1 1 1  0");
        Files.writeString(folder.resolve("slow.png"), "the old picture");
    }

    private Process start(String... options) throws IOException {
        List<String> args = new ArrayList<>(SLOW);
        args.addAll(List.of(options));
        ProcessBuilder program = Program.program(folder, List.of(), args.toArray(new String[0]));
        if (isInterruptIgnored()) {
            program.command().addAll(0, List.of("env", "--default-signal=INT"));
        }
        return program.start();
    }

    /** {@return whether this program, and what it starts, ignores SIGINT, as shells make jobs in the background do} */
    private static boolean isInterruptIgnored() throws IOException {
        Path status = Path.of("/proc/self/status");
        return Files.exists(status) && Files.readAllLines(status).stream().filter(line -> line.startsWith("SigIgn:"))
            .anyMatch(line -> (Long.parseUnsignedLong(line.substring("SigIgn:".length()).strip(), 16) & 1 << SIGINT - 1) != 0);
    }

    /** Stops a process, and returns what it said last. How long that takes is told, not judged: less than 2 s on a quiet machine. */
    private static String stopped(Process process, BufferedReader err, String signal, int exitCode)
            throws IOException, InterruptedException {
        long begin = System.nanoTime();
        new ProcessBuilder("sh", "-c", "kill -" + signal + " " + process.pid()).start().waitFor();
        assertThat(process.waitFor(60, TimeUnit.SECONDS)).isTrue();
        System.out.println("stopped after " + (System.nanoTime() - begin) / 1e9 + " s");
        assertThat(process.exitValue()).isEqualTo(exitCode);
        return err.lines().filter(line -> !line.matches(" *\\d+ %, .*")).reduce("", (all, line) -> all + line + '\n');
    }

    private void assertFiles(String... names) throws IOException {
        try (Stream<Path> files = Files.list(folder)) {
            assertThat(files.map(file -> file.getFileName().toString())).containsExactlyInAnyOrder(names);
        }
        assertThat(folder.resolve("slow.png")).hasContent("the old picture");
    }

    @ParameterizedTest
    @CsvSource({"INT, 130", "TERM, 143"})
    void finishedRowsAreKeptAndTheCommandThatGoesOnIsTold(String signal, int exitCode) throws IOException, InterruptedException {
        Process process = start("--size", "4x5000", "--checkpoint", "rows", "--progress", "plain", "--restart");
        assumeTrue(process.supportsNormalTermination(), "no signals here");
        try (BufferedReader err = process.errorReader()) {
            assertThat(err.readLine()).startsWith(" 10 %, 500 of 5000 rows, ");

            assertThat(stopped(process, err, signal, exitCode)).matches("simpleray: interrupted: \\d+ of 5000 rows are kept in rows; "
                + "to go on: simpleray render 'my slow.scene' -o slow.png --depth 1000 --threads 1 --samples 2 --size 4x5000 --checkpoint rows "
                + "--progress plain --resume\n");
        } finally {
            process.destroyForcibly();
        }
        assertFiles("my slow.scene", "slow.png", "rows");
        assertThat(Files.size(folder.resolve("rows"))).isGreaterThan(500 * (4 + 3 * 4 + 4));
    }

    @Test
    void aShortRenderingKeepsNothingAndSaysSo() throws IOException, InterruptedException {
        Process process = start("--size", "4x3000", "--progress", "plain");
        assumeTrue(process.supportsNormalTermination(), "no signals here");
        try (BufferedReader err = process.errorReader()) {
            assertThat(err.readLine()).startsWith(" 10 %, 300 of 3000 rows, ");

            assertThat(stopped(process, err, "INT", ExitCode.INTERRUPTED))
                .matches("simpleray: interrupted after \\d\\.\\d s, and nothing is kept: --checkpoint FILE keeps rows from the start\n");
        } finally {
            process.destroyForcibly();
        }
        assertFiles("my slow.scene", "slow.png");
    }

    @Test
    void whoHasAskedForACheckpointIsNotToldToAsk() throws IOException, InterruptedException {
        Process process = start("--size", "65535x1", "--checkpoint", "rows");
        assumeTrue(process.supportsNormalTermination(), "no signals here");
        try (BufferedReader err = process.errorReader()) {
            while (!Files.exists(folder.resolve("rows"))) {
                Thread.sleep(20);
            }
            Thread.sleep(500);                                // its end is prepared for once it is there

            assertThat(stopped(process, err, "TERM", 143))
                .matches("simpleray: interrupted after \\d+\\.\\d s, before a row was finished\n");
        } finally {
            process.destroyForcibly();
        }
        assertFiles("my slow.scene", "slow.png");
    }

    /** A scheduler that takes the machine away gives it back later. */
    @ParameterizedTest
    @ValueSource(strings = {"", "--band 2/3"})
    void aShortRenderingThatASchedulerStopsKeepsItsRows(String band) throws IOException, InterruptedException {
        String[] options = ("--progress plain --size 4x" + (band.isEmpty() ? "600 " : "1800 ") + band).split(" ");
        Process process = start(options);
        assumeTrue(process.supportsNormalTermination(), "no signals here");
        try (BufferedReader err = process.errorReader()) {
            assertThat(err.readLine()).startsWith(" 10 %, 60 of 600 rows, ");

            assertThat(stopped(process, err, "TERM", ExitCode.TERMINATED))
                .matches("simpleray: interrupted: \\d+ of 600 rows are kept in slow.png.part; to go on: simpleray render .* --resume\n");
        } finally {
            process.destroyForcibly();
        }
        assertFiles("my slow.scene", "slow.png", "slow.png.part");

        assertThat(finished(options, "--resume")).startsWith("simpleray: going on with ");
        byte[] resumed = Files.readAllBytes(folder.resolve("slow.png"));
        assertThat(finished(options, "--restart")).doesNotContain("going on");
        assertThat(folder.resolve("slow.png")).hasBinaryContent(resumed);
    }

    private String finished(String[] options, String last) throws IOException, InterruptedException {
        List<String> args = new ArrayList<>(SLOW);
        args.addAll(List.of(options));
        args.add(last);
        Program.Result result = Program.run(folder, args.toArray(new String[0]));
        assertThat(result.exitCode()).as(result.err()).isZero();
        return result.err();
    }

    /** It is told on standard output, too, if a scheduler reads there. */
    @Test
    void whoReadsTheLinesOfASchedulerReadsWhy() throws IOException, InterruptedException {
        Process process = start("--size", "4x3000", "--progress", "openjd", "--checkpoint", "rows");
        assumeTrue(process.supportsNormalTermination(), "no signals here");
        try (BufferedReader out = process.inputReader(); BufferedReader err = process.errorReader()) {
            assertThat(out.readLine()).isEqualTo("openjd_progress: 1.0");
            String message = stopped(process, err, "TERM", ExitCode.TERMINATED);

            assertThat(message).startsWith("simpleray: interrupted: ").hasLineCount(1);
            assertThat(out.lines().filter(line -> line.startsWith("openjd_fail: "))).containsExactly("openjd_fail: " + message.strip());
        } finally {
            process.destroyForcibly();
        }
    }

    /** Takes a little more than the 10 s after which rows are kept. */
    @Tag("slow")
    @Test
    void aRenderingThatLastsKeepsItsRowsFromTheFirstOn() throws IOException, InterruptedException {
        long begin = System.nanoTime();
        Process process = start("--size", "4x50000");
        assumeTrue(process.supportsNormalTermination(), "no signals here");
        Path part = folder.resolve("slow.png.part");
        try (BufferedReader err = process.errorReader()) {
            while (!Files.exists(part) && process.isAlive()) {
                Thread.sleep(20);
            }
            assertThat(System.nanoTime() - begin).isGreaterThan(TimeUnit.SECONDS.toNanos(10));

            assertThat(stopped(process, err, "TERM", ExitCode.TERMINATED))
                .matches("simpleray: interrupted: \\d+ of 50000 rows are kept in slow.png.part; to go on: simpleray render .* --resume\n");
        } finally {
            process.destroyForcibly();
        }
        assertFiles("my slow.scene", "slow.png", "slow.png.part");
        byte[] rows = Files.readAllBytes(part);
        int magic = "SimpleRay checkpoint 1\n".length();
        int head = magic + 4 + ByteBuffer.wrap(rows).getInt(magic) + 4;
        assertThat(ByteBuffer.wrap(rows).getInt(head)).as("the first record's row").isZero();
    }
}
