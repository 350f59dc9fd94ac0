package simpleray.text;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

/** What the reader never asks for; the rest is in {@link SceneReaderNumbersTest}. */
class NumbersTest {
    @Test
    void nothingIsNoNumber() {
        assertThat(Numbers.parseDouble("")).isNaN();
        assertThat(Numbers.parseFloat("")).isNaN();
        assertThat(Numbers.parseInteger("", 0, 9)).isNull();
    }

    @Test
    void blanksAreNoPartOfANumber() {
        assertThat(Numbers.parseDouble(" 1")).isNaN();
        assertThat(Numbers.parseDouble("1 ")).isNaN();
        assertThat(Numbers.parseInteger(" 1", 0, 9)).isNull();
        assertThat(Numbers.parseInteger("1\n", 0, 9)).isNull();
    }

    @Test
    void anIntegerLiesBetweenTheLeastAndTheMost() {
        assertThat(Numbers.parseInteger("1", 1, 3)).isEqualTo(1);
        assertThat(Numbers.parseInteger("3", 1, 3)).isEqualTo(3);
        assertThat(Numbers.parseInteger("0", 1, 3)).isNull();
        assertThat(Numbers.parseInteger("4", 1, 3)).isNull();
    }

    @Test
    void aNumberIsWrittenAsShortAsItReadsBack() {
        assertThat(Numbers.shortest(0.1)).isEqualTo("0.1");
        assertThat(Numbers.shortest(-1e23)).isEqualTo("-1.0E23");
    }
}
