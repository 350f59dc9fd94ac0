package simpleray.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** {@code --allow-outside} is known by all commands that read scenes. */
class OutsideOptionTest {
    private static final String TEXT = "1\n4 \"../out.obj\" 0 0 0 1  1 1 1  1 1 1  0 0 0  2\n0 0 0\n0\n";

    @TempDir
    private Path all;
    private Path scene;

    @BeforeEach
    void aSceneNamesAFileOutsideItsFolder() throws IOException {
        Files.writeString(all.resolve("out.obj"), "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
        scene = Files.writeString(Files.createDirectory(all.resolve("mine")).resolve("a.scene"), TEXT);
    }

    @ParameterizedTest
    @ValueSource(strings = {"render SCENE -q --size 4x4 -o mine/a.png", "figures SCENE -q --size 4x4 -d mine", "print SCENE", "check SCENE",
        "convert SCENE mine/b.scene", "still SCENE -o mine/b.scene", "explain SCENE -q --size 4x4 --pixel 0,0", "export SCENE --pov -o mine/a.pov"})
    void aFileOutsideIsRefusedWithoutItAndReadWithIt(String line) {
        String[] args = line.replace("mine/", scene.getParent() + "/").replace("SCENE", scene.toString()).split(" ");
        if (line.endsWith("-d mine")) {
            args[args.length - 1] = scene.getParent().toString();
        }

        Program.Result refused = InProcess.run(args);
        args = (String.join(" ", args) + " --allow-outside").split(" ");
        Program.Result read = InProcess.run(args);

        assertThat(refused.exitCode()).isEqualTo(ExitCode.BAD_SCENE);
        assertThat(refused.err()).startsWith(scene + ":2:3: error: expected object 1's OBJ file within the scene's folder "
            + "(--allow-outside allows any), found '\"../out.obj\"'\n");
        assertThat(read.exitCode()).isZero();
    }

    @Test
    void aPictureOfSuchASceneIsVerifiedAndOpenedWithItAlone() {
        String picture = scene.resolveSibling("a.png").toString();
        InProcess.run("render", scene.toString(), "-q", "--size", "4x4", "-o", picture, "--allow-outside");
        String refused = picture + ":2:3: error: expected object 1's OBJ file within the scene's folder ";

        assertThat(InProcess.run("verify", picture, "-q").err()).startsWith(refused);
        assertThat(InProcess.run("check", picture, "--errors", "json").text()).contains("the scene's folder (--allow-outside allows any)");
        assertThat(InProcess.run("verify", picture, "-q", "--allow-outside").text()).isEqualTo(picture + ": good: all 16 pixels are the same\n");
        assertThat(InProcess.run("check", picture, "--errors", "json", "--allow-outside").exitCode()).isZero();
    }

    @Test
    void fromStandardInputTheFolderIsTheWorkingDirectory() {
        assertThat(InProcess.runWithInput(TEXT, "check", "-").err()).startsWith("<stdin>:2:3: error: expected object 1's OBJ file within ");
    }
}
