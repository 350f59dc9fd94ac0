package simpleray.ui;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.spi.ToolProvider;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.io.TempDir;
import simpleray.Project;
import simpleray.cli.Main;
import simpleray.ui.file.SceneSource;

/** What the package of the program holds, beside the program. */
class PackageTest {
    @TempDir
    private Path folder;

    @WindowTest
    void theIconIsWhatTheProgramMakesOfItsScene() throws IOException {
        Path resources = Project.root().resolve("src/main/resources/simpleray");
        Path made = folder.resolve("icon.png");
        String[] command = {"render", resources.resolve("icon.scene").toString(), "-o", made.toString(), "--size", "256x256",
            "--samples", "adaptive", "-q"};
        assertThat(Main.run(command, System.in, System.out, System.err)).isZero();

        BufferedImage icon = ImageIO.read(resources.resolve("icon.png").toFile());
        assertThat(icon.getWidth()).isEqualTo(256);
        assertThat(TestScenes.sameAs(ImageIO.read(made.toFile()), icon)).isTrue();
    }

    @WindowTest
    void theWindowHasTheIcon() {
        try (OpenWindow window = new OpenWindow(SceneSource.NONE, 64, 64)) {
            Screen.until("it has the icon", () -> !window.frame.getIconImages().isEmpty());

            assertThat(window.frame.getIconImages()).extracting(image -> image.getWidth(null))
                .containsExactly(16, 24, 32, 48, 64, 128, 256);
        }
    }

    @Tag("slow")
    @WindowTest
    void theJavaInThePackageHasEveryModuleThatTheProgramNeeds() throws IOException {
        StringWriter needed = new StringWriter();
        ToolProvider jdeps = ToolProvider.findFirst("jdeps").orElseThrow();
        assertThat(jdeps.run(new PrintWriter(needed), new PrintWriter(needed), "--print-module-deps", "--ignore-missing-deps",
            "--multi-release", "17", Project.jar().toString())).isZero();
        Matcher packed = Pattern.compile("'--add-modules', '([^']+)'").matcher(Files.readString(Project.root().resolve("build.gradle")));
        assertThat(packed.find()).isTrue();

        assertThat(List.of(packed.group(1).split(","))).contains(needed.toString().strip().split(","));
    }
}
