package simpleray.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import simpleray.scene.SceneSettings.Resolution;

class JobPlanTest {
    /** {@return a job of a film, or of a scene without frames if they are null} */
    static JobPlan plan(String scene, String frames, int bands, int chunk, String... options) {
        return new JobPlan(scene, new Resolution(40, 30), frames == null ? null : FrameRanges.parse(frames), bands, chunk,
            frames == null || FrameRanges.parse(frames).count() == 1 ? null : "film.apng", List.of(options), new JobEstimate(256, 2, 12));
    }

    @ParameterizedTest
    @CsvSource(nullValues = "null", value = {"null, 1, 1, 1", "null, 3, 1, 3", "'0-23', 1, 1, 24", "'0-23', 3, 1, 72", "'0-23', 3, 5, 15",
        "'0-24', 3, 5, 15", "'0-25', 3, 5, 18", "'7', 2, 100, 2"})
    void eachBandOfEachChunkOfFramesIsATask(String frames, int bands, int chunk, long tasks) {
        assertThat(plan("a.scene", frames, bands, chunk).tasks()).isEqualTo(tasks);
    }

    @ParameterizedTest
    @CsvSource({"1, 1, 1", "1000, 1, 1", "1001, 1, 2", "500, 2, 1", "501, 2, 2", "2000, 1, 2", "2001, 1, 3", "1000000, 1, 1000", "1, 5000, 1",
        "3, 5000, 3", "1000000, 2000, 1000000"})
    void unlessAskedForThereAreAtMostAThousandTasksIfThatCanBe(int frames, int bands, int chunk) {
        assertThat(JobPlan.chunk(frames, bands)).isEqualTo(chunk);
    }

    @ParameterizedTest
    @CsvSource(nullValues = "null", value = {"null, 4", "'9999', 4", "'10000', 5", "'0-999999', 6", "'0', 4"})
    void numbersOfPicturesHaveTheDigitsOfTheLargestAndFourAtLeast(String frames, int digits) {
        assertThat(plan("a.scene", frames, 1, 1).digits()).isEqualTo(digits);
    }

    @ParameterizedTest
    @CsvSource({"room.scene, room", "room.txt, room", "room.png, room", "room.scene.bak, room.scene.bak", ".scene, .scene",
        "my 'best' room.scene, my__best__room", "50%.scene, 50_", "{{Param.x}}.scene, __Param.x__", "Käse.scene, K_se"})
    void theNameIsOneThatEachEngineTakes(String scene, String name) {
        assertThat(plan(scene, null, 1, 1).name()).isEqualTo(name);
    }

    @Test
    void theNameIsOfOneLineAndNotTooLong() {
        assertThat(plan("a\nb\t.scene", null, 1, 1).name()).isEqualTo("a_b_");
        assertThat(plan("x".repeat(64) + ".scene", null, 1, 1).name()).isEqualTo("x".repeat(64));
        assertThat(plan("x".repeat(65) + ".scene", null, 1, 1).name()).isEqualTo("x".repeat(64));
    }

    @ParameterizedTest
    @CsvSource(nullValues = "null", value = {"null, 1, one picture of 40x30", "null, 2, one picture of 40x30 in 2 bands",
        "'5', 1, 1 frame of 40x30", "'0-23', 3, 24 frames of 40x30 in 3 bands each"})
    void peopleAreToldWhatItMakes(String frames, int bands, String what) {
        assertThat(plan("a.scene", frames, bands, 1).what()).isEqualTo(what);
    }
}
