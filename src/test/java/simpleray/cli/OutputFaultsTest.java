package simpleray.cli;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Outputs that cannot be, for every command that writes: known before anything is done. */
class OutputFaultsTest {
    @TempDir
    Path folder;

    @BeforeEach
    void writeScene() throws IOException {
        Files.writeString(folder.resolve("grey.scene"), SmallScenes.GREY);
        Files.createDirectory(folder.resolve("disk"));
    }

    /** {@return a command line, in which @ stands for the folder} */
    private Program.Result run(String line) {
        return InProcess.run(line.replace("@", folder + "/").split(" "));
    }

    @ParameterizedTest
    @ValueSource(strings = {"render @grey.scene --progress plain -o", "convert @grey.scene", "export --pov @grey.scene -o"})
    void aMissingFolderAndAFolderInTheWayAre73(String line) {
        Program.Result missing = run(line + " @none/out");
        assertThat(missing.err()).isEqualTo("simpleray: " + folder + "/none/out: cannot be created: there is no folder " + folder
            + "/none\n");
        assertThat(missing.exitCode()).isEqualTo(ExitCode.NO_OUTPUT);

        Program.Result inTheWay = run(line + " @disk");
        assertThat(inTheWay.err()).isEqualTo("simpleray: " + folder + "/disk: cannot be created: is a folder\n");
        assertThat(inTheWay.exitCode()).isEqualTo(ExitCode.NO_OUTPUT);
    }

    @Test
    void aFileInPlaceOfTheFolderOfFiguresIs73() {
        Program.Result result = run("figures @grey.scene -d @grey.scene --progress plain");

        assertThat(result.err()).isEqualTo("simpleray: " + folder + "/grey.scene: cannot be created: " + folder
            + "/grey.scene is no folder\n");
        assertThat(result.exitCode()).isEqualTo(ExitCode.NO_OUTPUT);
    }

    /** A real disk that is mounted to be read only; seen by this test alone. */
    @ParameterizedTest
    @ValueSource(strings = {"render grey.scene --progress plain -o disk/out", "convert grey.scene disk/out",
        "export --pov grey.scene -o disk/out", "figures grey.scene -d disk", "compare grey.png grey.png --heatmap disk/out",
        "render grey.scene -o grey2.png --checkpoint disk/out"})
    void aDiskToReadOnlyIs73(String line) throws IOException, InterruptedException {
        assertThat(run("render @grey.scene -o @grey.png -q --size 2x2").exitCode()).isZero();
        assumeTrue(shell("true").exitCode() == 0, "nothing can be mounted here");

        Program.Result result = shell(line.split(" "));

        assertThat(result.err()).matches("simpleray: disk/(out|grey-stages\\.png): (cannot be created: )?Read-only file system\n");
        assertThat(result.exitCode()).isEqualTo(ExitCode.NO_OUTPUT);
    }

    private Program.Result shell(String... line) throws IOException, InterruptedException {
        ProcessBuilder program = Program.program(folder, List.of(), line);
        String then = line[0].equals("true") ? "true" : "exec \"$@\"";
        program.command().addAll(0,
            List.of("/usr/bin/env", "unshare", "-rm", "/bin/sh", "-c", "mount -t tmpfs -o ro tmpfs disk && " + then, "sh"));
        return Program.finish(program.start(), new byte[0]);
    }

    @ParameterizedTest
    @ValueSource(strings = {"0x0", "5x0", "0x5", "-5x5", "5x-5", "2000000000x2000000000", "65536x1", "1x65536"})
    void aSizeThatCannotBeIs2WithTheLimit(String size) {
        for (String command : List.of("render @grey.scene -o @a.png", "figures @grey.scene -d @sheets", "view @grey.scene")) {
            Program.Result result = run(command + " --size " + size);

            String name = "simpleray " + command.substring(0, command.indexOf(' '));
            assertThat(result.err()).isEqualTo(name + ": Invalid value for option '--size': expected WxH such as 640x480, "
                + "1 to 65535 each, found '" + size + "' (see " + name + " --help)\n");
            assertThat(result.exitCode()).isEqualTo(ExitCode.USAGE);
        }
        assertThat(folder.resolve("a.png")).doesNotExist();
        assertThat(folder.resolve("sheets")).doesNotExist();
    }
}
