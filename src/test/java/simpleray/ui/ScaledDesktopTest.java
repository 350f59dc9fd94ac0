package simpleray.ui;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.File;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import simpleray.Project;
import simpleray.cli.Main;
import simpleray.cli.Program;

/** The picture on desktops that show all else larger. */
class ScaledDesktopTest {
    @ParameterizedTest
    @ValueSource(strings = {"1.5", "2"})
    void aPixelOfThePictureIsAPixelOfTheScreenOrASquareOfThem(String scale, @TempDir Path folder) throws Exception {
        ProcessBuilder program = Program.java(Path.of(System.getProperty("java.home")), folder, List.of("-Dsun.java2d.uiScale=" + scale,
            "-Dsimpleray.scenes=" + System.getProperty("simpleray.scenes"), "-Dsimpleray.build=" + Project.build(),
            "-cp", classPath(), ScaledDesktop.class.getName()));
        program.environment().put("DISPLAY", System.getenv("DISPLAY"));
        Program.Result result = Program.finish(program.start(), new byte[0]);

        assertThat(result.err()).isEmpty();
        assertThat(result.text()).isEmpty();
        assertThat(result.exitCode()).isZero();
    }

    private static String classPath() throws Exception {
        return Stream.of(Main.class, ScaledDesktop.class).map(type -> type.getProtectionDomain().getCodeSource().getLocation().getPath())
            .collect(Collectors.joining(File.pathSeparator)) + File.pathSeparator + Project.jar();
    }
}
