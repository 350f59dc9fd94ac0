package simpleray.film;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.image.IndexColorModel;
import java.util.Arrays;
import java.util.Random;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;

class PaletteTest {
    private static final int OPAQUE = 0xFF000000;

    @Test
    void asManyColoursAsThereIsRoomForStayAsTheyAre() {
        int[] pixels = IntStream.range(0, 256).map(i -> OPAQUE | i << 16 | 255 - i << 8 | i / 2).toArray();
        Palette palette = new Palette();
        palette.count(Arrays.copyOfRange(pixels, 0, 200));
        palette.count(Arrays.copyOfRange(pixels, 100, 256));
        IndexColorModel colours = palette.make();

        assertThat(colours.getMapSize()).isEqualTo(256);
        assertThat(farthest(pixels, palette, colours)).isZero();
    }

    @Test
    void aFilmOfOneColourHasAPaletteOfOne() {
        Palette palette = new Palette();
        palette.count(new int[] {OPAQUE | 0x102030, OPAQUE | 0x102030});

        IndexColorModel colours = palette.make();

        assertThat(colours.getMapSize()).isEqualTo(1);
        assertThat(colours.getRGB(0)).isEqualTo(OPAQUE | 0x102030);
        assertThat(palette.index(OPAQUE | 0x102030)).isZero();
    }

    /** Greys in four hues: 257 colours are one too many, and each is then near one of the palette's. */
    @Test
    void ofMoreColoursEachHasANearOne() {
        int[] pixels = IntStream.range(0, 257).map(i -> OPAQUE | (i == 256 ? 0xFF0000 : i * 0x010101)).toArray();
        Palette palette = new Palette();
        palette.count(pixels);
        IndexColorModel colours = palette.make();

        assertThat(colours.getMapSize()).isBetween(60, 256);
        assertThat(farthest(pixels, palette, colours)).isLessThanOrEqualTo(3);
        assertThat(colours.getRGB(palette.index(0xFFFF0000))).as("in a cell of its own").isEqualTo(0xFFFF0000);
        assertThat(colours.getRGB(palette.index(0xFFFFFFFF))).isEqualTo(0xFFFFFFFF);
        assertThat(colours.getRGB(palette.index(OPAQUE))).isEqualTo(OPAQUE);
    }

    @Test
    void whatCountsMostIsKeptBest() {
        Random random = new Random(5);
        int[] noise = random.ints(1000, 0, 0x1000000).map(rgb -> OPAQUE | rgb).toArray();
        int[] most = new int[100_000];
        Arrays.setAll(most, i -> 0xFF804000 + i % 4 * 0x040404);
        Palette palette = new Palette();
        palette.count(noise);
        palette.count(most);
        IndexColorModel colours = palette.make();

        assertThat(colours.getMapSize()).isEqualTo(256);
        assertThat(farthest(most, palette, colours)).isLessThanOrEqualTo(4);
        assertThat(farthest(noise, palette, colours)).isLessThanOrEqualTo(80);
    }

    @Test
    void moreThanHalfTransparentPixelsShareTheLastIndex() {
        int[] pixels = {0xFF102030, 0x80405060, 0x7F405060, 0};
        Palette palette = new Palette();
        palette.count(pixels);
        IndexColorModel colours = palette.make();

        assertThat(colours.getMapSize()).isEqualTo(3);
        assertThat(colours.getTransparentPixel()).isEqualTo(2);
        assertThat(Arrays.stream(pixels).map(pixel -> colours.getRGB(palette.index(pixel))).toArray())
            .containsExactly(0xFF102030, 0xFF405060, 0, 0);
    }

    /** With 256 opaque colours one is too many. */
    @Test
    void theTransparentIndexIsOneOfThe256() {
        int[] pixels = IntStream.range(0, 257).map(i -> i == 256 ? 0 : OPAQUE | i * 0x010101).toArray();
        Palette palette = new Palette();
        palette.count(pixels);
        IndexColorModel colours = palette.make();

        assertThat(colours.getMapSize()).isBetween(60, 256);
        assertThat(palette.index(0)).isEqualTo(colours.getMapSize() - 1).isEqualTo(colours.getTransparentPixel());
        assertThat(farthest(Arrays.copyOf(pixels, 256), palette, colours)).isLessThanOrEqualTo(3);
    }

    /** {@return the largest difference of a channel between a pixel and its colour in the palette} */
    private static int farthest(int[] pixels, Palette palette, IndexColorModel colours) {
        int most = 0;
        for (int rgb : pixels) {
            int other = colours.getRGB(palette.index(rgb));
            for (int shift = 0; shift < 24; shift += 8) {
                most = Math.max(most, Math.abs((rgb >> shift & 255) - (other >> shift & 255)));
            }
        }
        return most;
    }
}
