package simpleray.render;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import simpleray.scene.Terms;

class RenderSettingsTest {
    @Test
    void theDefaultsAreFinalDepthTenAndAThreadForEachProcessor() {
        assertThat(new RenderSettings())
            .isEqualTo(new RenderSettings(Stage.FINAL, 10, 1, Runtime.getRuntime().availableProcessors()));
    }

    @Test
    void anotherStageLeavesTheRestAsItIs() {
        assertThat(new RenderSettings(Stage.FINAL, 3, 7, 5).with(Stage.DIFFUSE)).isEqualTo(new RenderSettings(Stage.DIFFUSE, 3, 7, 5));
    }

    @ParameterizedTest
    @ValueSource(ints = {-1, 1001, Integer.MIN_VALUE})
    void theDepthIsFromZeroToAThousand(int depth) {
        assertThat(new RenderSettings(Stage.FINAL, 0, 1, 1).depth()).isZero();
        assertThat(new RenderSettings(Stage.FINAL, 1000, 1, 1).depth()).isEqualTo(1000);
        assertThatThrownBy(() -> new RenderSettings(Stage.FINAL, depth, 1, 1)).isInstanceOf(IllegalArgumentException.class)
            .hasMessage("the depth must be 0 to 1000, and is " + depth);
    }

    @ParameterizedTest
    @ValueSource(ints = {-1, 17, Integer.MAX_VALUE})
    void samplesAreOneToSixteenOrAdaptive(int samples) {
        assertThat(new RenderSettings(Stage.FINAL, 10, 16, 1).samples()).isEqualTo(16);
        assertThat(new RenderSettings(Stage.FINAL, 10, RenderSettings.ADAPTIVE, 1).samples()).isZero();
        assertThatThrownBy(() -> new RenderSettings(Stage.FINAL, 10, samples, 1)).isInstanceOf(IllegalArgumentException.class)
            .hasMessage("the samples must be 1 to 16, and are " + samples);
    }

    @ParameterizedTest
    @ValueSource(ints = {0, -1})
    void atLeastOneThreadWorks(int threads) {
        assertThatThrownBy(() -> new RenderSettings(Stage.FINAL, 10, 1, threads)).isInstanceOf(IllegalArgumentException.class)
            .hasMessage("the number of threads must be 1 or more, and is " + threads);
    }

    @ParameterizedTest
    @CsvSource({"ORIGINAL, original", "LIGHTING, lighting", "FINAL, final", "AMBIENT, ambient", "DIFFUSE, diffuse", "SPECULAR, specular"})
    void aStageIsCalledByItsNameInLowerCase(Stage stage, String name) {
        assertThat(stage).hasToString(name);
    }

    @ParameterizedTest
    @CsvSource({"ORIGINAL, true, false, false, false, false", "LIGHTING, true, true, true, false, false",
        "FINAL, true, true, true, true, true", "AMBIENT, true, false, false, false, false",
        "DIFFUSE, false, true, false, false, false", "SPECULAR, false, false, true, false, false"})
    void aStageShowsItsTerms(Stage stage, boolean ambient, boolean diffuse, boolean specular, boolean shadows, boolean reflections) {
        assertThat(stage.terms()).isEqualTo(new Terms(ambient, diffuse, specular, shadows, reflections));
    }
}
