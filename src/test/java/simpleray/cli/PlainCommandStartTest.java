package simpleray.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.List;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import simpleray.Project;

/** A plain rendering starts soon because it needs no classes that take long to be made ready. */
class PlainCommandStartTest {
    @Test
    void aPlainRenderingNeedsNeitherLambdasNorPicocli(@TempDir Path folder) throws Exception {
        Process process = Program.program(folder, List.of("-Xlog:class+load"), "render", Project.scene("thesis").toString(),
            "-o", "a.png", "--size", "8x8", "-q").start();
        Program.Result result = Program.finish(process, new byte[0]);

        assertThat(result.exitCode()).as(result.err()).isZero();
        List<String> loaded = result.text().lines().collect(Collectors.toList());
        assertThat(loaded).as("what is loaded").hasSizeGreaterThan(400).anyMatch(line -> line.contains(" simpleray.render.Renderer "))
            .noneMatch(line -> line.contains(" simpleray.") && line.contains("Lambda$") || line.contains(" picocli."));
    }
}
