package simpleray.cli;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.BufferedReader;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;
import simpleray.Project;
import simpleray.Sample;
import simpleray.io.AtomicFile;

/** Disks that refuse what others can do, each with any errno of Linux: a library that is preloaded stands for them. */
@Timeout(value = 300, threadMode = Timeout.ThreadMode.SEPARATE_THREAD)
class FaultyDiskTest {
    private static final int ENOSPC = 28;
    private static final String OLD = "the old one";
    private static final Map<Integer, String> WORDS = Map.of(1, "Operation not permitted", 5, "Input/output error", 13, "permission denied",
        16, "Device or resource busy", 18, "Invalid cross-device link", 22, "Invalid argument", 37, "No locks available",
        38, "Function not implemented", 95, "Operation not supported", 122, "Disk quota exceeded");
    private static final String NOT_LOCKED = "cannot be locked (%s): another run that writes it at the same time is not noticed";
    private static final String NOT_REPLACED = "cannot be replaced (%s): it was overwritten in place";
    private static final String NO_NEW_FILE = "its folder takes no new file (%s): the old file is overwritten in place";

    @TempDir
    static Path made;
    private static Path library;

    @TempDir
    Path folder;
    private Path out;

    @BeforeAll
    static void makeTheDiskAndWhatIsRead() throws IOException, InterruptedException {
        library = made.resolve("faulty-disk.so");
        assumeTrue(isDiskCompiled(Project.root().resolve("src/test/resources/disk/faulty-disk.c")), "no gcc that compiles the disk");
        EveryOutputTest.makeWhatIsRead(made);
    }

    private static boolean isDiskCompiled(Path source) throws InterruptedException {
        try {
            Process compiler = new ProcessBuilder("gcc", "-shared", "-fPIC", "-o", library.toString(), source.toString(), "-ldl").start();
            return Program.finish(compiler, new byte[0]).exitCode() == 0;
        } catch (IOException e) {
            return false;                                     // there is no gcc
        }
    }

    @BeforeEach
    void nameTheOutput() {
        out = folder.resolve("out");
    }

    private void writeTheOldFile() throws IOException {
        Files.writeString(out, (OLD + ", longer than what is written ").repeat(1000));
        Files.setPosixFilePermissions(out, PosixFilePermissions.fromString("rw-r-----"));
    }

    private Program.Result run(String faults, String line) throws IOException, InterruptedException {
        return Program.finish(program(faults, line).start(), new byte[0]);
    }

    private ProcessBuilder program(String faults, String line) {
        ProcessBuilder program = Program.program(folder, List.of(), line.replace("@", made + "/").split(" "));
        program.environment().putAll(Map.of("LD_PRELOAD", library.toString(), "DISK", faults, "DISK_PATH", folder + "/", "LC_ALL", "C"));
        return program;
    }

    private void assertOnly(Path... files) throws IOException {
        try (Stream<Path> all = Files.list(folder)) {
            assertThat(all).containsExactlyInAnyOrder(files);
        }
    }

    /** A fault, what is said of it where there is an old file, and where there is none. */
    private record Fault(String what, int errno, String note, String noteOfNew) {
        @Override
        public String toString() {
            return what + '=' + errno;
        }
    }

    static List<Fault> faults() {
        List<Fault> all = new ArrayList<>();
        WORDS.forEach((errno, words) -> {
            all.add(new Fault("lock", errno, String.format(NOT_LOCKED, words), String.format(NOT_LOCKED, words)));
            all.add(new Fault("rename", errno, String.format(NOT_REPLACED, words), String.format(NOT_REPLACED, words)));
            all.add(new Fault("chmod", errno, "the old file's permissions cannot be kept (" + words + ')', ""));
            all.add(new Fault("fsync", errno, "", ""));
            all.add(new Fault("link", errno, "", ""));
            all.add(new Fault("truncate", errno, "", ""));
        });
        return Sample.of(all, 6);
    }

    @ParameterizedTest
    @MethodSource("faults")
    void whatIsRefusedIsDoneWithoutAndTold(Fault fault) throws IOException, InterruptedException {
        Program.Result first = run(fault.toString(), "convert @ball.scene " + out);
        byte[] made = Files.readAllBytes(out);
        writeTheOldFile();
        Program.Result second = run(fault.toString(), "convert @ball.scene " + out);

        assertThat(first.err()).isEqualTo(fault.noteOfNew.isEmpty() ? "" : "simpleray: " + out + ": " + fault.noteOfNew + '\n');
        assertThat(second.err()).isEqualTo(fault.note.isEmpty() ? "" : "simpleray: " + out + ": " + fault.note + '\n');
        assertThat(List.of(first.exitCode(), second.exitCode())).containsOnly(ExitCode.DONE);
        assertThat(new String(made)).isEqualTo(InProcess.run("convert", FaultyDiskTest.made.resolve("ball.scene").toString(), "-").text());
        assertThat(out).hasBinaryContent(made);
        assertOnly(out);
    }

    @Test
    void aFilmTellsOnceWhatIsTrueOfAllItsFiles() throws IOException, InterruptedException {
        Program.Result result = run("lock=37", "animate @ball.scene --turntable 3 --size 8x8 -o " + folder + "/%d.png");

        assertThat(result.exitCode()).isEqualTo(ExitCode.DONE);
        assertThat(result.err().lines().filter(line -> line.contains("locked"))).containsExactly(
            "simpleray: " + folder + "/0.png: " + String.format(NOT_LOCKED, WORDS.get(37)));
        assertOnly(folder.resolve("0.png"), folder.resolve("1.png"), folder.resolve("2.png"));
    }

    static List<Integer> errnosOfFolders() {
        return Sample.of(List.of(1, 13, 22, ENOSPC, 30, 95, 122), 3);
    }

    @ParameterizedTest
    @MethodSource("errnosOfFolders")
    void aFolderThatTakesNoNewFileHasOnlyOldOnesWritten(int errno) throws IOException, InterruptedException {
        Program.Result none = run("create=" + errno, "convert @ball.scene " + out);

        assertThat(none.err()).startsWith("simpleray: " + out + ": cannot be created: ").hasLineCount(1);
        assertThat(none.exitCode()).isEqualTo(ExitCode.NO_OUTPUT);
        assertOnly();

        writeTheOldFile();
        Program.Result old = run("create=" + errno, "convert @ball.scene " + out);

        assertThat(old.err()).startsWith("simpleray: " + out + ": its folder takes no new file (").hasLineCount(1);
        assertThat(old.exitCode()).isZero();
        assertThat(out).content().startsWith("#").doesNotContain(OLD);
        assertOnly(out);
    }

    @Test
    void whereNoFolderTakesANewFileTheOldOneStays() throws IOException, InterruptedException {
        writeTheOldFile();
        ProcessBuilder program = program("create=30", "convert @ball.scene " + out);
        program.command().add(1, "-Djava.io.tmpdir=" + folder.resolve("none"));

        Program.Result result = Program.finish(program.start(), new byte[0]);

        assertThat(result.err()).isEqualTo("simpleray: " + out + ": cannot be created: Read-only file system\n");
        assertThat(result.exitCode()).isEqualTo(ExitCode.NO_OUTPUT);
        assertThat(out).content().startsWith(OLD);
        assertOnly(out);
    }

    static Stream<String> commands() {
        return EveryOutputTest.files().stream().map(line -> line.replace("--progress plain", "-q --size 20x20"));
    }

    @ParameterizedTest
    @MethodSource("commands")
    void everyCommandWritesOnADiskThatCanDoNothing(String line) throws IOException, InterruptedException {
        writeTheOldFile();

        Program.Result result = run("lock=37 rename=16 chmod=1 fsync=22", line + ' ' + out);

        assertThat(result.err()).isEqualTo(line.contains("-q") ? "" : "simpleray: " + out + ": " + String.format(NOT_LOCKED, WORDS.get(37)) + "; "
            + "the old file's permissions cannot be kept (Operation not permitted); " + String.format(NOT_REPLACED, WORDS.get(16)) + '\n');
        assertThat(result.exitCode()).isEqualTo(line.startsWith("compare") ? ExitCode.DIFFERENT : ExitCode.DONE);
        assertThat(Files.size(out)).isPositive().isLessThan(10_000);
        assertOnly(out);
    }

    @Test
    void aRenderSaysSoInOneLine() throws IOException, InterruptedException {
        writeTheOldFile();

        Program.Result result = run("create=13", "render @ball.scene --size 20x20 -o " + out);

        assertThat(result.err()).matches("(?s)" + out + ": 20x20, .*\nsimpleray: " + out + ": "
            + String.format(NO_NEW_FILE, "permission denied").replaceAll("[()]", "\\\\$0") + '\n');
        assertThat(result.exitCode()).isZero();
    }

    /** An error of the disk, a quota, a full disk: while the picture is written, or when it is closed. */
    @ParameterizedTest
    @ValueSource(strings = {"write=5", "write=28", "write=122", "close=5", "close=122"})
    void whatCannotBeWrittenLeavesTheOldFileAndNoOther(String fault) throws IOException, InterruptedException {
        writeTheOldFile();
        String old = Files.readString(out);
        ProcessBuilder program = program(fault, "render @ball.scene -q --size 20x20 -o " + out);
        program.environment().put("DISK_PATH", ".part");

        Program.Result result = Program.finish(program.start(), new byte[0]);

        int errno = Integer.parseInt(fault.substring(fault.indexOf('=') + 1));
        assertThat(result.err()).isEqualTo("simpleray: " + out + ": cannot be written: "
            + (errno == ENOSPC ? "No space left on device" : WORDS.get(errno)) + '\n');
        assertThat(result.exitCode()).isEqualTo(ExitCode.WRITE_ERROR);
        assertThat(out).hasContent(old);
        assertOnly(out);
    }

    @Test
    void whatCanNeitherBeReplacedNorCutOffStays() throws IOException, InterruptedException {
        writeTheOldFile();

        Program.Result result = run("rename=16 truncate=22", "convert @ball.scene " + out);

        assertThat(result.err()).isEqualTo("simpleray: " + out + ": cannot be written: Invalid argument\n");
        assertThat(result.exitCode()).isEqualTo(ExitCode.WRITE_ERROR);
        assertThat(out).content().startsWith(OLD).hasSize(41_000);
        assertOnly(out);
    }

    /** The whole file is worth more than a clean folder. */
    @Test
    void whatIsLostInTheMiddleOfOverwritingIsKeptBesideIt() throws IOException, InterruptedException {
        writeTheOldFile();

        ProcessBuilder program = program("rename=16 write=5", "convert @ball.scene " + out);
        program.environment().put("DISK_PATH", out.toString());

        Program.Result result = Program.finish(program.start(), new byte[0]);

        Path kept = folder.resolve(".simpleray-out.part");
        assertThat(result.err()).isEqualTo("simpleray: " + out + ": cannot be written: Input/output error (the whole file is " + kept + ")\n");
        assertThat(result.exitCode()).isEqualTo(ExitCode.WRITE_ERROR);
        assertThat(kept).hasContent(InProcess.run("convert", made.resolve("ball.scene").toString(), "-").text());
    }

    static List<Integer> errnosOfLocks() {
        return Sample.of(List.of(1, 5, 13, 37, 38, 95), 2);
    }

    @ParameterizedTest
    @MethodSource("errnosOfLocks")
    void rowsAreKeptWhereNothingCanBeLocked(int errno) throws IOException, InterruptedException {
        Path rows = folder.resolve("rows");
        Program.Result result = run("lock=" + errno + " truncate=" + errno, "render @ball.scene --size 20x20 -o - --checkpoint " + rows);

        assertThat(result.err()).matches("simpleray: " + rows + ": cannot be locked \\(" + WORDS.get(errno)
            + "\\): another run that writes it at the same time is not noticed\n<stdout>: 20x20, .*\n");
        assertThat(result.exitCode()).isZero();
        assertOnly();
    }

    @Test
    void whatCannotBeDeletedIsNamed() throws IOException, InterruptedException {
        Program.Result result = run("unlink=1", "convert @ball.scene " + out);

        Path lock = folder.resolve(".simpleray-out.lock");
        assertThat(result.err()).isEqualTo("simpleray: " + out + ": " + lock + " cannot be deleted: Operation not permitted\n");
        assertThat(result.exitCode()).isZero();
        assertOnly(out, lock);
    }

    @Test
    void aFullDiskIsKnownBeforeTheFirstRay() throws IOException, InterruptedException {
        Program.Result result = run("write=" + ENOSPC, "render @ball.scene --progress plain --size 20x20 -o " + out);

        assertThat(result.err()).isEqualTo("simpleray: " + out + ": cannot be created: No space left on device\n");
        assertThat(result.exitCode()).isEqualTo(ExitCode.NO_OUTPUT);
        assertOnly();
    }

    /** The disk takes its time to close the first one's file, which is gone by then: another's has its name. */
    @Test
    void aRunThatIsToldToStopDoesNotMoveTheNextOnesUnfinishedFile() throws IOException, InterruptedException {
        Path part = folder.resolve(".simpleray-out.part");
        Files.writeString(out, OLD);
        ProcessBuilder first = program("", "render @ball.scene --size 20x20 -q -o " + out);
        first.environment().putAll(Map.of("DISK_PATH", part.toString(), "SLOW", "close=900"));
        Process process = first.start();
        try {
            while (!Files.exists(part) || Files.size(part) == 0) {
                assertThat(process.isAlive()).isTrue();
                Thread.sleep(1);
            }
            process.destroy();
            while (Files.exists(folder.resolve(".simpleray-out.lock"))) {
                Thread.sleep(1);
            }
            try (AtomicFile second = new AtomicFile(out)) {
                second.out().write(new byte[1 << 16]);
                second.out().flush();
                assertThat(process.waitFor(60, TimeUnit.SECONDS)).isTrue();
                assertThat(out).hasContent(OLD);
                assertThat(part).hasSize(1 << 16);
                second.commit();
            }
        } finally {
            process.destroyForcibly();
        }
        assertThat(process.exitValue()).isEqualTo(ExitCode.TERMINATED);
        assertThat(out).hasSize(1 << 16);
        assertOnly(out, folder.resolve("out.part"));          // its finished rows
    }

    /** The picture is whole, whatever the end of the program has to wait for. */
    @ParameterizedTest
    @CsvSource({"rename=5000, out", "unlink=5000, out.part"})
    void aRenderingToldToStopWhileItsPictureComesToItsPlaceIsFinished(String slow, String where) throws IOException, InterruptedException {
        Path part = folder.resolve(".simpleray-out.part");
        Files.writeString(out, OLD);
        ProcessBuilder slowly = program("", "render @ball.scene --size 20x20 -q --checkpoint " + folder.resolve("out.part") + " -o " + out);
        slowly.environment().putAll(Map.of("DISK_PATH", folder.resolve(where).toString(), "SLOW", slow));
        Process process = slowly.start();
        try (BufferedReader err = process.errorReader()) {
            while (!isWholePng(part) && !isWholePng(out)) {
                assertThat(process.isAlive()).isTrue();
                Thread.sleep(1);
            }
            Thread.sleep(1000);                               // it has been written, and waits for the disk
            process.toHandle().destroy();
            assertThat(process.waitFor(60, TimeUnit.SECONDS)).isTrue();

            assertThat(process.exitValue()).isEqualTo(ExitCode.TERMINATED);
            assertThat(err.lines()).isEmpty();
        } finally {
            process.destroyForcibly();
        }
        assertOnly(out);
        assertThat(InProcess.run("verify", out.toString()).exitCode()).isEqualTo(ExitCode.DONE);
    }

    private static boolean isWholePng(Path file) throws IOException {
        try {
            return new String(Files.readAllBytes(file), StandardCharsets.ISO_8859_1).contains("IEND");
        } catch (NoSuchFileException e) {
            return false;                                     // not begun yet, or moved just now
        }
    }
}
