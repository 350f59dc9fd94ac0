package simpleray.ui.picture;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Rectangle;
import org.junit.jupiter.api.Test;
import simpleray.render.PixelRun;
import simpleray.render.Region;

/** What a window shows of blocks of different sizes. */
class ProgressiveImageTest {
    private static final int RED = 0xFFFF0000;
    private static final int GREEN = 0xFF00FF00;
    private static final int BLUE = 0xFF0000FF;

    private final ProgressiveImage shown = new ProgressiveImage(10, 6, false);
    private final Rectangle changed = new Rectangle(0, 0, -1, -1);

    private void paint(int y, int x, int step, int size, int... rgb) {
        shown.paint(new PixelRun(y, x, x + step * (rgb.length - 1) + 1, step, size, false), rgb, changed);
    }

    @Test
    void aBlockFillsItsSquareAsFarAsThePictureGoes() {
        paint(0, 0, 8, 8, RED, GREEN);

        assertThat(shown.image().getRGB(0, 5)).isEqualTo(RED);
        assertThat(shown.image().getRGB(7, 5)).isEqualTo(RED);
        assertThat(shown.image().getRGB(8, 0)).isEqualTo(GREEN);
        assertThat(shown.image().getRGB(9, 5)).isEqualTo(GREEN);
        assertThat(changed).isEqualTo(new Rectangle(0, 0, 10, 6));
    }

    @Test
    void aCoarseBlockThatComesLateDoesNotHideAFinerOne() {
        paint(2, 2, 2, 2, BLUE);
        assertThat(changed).isEqualTo(new Rectangle(2, 2, 2, 2));
        paint(0, 0, 8, 8, RED, GREEN);

        assertThat(shown.image().getRGB(2, 2)).isEqualTo(BLUE);
        assertThat(shown.image().getRGB(3, 3)).isEqualTo(BLUE);
        assertThat(shown.image().getRGB(4, 4)).isEqualTo(RED);
    }

    @Test
    void theCornerOfABlockIsAPixelThatWasTracedAndStays() {
        paint(0, 2, 8, 8, BLUE);
        paint(0, 0, 8, 8, RED, GREEN);

        assertThat(shown.image().getRGB(0, 0, 4, 1, null, 0, 4)).containsExactly(RED, RED, BLUE, RED);
    }

    @Test
    void theCornerOfACoarseBlockComesAlsoOverAFinerBlockOfAnotherPixel() {
        paint(0, 3, 2, 2, BLUE);
        paint(0, 4, 8, 8, RED);

        assertThat(shown.image().getRGB(3, 0, 3, 1, null, 0, 3)).containsExactly(BLUE, RED, RED);
        assertThat(shown.image().getRGB(3, 1, 3, 1, null, 0, 3)).containsExactly(BLUE, BLUE, RED);
    }

    @Test
    void whereItIsReopenedACoarseBlockComesOverAll() {
        paint(3, 0, 1, 1, BLUE, BLUE, BLUE, BLUE);
        shown.reopen(new Region(1, 3, 2, 1));
        paint(0, 0, 8, 8, RED);

        assertThat(shown.image().getRGB(0, 3, 4, 1, null, 0, 4)).containsExactly(BLUE, RED, RED, BLUE);
    }

    @Test
    void nothingComesOverAHatchedRow() {
        shown.hatch(2, changed);
        int[] hatched = shown.image().getRGB(0, 2, 10, 1, null, 0, 10);
        paint(2, 0, 1, 1, RED, RED, RED);

        assertThat(shown.image().getRGB(0, 2, 10, 1, null, 0, 10)).isEqualTo(hatched).doesNotContain(RED);
    }

    @Test
    void whatWasNotPaintedIsTransparent() {
        assertThat(shown.image().getRGB(0, 0, 10, 6, null, 0, 10)).containsOnly(0);
    }
}
