package simpleray.cli;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import simpleray.Project;

/** Folders in which not everything can be done: a container's, another user's. */
class ForeignFolderTest {
    private static final String NOBODY = "65534";
    private static final String RESULT = "# number of objects";

    @TempDir
    Path folder;
    private Path disk;

    @BeforeEach
    void writeWhatIsThere() throws IOException {
        assumeTrue(Files.isExecutable(Path.of("/bin/sh")), "no shell");
        Files.writeString(folder.resolve("grey.scene"), SmallScenes.GREY);
        disk = Files.createDirectory(folder.resolve("disk"));
        Files.writeString(disk.resolve("out"), "the old one");
        Files.writeString(folder.resolve("host"), "of the host");
    }

    private Program.Result convert(List<String> before) throws IOException, InterruptedException {
        return run(before, "convert", "grey.scene", "disk/out");
    }

    private Program.Result run(List<String> before, String... line) throws IOException, InterruptedException {
        ProcessBuilder program = Program.program(folder, List.of(), line);
        program.command().addAll(0, before);
        return Program.finish(program.start(), new byte[0]);
    }

    private Program.Result mounted(String mounts) throws IOException, InterruptedException {
        Program.Result tried = tryOut(List.of("/usr/bin/env", "unshare", "-rm", "/bin/sh", "-c", mounts));
        assumeTrue(tried != null && tried.exitCode() == 0, "nothing can be mounted here");
        return convert(List.of("/usr/bin/env", "unshare", "-rm", "/bin/sh", "-c", mounts + " && exec \"$@\"", "sh"));
    }

    private Program.Result tryOut(List<String> command) throws InterruptedException {
        try {
            return Program.finish(new ProcessBuilder(command).directory(folder.toFile()).start(), new byte[0]);
        } catch (IOException e) {                             // there is no such command
            return null;
        }
    }

    /** As who has no rights here: only root can be somebody else. */
    private Program.Result asNobody() throws IOException, InterruptedException {
        return asNobody("convert", "grey.scene", "disk/out");
    }

    private Program.Result asNobody(String... line) throws IOException, InterruptedException {
        List<String> nobody = List.of("setpriv", "--reuid", NOBODY, "--regid", NOBODY, "--clear-groups");
        Files.setPosixFilePermissions(folder, PosixFilePermissions.fromString("rwxr-xr-x"));
        Program.Result tried = tryOut(Stream.concat(nobody.stream(), Stream.of("test", "-r", Project.jar().toString())).toList());
        assumeTrue(tried != null && tried.exitCode() == 0, "not root, or nobody else may read the program");
        return run(nobody, line);
    }

    private void assertOnlyOut() throws IOException {
        try (Stream<Path> all = Files.list(disk)) {
            assertThat(all).containsExactly(disk.resolve("out"));
        }
    }

    @Test
    void aFileThatIsMountedIntoAContainerIsOverwrittenInPlace() throws IOException, InterruptedException {
        Program.Result result = mounted("mount --bind host disk/out");

        assertThat(result.err()).isEqualTo("simpleray: disk/out: cannot be replaced (Device or resource busy): it was overwritten in place\n");
        assertThat(result.exitCode()).isZero();
        assertThat(folder.resolve("host")).content().startsWith(RESULT);
        assertThat(disk.resolve("out")).hasContent("the old one");
        assertOnlyOut();
    }

    @Test
    void soItIsWhereTheFolderIsToReadOnly() throws IOException, InterruptedException {
        Program.Result result = mounted("mount --bind disk disk && mount -o remount,ro,bind disk && mount --bind host disk/out");

        assertThat(result.err()).isEqualTo("simpleray: disk/out: its folder takes no new file (Read-only file system): "
            + "the old file is overwritten in place\n");
        assertThat(result.exitCode()).isZero();
        assertThat(folder.resolve("host")).content().startsWith(RESULT);
    }

    @Test
    void soIsAWritableFileInAWriteProtectedFolder() throws IOException, InterruptedException {
        Files.setPosixFilePermissions(disk.resolve("out"), PosixFilePermissions.fromString("rw-rw-rw-"));

        Program.Result result = asNobody();

        assertThat(result.err()).isEqualTo("simpleray: disk/out: its folder takes no new file (permission denied): "
            + "the old file is overwritten in place\n");
        assertThat(result.exitCode()).isZero();
        assertThat(disk.resolve("out")).content().startsWith(RESULT);
        assertOnlyOut();
    }

    @Test
    void soIsAnothersFileInAStickyFolder() throws IOException, InterruptedException {
        Files.setPosixFilePermissions(disk.resolve("out"), PosixFilePermissions.fromString("rw-rw-rw-"));
        assumeTrue(tryOut(List.of("chmod", "1777", disk.toString())).exitCode() == 0, "no chmod");

        Program.Result result = asNobody();

        assertThat(result.err()).isEqualTo("simpleray: disk/out: cannot be replaced (Operation not permitted): it was overwritten in place\n");
        assertThat(result.exitCode()).isZero();
        assertThat(disk.resolve("out")).content().startsWith(RESULT);
        assertOnlyOut();
    }

    @Test
    void whatAnotherUsersKilledRunLeftIsInNobodysWay() throws IOException, InterruptedException {
        Files.delete(disk.resolve("out"));
        Path part = Files.writeString(disk.resolve(".simpleray-out.part"), "half");
        Path lock = Files.writeString(disk.resolve(".simpleray-out.lock"), "\0");
        assumeTrue(tryOut(List.of("chmod", "1777", disk.toString())).exitCode() == 0, "no chmod");

        Program.Result result = asNobody();

        assertThat(result.err()).isEqualTo("simpleray: disk/out: cannot be locked (permission denied): "
            + "another run that writes it at the same time is not noticed\n");
        assertThat(result.exitCode()).isZero();
        assertThat(disk.resolve("out")).content().startsWith(RESULT);
        assertThat(part).hasContent("half");
        assertThat(lock).exists();
    }

    @Test
    void aFolderThatMayNotBeEnteredIs73() throws IOException, InterruptedException {
        Files.setPosixFilePermissions(disk, PosixFilePermissions.fromString("rw-rw-rw-"));

        Program.Result result = asNobody();

        assertThat(result.err()).isEqualTo("simpleray: disk/out: cannot be created: its folder may not be entered\n");
        assertThat(result.exitCode()).isEqualTo(ExitCode.NO_OUTPUT);
        assertThat(disk.resolve("out")).hasContent("the old one");
    }

    @ParameterizedTest
    @CsvSource({"check, 66", "print, 66", "verify, 66", "compare, 2"})
    void whatIsToBeReadThereIsNotSaidToBeMissing(String command, int code) throws IOException, InterruptedException {
        Files.setPosixFilePermissions(disk, PosixFilePermissions.fromString("rw-rw-rw-"));
        List<String> line = new ArrayList<>(List.of(command, "disk/out"));
        if (command.equals("compare")) {
            line.add("disk/out");
        }
        Program.Result result = asNobody(line.toArray(new String[0]));

        assertThat(result.err()).isEqualTo("simpleray: disk/out: may not be read\n");
        assertThat(result.exitCode()).isEqualTo(code);
    }

    @Test
    void aFileThatMayOnlyBeReadIs73() throws IOException, InterruptedException {
        Files.setPosixFilePermissions(disk, PosixFilePermissions.fromString("rwxrwxrwx"));

        Program.Result result = asNobody();

        assertThat(result.err()).isEqualTo("simpleray: disk/out: cannot be created: is write-protected\n");
        assertThat(result.exitCode()).isEqualTo(ExitCode.NO_OUTPUT);
        assertOnlyOut();
    }
}
