package simpleray.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import simpleray.Project;
import simpleray.Sample;

/**
 * Renderings that are killed (SIGKILL), go on, are killed again, until their picture is whole: it is that of one that was never killed,
 * byte for byte. Moments are random, up to nine tenths of the time that an unbroken rendering takes: many come before the first row,
 * many in the middle. The seed is printed, and another may be given as the system property simpleray.seed.
 */
class RenderCommandKilledTest {
    private static final int KILLS = Sample.size(200, 20);
    /** Kills at the start, before any row, show little; of as many, these at least are to be later. */
    private static final int LATE_KILLS = Sample.size(20, 2);
    private static final int SERIES = 2;
    private static final double LATEST = 0.9;

    @TempDir
    Path folder;
    private final AtomicInteger killed = new AtomicInteger();
    private final AtomicInteger withRows = new AtomicInteger();
    private final AtomicInteger pictures = new AtomicInteger();

    @Test
    @Timeout(value = 900, threadMode = Timeout.ThreadMode.SEPARATE_THREAD)
    void aKilledRenderingGoesOnToTheSamePicture() throws IOException {
        long seed = Long.getLong("simpleray.seed", System.nanoTime());
        System.out.println("RenderCommandKilledTest: seed " + seed + " (-Dsimpleray.seed=" + seed + ")");
        List<CompletableFuture<Void>> series = new ArrayList<>();
        for (int i = 0; i < SERIES; i++) {
            String name = "series-" + i;
            Path own = Files.createDirectory(folder.resolve(name));
            List<String> options = i == 0 ? List.of(Project.scene("thesis").toString(), "--size", "100x140")
                : List.of(Project.scene("thesis").toString(), "--size", "60x90", "--samples", "adaptive");
            Random random = new Random(seed + i);
            series.add(CompletableFuture.runAsync(() -> {
                try {
                    killAndGoOn(own, options, random);
                } catch (IOException | InterruptedException e) {
                    throw new IllegalStateException(e);
                }
            }));
        }
        series.forEach(CompletableFuture::join);

        System.out.println("RenderCommandKilledTest: " + killed + " kills, " + withRows + " of them with rows kept; " + pictures + " pictures");
        assertThat(killed.get()).isGreaterThanOrEqualTo(KILLS);
        assertThat(withRows.get()).isGreaterThanOrEqualTo(LATE_KILLS);
        assertThat(pictures.get()).isGreaterThanOrEqualTo(SERIES);
    }

    private void killAndGoOn(Path own, List<String> options, Random random) throws IOException, InterruptedException {
        long time = Long.MAX_VALUE;
        for (int i = 0; i < 2; i++) {                         // the first time files come from the disk
            long begin = System.nanoTime();
            assertThat(start(own, options, "whole.png", "whole.part").waitFor()).isZero();
            time = Math.min(time, System.nanoTime() - begin);
        }
        byte[] expected = Files.readAllBytes(own.resolve("whole.png"));
        while (killed.get() < KILLS || withRows.get() < LATE_KILLS) {
            boolean fromTheStart = !Files.exists(own.resolve("killed.part"));
            long begin = System.nanoTime();
            Process process = start(own, options, "killed.png", "killed.part");
            if (process.waitFor((long) (random.nextDouble() * LATEST * time), TimeUnit.NANOSECONDS)) {
                time = fromTheStart ? Math.min(time, System.nanoTime() - begin) : time;   // the first ones may have been slow
                assertWhole(own, process, expected);
            } else {
                process.destroyForcibly().waitFor();
                killed.incrementAndGet();
                withRows.addAndGet(Files.exists(own.resolve("killed.part")) && Files.size(own.resolve("killed.part")) > 1000 ? 1 : 0);
                if (Files.exists(own.resolve("killed.png"))) {                 // killed between its last steps
                    assertThat(Files.readAllBytes(own.resolve("killed.png"))).isEqualTo(expected);
                }
            }
        }
        assertWhole(own, start(own, options, "killed.png", "killed.part"), expected);
    }

    private void assertWhole(Path own, Process process, byte[] expected) throws IOException, InterruptedException {
        assertThat(process.waitFor()).as(Files.readString(own.resolve("err"))).isZero();
        assertThat(Files.readAllBytes(own.resolve("killed.png"))).isEqualTo(expected);
        assertThat(own.resolve("killed.part")).doesNotExist();
        try (Stream<Path> files = Files.list(own)) {
            assertThat(files.map(file -> file.getFileName().toString())).as("nothing that a killed one left")
                .containsExactlyInAnyOrder("whole.png", "killed.png", "err");
        }
        Files.delete(own.resolve("killed.png"));
        pictures.incrementAndGet();
    }

    private static Process start(Path own, List<String> options, String out, String checkpoint) throws IOException {
        List<String> args = new ArrayList<>(List.of("-Xshare:auto", "-XX:+UseSerialGC", "-Xmx64m", "-cp", Project.jar().toString(),
            "simpleray.cli.Main", "render", "-o", out, "--checkpoint", checkpoint, "--resume", "-q", "--threads", "1"));
        args.addAll(options);
        return Program.java(Path.of(System.getProperty("java.home")), own, args).redirectOutput(ProcessBuilder.Redirect.DISCARD)
            .redirectError(own.resolve("err").toFile()).start();
    }
}
