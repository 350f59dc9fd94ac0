package simpleray.image;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.awt.image.BufferedImage;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class PictureTest {
    @ParameterizedTest
    @CsvSource({"0, 0", "1, 255", "0.5, 128", "0.25, 64", "0.3, 77", "-0.0, 0", "-0.1, 0", "-1e300, 0", "1.001, 255", "1e300, 255",
        "1.9, 255", "2, 255", "9e6, 255", "-9e6, 0", "-0.0019, 0", "-0.0021, 0", "Infinity, 255", "-Infinity, 0", "NaN, 0"})
    void aLevelIsTheClampedLightTimes255Rounded(double light, int level) {
        // 0.5 · 255 + 0.5 = 128.0; 0.25 · 255 + 0.5 = 64.25; 0.3 · 255 + 0.5 = 77.0
        assertThat(Picture.level(light)).isEqualTo(level);
    }

    @Test
    void levelsChangeHalfWayBetweenTwo() {
        for (int level = 1; level <= 255; level++) {
            double half = (level - 0.5) / 255;
            assertThat(Picture.level(half + 1e-12)).isEqualTo(level);
            assertThat(Picture.level(half - 1e-12)).isEqualTo(level - 1);
        }
    }

    @Test
    void everyLevelComesBackFromItsOwnLight() {
        for (int level = 0; level <= 255; level++) {
            assertThat(Picture.level(level / 255.0)).isEqualTo(level);
        }
    }

    @Test
    void aRowIsKeptAndItsLevelsAreMadeAnew() {
        Picture picture = new Picture(2, 3);
        double[] row = {0, 0.5, 1, -1, 2, Double.NaN};

        picture.setRow(1, row);

        assertThat(picture.row(1)).isSameAs(row);
        assertThat(picture.levels(1)).containsExactly(0, 128, 255, 0, 255, 0);
        assertThat(picture.levels(1)).isNotSameAs(picture.levels(1));
    }

    @Test
    void anImageOfAwtHasTheLevels() {
        Picture picture = new Picture(2, 2);
        picture.setRow(0, new double[] {0, 0.5, 1, -1, 2, Double.NaN});
        assertThatThrownBy(picture::toBufferedImage).isInstanceOf(IllegalStateException.class);
        picture.setRow(1, new double[] {1, 1, 1, 0, 0, 1});

        BufferedImage image = picture.toBufferedImage();

        assertThat(image.getRGB(0, 0, 2, 2, null, 0, 2)).containsExactly(0xFF0080FF, 0xFF00FF00, 0xFFFFFFFF, 0xFF0000FF);
        assertThat(image.getWidth()).isEqualTo(2);
        assertThat(image.getHeight()).isEqualTo(2);
    }

    @Test
    void aRowThatIsLetGoOfIsNotThereAnyMore() {
        Picture picture = Pictures.plain(2, 3, 0.5);

        picture.release(1);

        assertThat(picture.row(1)).isNull();
        assertThat(picture.row(0)).isNotNull();
        assertThat(picture.row(2)).isNotNull();
        assertThatThrownBy(() -> picture.levels(1)).isInstanceOf(IllegalStateException.class)
            .hasMessage("row 1 of the picture is not there");
    }

    @Test
    void aRowThatIsNotSetIsNotThere() {
        Picture picture = new Picture(2, 3);

        assertThat(picture.row(2)).isNull();
        assertThatThrownBy(() -> picture.levels(2)).isInstanceOf(IllegalStateException.class)
            .hasMessage("row 2 of the picture is not there");
    }

    @Test
    void aRowHasThreeNumbersForEachPixel() {
        Picture picture = new Picture(2, 3);

        assertThatThrownBy(() -> picture.setRow(0, new double[5])).isInstanceOf(IllegalArgumentException.class)
            .hasMessage("a row of 2 pixels has 6 numbers, not 5");
        assertThatThrownBy(() -> picture.setRow(0, new double[7])).isInstanceOf(IllegalArgumentException.class)
            .hasMessage("a row of 2 pixels has 6 numbers, not 7");
    }

    @Test
    void thereIsNoRowAboveOrBelowThePicture() {
        Picture picture = new Picture(2, 3);

        assertThatThrownBy(() -> picture.setRow(3, new double[6])).isInstanceOf(IndexOutOfBoundsException.class);
        assertThatThrownBy(() -> picture.row(-1)).isInstanceOf(IndexOutOfBoundsException.class);
    }

    @ParameterizedTest
    @CsvSource({"0, 1", "1, 0", "-1, 1", "1, -1", "65536, 1", "1, 65536"})
    void aSideHasFromOneTo65535Pixels(int width, int height) {
        assertThatThrownBy(() -> new Picture(width, height)).isInstanceOf(IllegalArgumentException.class)
            .hasMessage("a side of a picture has 1 to 65535 pixels, not " + width + 'x' + height);
    }

    @Test
    void theLargestPictureTakesNoMemoryBeforeItsRowsAreSet() {
        Picture picture = new Picture(Picture.LONGEST_SIDE, Picture.LONGEST_SIDE);

        assertThat(picture.width()).isEqualTo(65535);
        assertThat(picture.height()).isEqualTo(65535);
    }

    @Test
    void memoryIsThreeDoublesAPixelAndALittleARow() {
        // 300 · (200 · 24 + 24)
        assertThat(Picture.bytesNeeded(200, 300, Picture.RGB)).isEqualTo(1_447_200);
        // 65535 · (65535 · 24 + 24): more than an int holds
        assertThat(Picture.bytesNeeded(65535, 65535, Picture.RGB)).isEqualTo(103_077_642_240L);
    }
}
