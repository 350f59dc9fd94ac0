package simpleray.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import simpleray.render.RenderRequest;
import simpleray.render.Stage;
import simpleray.scene.Scene;
import simpleray.scene.SceneFile;
import simpleray.scene.SceneSettings;
import simpleray.scene.SceneSettings.Resolution;

class JobEstimateTest {
    private static JobEstimate of(String text, int width, int height) throws IOException {
        Scene scene = SceneFile.parse(text).scene();
        SceneSettings asked = new SceneSettings();
        asked.resolution = new Resolution(width, height);
        return JobEstimate.of(new RenderRequest(asked, Stage.FINAL, false, 8), scene, null, 3);
    }

    @ParameterizedTest
    @CsvSource({"0, 256", "1, 256", "268435455, 256", "268435456, 320", "335544319, 320", "335544320, 384", "10737418240, 10304"})
    void theHeapIsRoundedUp(long bytes, long heap) {
        assertThat(JobEstimate.heap(bytes)).isEqualTo(heap);
    }

    @ParameterizedTest
    @CsvSource({"1, 5", "5, 5", "6, 10", "0.25, 5", "12, 15"})
    void theTimeIsFourTimesTheWorkAndRoundedUp(double pictures, long minutes) {
        assertThat(new JobEstimate(256, 2, 12).minutes(pictures)).isEqualTo(minutes);
    }

    @Test
    void aBandReadsTheSceneAsAWholePictureDoes() {
        assertThat(new JobEstimate(256, 299 / 4., 0).minutes(0.01)).isEqualTo(5);
        assertThat(new JobEstimate(256, 300 / 4., 0).minutes(0.01)).isEqualTo(10);
    }

    @Test
    void whatIsReadAndRenderedCounts() throws IOException {
        JobEstimate small = of(SmallScenes.ROUGH, 10, 10);
        JobEstimate large = of(SmallScenes.ROUGH, 20_000, 20_000);

        assertThat(small.start()).isBetween(5., 30.);
        assertThat(small.memory()).isGreaterThanOrEqualTo(256 + JobEstimate.JAVA).isEqualTo(small.heap() + JobEstimate.JAVA);
        assertThat(large.picture()).isGreaterThan(1000 * small.picture());
    }

    /** A sample that is not finished in its time counts by its rows. */
    @Test
    void aPictureThatTakesForEverIsNotWaitedFor() throws IOException {
        Scene scene = SceneFile.parse(SmallScenes.many(300)).scene();
        SceneSettings asked = new SceneSettings();
        asked.resolution = new Resolution(60_000, 60_000);
        asked.samples = SceneSettings.MAX_SAMPLES;
        RenderRequest request = new RenderRequest(asked, Stage.FINAL, false, 1).with(simpleray.render.Accel.NONE);

        assertThat(JobEstimate.of(request, scene, null, 0).picture()).isGreaterThan(3600);
    }
}
