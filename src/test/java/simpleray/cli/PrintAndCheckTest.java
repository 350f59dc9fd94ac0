package simpleray.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import simpleray.Project;

/** {@code print} and {@code check}: what a scene is, and what is wrong with it. */
class PrintAndCheckTest {
    @TempDir
    Path folder;

    @ParameterizedTest
    @ValueSource(strings = {"thesis", "thesis-as-printed"})
    void theThesisSceneIsInterpretedAsInTheThesis(String scene) throws IOException {
        Program.Result result = InProcess.run("print", Project.scene(scene).toString());

        assertThat(result.out()).isEqualTo(Files.readAllBytes(Project.resources("reference").resolve("thesis.interpretation.txt")));
        assertThat(result.exitCode()).isZero();
    }

    @Test
    void aSceneFromStandardInputIsPrintedWithItsWarningsApart() {
        Program.Result result = InProcess.runWithInput(SmallScenes.WITH_HEADING, "print", "-");

        assertThat(result.text()).isEqualTo("""
            Scene has 1 objects
            Scene has 0 lights
            Number of objects 1
            Plane with normal: [0.0,0.0,1.0] and constant: -2.0
            Material: ambient (1.0,1.0,1.0) diffuse (0.0,0.0,0.0) specular (0.0,0.0,0.0) shininess 1.0
            Ambient light is 0.5 0.5 0.5
            Number of lights 0
            """);
        assertThat(result.err()).isEqualTo(String.format(SmallScenes.HEADING_WARNING, "<stdin>"));
        assertThat(result.exitCode()).isZero();
    }

    @Test
    void everySampleSceneIsGood() {
        String[] args = Project.scenes().stream().map(name -> Project.scene(name).toString()).toArray(String[]::new);
        String[] line = new String[args.length + 1];
        line[0] = "check";
        System.arraycopy(args, 0, line, 1, args.length);

        Program.Result result = InProcess.run(line);

        assertThat(result.exitCode()).isZero();
        assertThat(result.text().lines()).hasSameSizeAs(args).allMatch(told -> told.contains(".scene: good: "));
        assertThat(result.err().lines().filter(told -> told.contains("warning: expected a value")))
            .as("the thesis's three headings").hasSize(3).allMatch(told -> told.startsWith(Project.scene("thesis-as-printed") + ":"));
    }

    @Test
    void aCheckTellsOfEachSceneAndEndsWithTheWorst() throws IOException {
        Path good = Files.writeString(folder.resolve("good.scene"), SmallScenes.GREY);
        Path odd = Files.writeString(folder.resolve("odd.scene"), SmallScenes.WITH_HEADING);
        Path bad = Files.writeString(folder.resolve("bad.scene"), SmallScenes.BAD);
        Path missing = folder.resolve("missing.scene");

        Program.Result both = InProcess.run("check", bad.toString(), odd.toString(), good.toString());
        Program.Result all = InProcess.run("check", missing.toString(), bad.toString(), good.toString());

        assertThat(both.text()).isEqualTo(odd + ": good: 1 object, 0 lights, 1 warning\n" + good + ": good: 1 object, 0 lights\n");
        assertThat(both.err()).isEqualTo(String.format(SmallScenes.BAD_REPORT, bad) + String.format(SmallScenes.HEADING_WARNING, odd));
        assertThat(both.exitCode()).isEqualTo(ExitCode.BAD_SCENE);
        assertThat(all.text()).isEqualTo(good + ": good: 1 object, 0 lights\n");
        assertThat(all.err()).isEqualTo("simpleray: " + missing + ": no such file\n" + String.format(SmallScenes.BAD_REPORT, bad));
        assertThat(all.exitCode()).isEqualTo(ExitCode.NO_SCENE);
    }

    @Test
    void aCheckReadsStandardInput() {
        Program.Result result = InProcess.runWithInput("0  1 1 1  1  0 1 1 1 0 0 0", "check", "-");

        assertThat(result.text()).isEqualTo("-: good: 0 objects, 1 light\n");
        assertThat(result.exitCode()).isZero();
    }
}
