package simpleray;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.awt.image.BufferedImage;
import java.awt.image.Raster;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.File;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import simpleray.cli.Main;
import simpleray.image.Picture;
import simpleray.render.RenderListener;
import simpleray.render.RenderRequest;
import simpleray.render.RenderSettings;
import simpleray.render.Stage;
import simpleray.scene.Material;
import simpleray.scene.Scene;
import simpleray.scene.SceneFile;
import simpleray.scene.SceneSettings;

/** POV-Ray, which others wrote, makes the same pictures as we do: shadows, reflections, refraction and shapes are right. */
class PovrayWitnessTest {
    private static final int SIZE = 160;
    /** Differences of levels that rounding explains. */
    private static final int NEARBY = 1;
    private static final double SAME_PIXELS = 0.995;
    private static final long SECONDS = 120;
    /** Scenes that POV-Ray has no words for, and why. */
    private static final Map<String, String> INEXPRESSIBLE = Map.of(
        "mesh.scene", "its glass knot is not convex: POV-Ray dims a shadow at each of its walls, and not once");

    @TempDir
    private Path folder;

    static List<Path> scenes() throws IOException {
        List<Path> all = new ArrayList<>();
        for (Path where : List.of(Path.of(System.getProperty("simpleray.scenes")),
                Path.of(System.getProperty("simpleray.root"), "src/test/resources/simpleray/povray"))) {
            try (Stream<Path> files = Files.list(where)) {
                files.filter(f -> f.toString().endsWith(".scene")).sorted().forEach(all::add);
            }
        }
        return Sample.of(all.stream().filter(f -> !INEXPRESSIBLE.containsKey(f.getFileName().toString())).toList(), 4);
    }

    @BeforeAll
    static void povrayIsThere() {
        boolean there = Arrays.stream(System.getenv().getOrDefault("PATH", "").split(File.pathSeparator))
            .anyMatch(dir -> Files.isExecutable(Path.of(dir, "povray")));
        assumeTrue(there, "there is no povray on the PATH");
    }

    @ParameterizedTest
    @MethodSource("scenes")
    void povrayMakesTheSamePicture(Path file) throws IOException, InterruptedException {
        Scene scene = SceneFile.read(file).scene();
        SceneSettings asked = new SceneSettings();
        asked.resolution = new SceneSettings.Resolution(SIZE, SIZE);
        asked.samples = 1;
        asked.depth = commonDepth(scene);
        Picture ours = new RenderRequest(asked, Stage.FINAL, false, Runtime.getRuntime().availableProcessors())
            .renderer(scene).render(RenderListener.NONE);

        Raster[] theirs = povray(file, asked.depth, ours.hasAlpha());

        int different = 0;
        int worst = 0;
        BufferedImage difference = new BufferedImage(3 * SIZE, SIZE, BufferedImage.TYPE_INT_RGB);
        for (int y = 0; y < SIZE; y++) {
            for (int x = 0; x < SIZE; x++) {
                int most = 0;
                for (int band = 0; band < ours.channels(); band++) {
                    int our = Picture.level(ours.row(y)[ours.channels() * x + band]);
                    int their = band < 3 ? theirs[band].getSample(x, y, 0) : theirs[0].getSample(x, y, band);
                    int shift = 8 * (2 - band & 3);           // of alpha 24, which is not shown
                    int[] shown = {our, their, Math.min(255, 20 * Math.abs(our - their))};
                    for (int i = 0; i < shown.length; i++) {
                        difference.setRGB(x + i * SIZE, y, difference.getRGB(x + i * SIZE, y) | shown[i] << shift);
                    }
                    most = Math.max(most, Math.abs(our - their));
                }
                different += most > NEARBY ? 1 : 0;
                worst = Math.max(worst, most);
            }
        }
        double same = 1 - (double) different / (SIZE * SIZE);
        Path failure = Path.of(System.getProperty("simpleray.build"), "povray-failures", file.getFileName() + ".png");
        if (same < SAME_PIXELS) {
            Files.createDirectories(failure.getParent());
            ImageIO.write(difference, "png", failure.toFile());
        }
        System.out.printf("%s: %.3f %% of the pixels within %d level, the worst %d off%n", file.getFileName(), 100 * same, NEARBY, worst);
        assertThat(same).as("share of pixels that are as POV-Ray's; ours, POV-Ray's and 20 times the difference are in " + failure)
            .isGreaterThanOrEqualTo(SAME_PIXELS);
    }

    /** {@return a depth that no mirroring material cuts short: POV-Ray has one for all of them} */
    private static int commonDepth(Scene scene) {
        int depth = scene.settings.depth == null ? RenderSettings.DEFAULT_DEPTH : scene.settings.depth;
        for (int i = 0; i < scene.getNumberObjects(); i++) {
            Material material = scene.getObject(i).surfaceMaterial;
            boolean follows = !material.mirrored().isBlack() || !material.transmission.isBlack();
            if (follows && material.reflections() > 0) {
                depth = Math.min(depth, material.reflections());
            }
        }
        return depth;
    }

    /** {@return POV-Ray's grey pictures of red, green and blue, each with alpha if asked for} */
    private Raster[] povray(Path file, int depth, boolean alpha) throws IOException, InterruptedException {
        List<Process> running = new ArrayList<>();
        for (String channel : List.of("r", "g", "b")) {
            Path exported = folder.resolve(channel + ".pov");
            ByteArrayOutputStream messages = new ByteArrayOutputStream();
            int status = Main.run(new String[] {"export", "--pov", file.toString(), "-o", exported.toString(), "--channel", channel,
                "--depth", Integer.toString(depth), "--size", SIZE + "x" + SIZE}, new ByteArrayInputStream(new byte[0]),
                new ByteArrayOutputStream(), new PrintStream(messages, true, StandardCharsets.UTF_8));
            assertThat(status).as(messages.toString(StandardCharsets.UTF_8)).isZero();
            assertThat(messages.toString(StandardCharsets.UTF_8).lines().filter(line -> line.contains("POV-Ray")))
                .allMatch(line -> line.contains(", maybe: "));
            running.add(new ProcessBuilder("povray", "+I" + channel + ".pov", "+O" + channel + ".png", "+W" + SIZE, "+H" + SIZE, "-A",
                "-D", "-V", "-GA", "+WT1", "+FN8", "File_Gamma=1.0", alpha ? "+UA" : "-UA").directory(folder.toFile()).redirectErrorStream(true)
                .redirectOutput(folder.resolve(channel + ".log").toFile()).start());
        }
        Raster[] pictures = new Raster[running.size()];
        for (int band = 0; band < pictures.length; band++) {
            String channel = "rgb".substring(band, band + 1);
            Process process = running.get(band);
            boolean ended = process.waitFor(SECONDS, TimeUnit.SECONDS);
            process.destroyForcibly();
            assertThat(ended && process.exitValue() == 0).as(Files.readString(folder.resolve(channel + ".log"))).isTrue();
            pictures[band] = ImageIO.read(folder.resolve(channel + ".png").toFile()).getRaster();
        }
        return pictures;
    }
}
