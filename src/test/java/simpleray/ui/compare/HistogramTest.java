package simpleray.ui.compare;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.image.BufferedImage;
import java.time.LocalTime;
import java.util.stream.IntStream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import simpleray.image.Picture;
import simpleray.ui.OpenWindow;
import simpleray.ui.WindowTest;
import simpleray.ui.file.SceneSource;

/** How light is counted, and which of it a screen cannot show. */
class HistogramTest {
    private static final double ABOVE = Math.nextUp(1.0);
    private static final double BELOW = -Double.MIN_VALUE;

    @WindowTest
    void lightIsCountedInTheBinItIsIn() {
        Histogram histogram = new Histogram();
        histogram.add(0, 0.5, 1);
        histogram.add(1.0 / 256, Math.nextDown(0.5), ABOVE);
        histogram.add(BELOW, 0.5, 7);

        assertThat(histogram.count(0, 0)).isEqualTo(1);
        assertThat(histogram.count(0, 1)).isEqualTo(1);
        assertThat(histogram.below(0)).isEqualTo(1);
        assertThat(histogram.count(1, 128)).isEqualTo(2);
        assertThat(histogram.count(1, 127)).isEqualTo(1);
        assertThat(histogram.count(2, 255)).isEqualTo(1);
        assertThat(histogram.above(2)).isEqualTo(2);
        assertThat(histogram.highest()).isEqualTo(2);
        assertThat(histogram.pixels()).isEqualTo(3);
        assertThat(histogram.clippedAbove()).isEqualTo(2);
        assertThat(histogram.clippedBelow()).isEqualTo(1);
    }

    @WindowTest
    void itTellsTheRangeTheMeanAndWhatIsClipped() {
        Histogram histogram = new Histogram();
        histogram.add(-0.5, 0.25, 0);
        histogram.add(2, 0.75, 0.5);

        assertThat(HistogramPane.text(histogram, 0)).isEqualTo("Red: -0.500 to 2.000, mean 0.750; 1 below 0, 1 above 1");
        assertThat(HistogramPane.text(histogram, 1)).isEqualTo("Green: 0.250 to 0.750, mean 0.500; 0 below 0, 0 above 1");
    }

    @ParameterizedTest
    @CsvSource({"0, 0, 0, 0", "1, 1, 1, 0", "1.0000000000000002, 0, 0, ffff00ff", "0, 0, 3, ffff00ff", "0, -1e-300, 0, ff00ffff",
        "-0.0, 0, 0, 0", "2, -1, 0, ffff00ff", "NaN, 0, 0, ff00ffff"})
    void aPixelIsMarkedIfAChannelIsAbove1OrBelow0(double red, double green, double blue, String mark) {
        assertThat(Integer.toHexString(Clipped.mark(Clipped.flags(red, green, blue)))).isEqualTo(mark);
    }

    @WindowTest
    void aFinishedPictureHasItsLevelsItsMarksAndItsCounts() {
        Picture picture = new Picture(2, 2);
        picture.setRow(0, new double[] {0, 0.5, 1, 1.5, 0, 0});
        picture.setRow(1, new double[] {0.2, 0.2, 0.2, 0, 0, -1});
        FinishedRender finished = new FinishedRender(picture, SceneSource.NONE, OpenWindow.request(2, 2), 1.5, LocalTime.of(9, 5, 7));

        BufferedImage plain = Clipped.image(finished.pixels(), 2, 2);
        assertThat(levels(plain)).containsExactly(0x0080FF, 0xFF0000, 0x333333, 0x000000);
        BufferedImage marks = finished.marks();
        assertThat(marks.getRGB(0, 0, 2, 2, null, 0, 2)).containsExactly(0, Clipped.ABOVE_COLOUR, 0, Clipped.BELOW_COLOUR);
        assertThat(finished.histogram().pixels()).isEqualTo(4);
        assertThat(finished.histogram().above(0)).isEqualTo(1);
        assertThat(finished).hasToString("final, , 2 \u00D7 2, 1.5 s, at 09:05:07");
        assertThat(finished.options()).isEqualTo(" --size 2x2");
    }

    /** On the chequered ground of 153, the half transparent red is (0.5 · 255 + 0.5 · 153, 0.5 · 153, …); alpha has 128 levels. */
    @WindowTest
    void aTransparentPictureIsPutOnAChequeredGroundAndCountedWhereItIsNot() {
        Picture picture = new Picture(2, 2, Picture.RGBA);
        picture.setRow(0, new double[] {1, 0, 0, 0.5, 0, 0, 0, 0});
        picture.setRow(1, new double[] {0.2, 0.2, 0.2, 1, 0, 0, 0, 0});
        FinishedRender finished = new FinishedRender(picture, SceneSource.NONE, OpenWindow.request(2, 2), 1, LocalTime.of(9, 5, 7));

        assertThat(levels(Clipped.image(finished.pixels(), 2, 2))).containsExactly(0xCC4C4C, 0x999999, 0x333333, 0x999999);
        assertThat(finished.histogram().pixels()).isEqualTo(2);
    }

    private static int[] levels(BufferedImage image) {
        return IntStream.of(image.getRGB(0, 0, 2, 2, null, 0, 2)).map(rgb -> rgb & 0xFFFFFF).toArray();
    }
}
