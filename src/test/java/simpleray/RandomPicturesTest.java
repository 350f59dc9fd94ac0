package simpleray;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.File;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.LongStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.MethodOrderer;
import org.junit.jupiter.api.Order;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestMethodOrder;
import org.junit.jupiter.api.io.TempDir;
import simpleray.cli.Program;
import simpleray.render.Renderer;

/** The engine's pictures are the plain loop's, on any number of threads and by any Java; and there is no pixel that is no number. */
@TestMethodOrder(MethodOrderer.OrderAnnotation.class)
class RandomPicturesTest {
    private static final long SEED = 20261122;
    private static final int SCENES = Sample.size(10_000, 1000);
    private static final int SCENES_OF_BOTH = Sample.size(2_000, 200);

    private static long[] sums;                               // found once, for both tests

    @TempDir
    Path folder;

    /** Fails itself if there is a difference. */
    @Test
    @Order(1)
    void theEngineMakesThePicturesOfTheLoop() {
        sums = RandomPictures.sums(SEED, SCENES, folder);

        assertThat(LongStream.of(sums).distinct().count()).as("different pictures").isGreaterThan(SCENES * 9 / 10);
    }

    @Test
    @Order(2)
    void anotherJavaMakesTheSamePictures() throws Exception {
        Path other = OtherJava.home();
        String classPath = Stream.of(RandomPictures.class, Renderer.class)
            .map(OtherJava::place).distinct().collect(Collectors.joining(File.pathSeparator));
        Program.Result result = Program.finish(Program.java(other, folder,
            List.of("-cp", classPath, RandomPictures.class.getName(), "" + SEED, "" + SCENES_OF_BOTH)).start(), new byte[0]);

        assertThat(result.err()).isEmpty();
        assertThat(result.text().strip()).isEqualTo("" + (sums == null ? RandomPictures.sums(SEED, SCENES_OF_BOTH, folder)
            : sums)[SCENES_OF_BOTH - 1]);
    }
}
