package simpleray.text;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class MisspellingTest {
    private static final List<String> KNOWN = List.of("samples", "depth", "cop", "camera", "compare");

    @ParameterizedTest
    @CsvSource({"sample, samples", "sampels, samples", "SAMPLES, samples", "smaples, samples", "xsamples, samples", "saXples, samples",
        "saXpXes, samples", "dept, depth", "debts, depth", "coop, cop", "co, cop", "cot, cop", "comera, camera", "compar, compare",
        "depth, depth"})
    void aWordIsTheNearest(String word, String meant) {
        assertThat(Misspelling.meant(word, KNOWN)).isEqualTo(meant);
    }

    @ParameterizedTest
    @CsvSource({"saYpYeY", "samYYY", "c", "cab", "YYpth1", "lights"})
    void whatDiffersMoreIsNone(String word) {
        assertThat(Misspelling.meant(word, KNOWN)).isNull();
    }

    @Test
    void ofTwoThatAreAsNearTheFirstIsMeant() {
        assertThat(Misspelling.meant("dapth", List.of("depth", "dipth"))).isEqualTo("depth");
        assertThat(Misspelling.meant("dipt", List.of("depth", "dipth"))).isEqualTo("dipth");
        assertThat(Misspelling.meant("word", List.of())).isNull();
    }
}
