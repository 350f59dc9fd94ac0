package simpleray.render;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class BandTest {
    @ParameterizedTest
    @CsvSource({"1, 1", "7, 1", "7, 2", "7, 3", "7, 7", "240, 7", "65535, 65535", "65535, 4000"})
    void theBandsAreAllRowsOnceAndAsEvenAsCanBe(int height, int count) {
        Region whole = new Region(3, 5, 11, height);
        int next = 5;
        for (int i = 1; i <= count; i++) {
            Region band = new Band(i, count).of(whole);
            assertThat(band).isEqualTo(new Region(3, next, 11, band.height()));
            assertThat(band.height()).isBetween(height / count, (height + count - 1) / count);
            next = band.bottom();
        }
        assertThat(next).isEqualTo(5 + height);
    }

    @Test
    void theRowsAreNamedFromOneOn() {
        Region whole = new Region(0, 4, 1, 241);

        assertThat(new Band(1, 3).rows(whole)).isEqualTo("rows 1 to 80 of 241");
        assertThat(new Band(3, 3).rows(whole)).isEqualTo("rows 161 to 241 of 241");
        assertThat(new Band(241, 241).rows(whole)).isEqualTo("row 241 of 241");
    }

    @Test
    void aBandIsReadAsItIsWritten() {
        assertThat(Band.parse("2/3")).isEqualTo(new Band(2, 3)).hasToString("2/3");
        assertThat(Band.parse("1/1")).isEqualTo(new Band(1, 1));
    }

    @ParameterizedTest
    @ValueSource(strings = {"0/3", "-1/3", "4/3", "0/0", "1/0", "1/-1"})
    void aBandIsOneOfItsNumber(String text) {
        assertThatThrownBy(() -> Band.parse(text)).isInstanceOf(IllegalArgumentException.class)
            .hasMessage("bands are 1/N to N/N, such as 2/3, and this is " + text);
    }

    @ParameterizedTest
    @ValueSource(strings = {"", "2", "/", "2/", "/3", "2/3/4", "2,3", "a/3", "2/3.0", "2 /3", "1/99999999999"})
    void whatIsNoBandIsToldAsSuch(String text) {
        assertThatThrownBy(() -> Band.parse(text)).isInstanceOf(IllegalArgumentException.class)
            .hasMessage("expected a band such as 2/3, found '" + text + "'");
    }

    @Test
    void thereAreNoMoreBandsThanRows() {
        assertThat(new Band(3, 3).of(Region.whole(9, 3)).height()).isEqualTo(1);
        assertThatThrownBy(() -> new Band(1, 4).of(Region.whole(9, 3))).isInstanceOf(IllegalArgumentException.class)
            .hasMessage("there are more bands, 4, than rows, 3");
    }
}
