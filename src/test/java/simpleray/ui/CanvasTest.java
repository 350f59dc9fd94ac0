package simpleray.ui;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Rectangle;
import org.junit.jupiter.api.Test;
import simpleray.render.Region;

/** What a window shows of blocks of different sizes. */
class CanvasTest {
    private static final int RED = 0xFFFF0000;
    private static final int GREEN = 0xFF00FF00;
    private static final int BLUE = 0xFF0000FF;

    private final Canvas canvas = new Canvas(10, 6);
    private final Rectangle changed = new Rectangle(0, 0, -1, -1);

    @Test
    void aBlockFillsItsSquareAsFarAsThePictureGoes() {
        canvas.paint(new Canvas.Strip(0, 0, 8, 8, new int[] {RED, GREEN}), changed);

        assertThat(canvas.image().getRGB(0, 5)).isEqualTo(RED);
        assertThat(canvas.image().getRGB(7, 5)).isEqualTo(RED);
        assertThat(canvas.image().getRGB(8, 0)).isEqualTo(GREEN);
        assertThat(canvas.image().getRGB(9, 5)).isEqualTo(GREEN);
        assertThat(changed).isEqualTo(new Rectangle(0, 0, 10, 6));
    }

    @Test
    void aCoarseBlockThatComesLateDoesNotHideAFinerOne() {
        canvas.paint(new Canvas.Strip(2, 2, 2, 2, new int[] {BLUE}), changed);
        assertThat(changed).isEqualTo(new Rectangle(2, 2, 2, 2));
        canvas.paint(new Canvas.Strip(0, 0, 8, 8, new int[] {RED, GREEN}), changed);

        assertThat(canvas.image().getRGB(2, 2)).isEqualTo(BLUE);
        assertThat(canvas.image().getRGB(3, 3)).isEqualTo(BLUE);
        assertThat(canvas.image().getRGB(4, 4)).isEqualTo(RED);
    }

    @Test
    void theCornerOfABlockIsAPixelThatWasTracedAndStays() {
        canvas.paint(new Canvas.Strip(0, 2, 8, 8, new int[] {BLUE}), changed);
        canvas.paint(new Canvas.Strip(0, 0, 8, 8, new int[] {RED, GREEN}), changed);

        assertThat(canvas.image().getRGB(0, 0, 4, 1, null, 0, 4)).containsExactly(RED, RED, BLUE, RED);
    }

    @Test
    void theCornerOfACoarseBlockComesAlsoOverAFinerBlockOfAnotherPixel() {
        canvas.paint(new Canvas.Strip(0, 3, 2, 2, new int[] {BLUE}), changed);
        canvas.paint(new Canvas.Strip(0, 4, 8, 8, new int[] {RED}), changed);

        assertThat(canvas.image().getRGB(3, 0, 3, 1, null, 0, 3)).containsExactly(BLUE, RED, RED);
        assertThat(canvas.image().getRGB(3, 1, 3, 1, null, 0, 3)).containsExactly(BLUE, BLUE, RED);
    }

    @Test
    void whereItIsReopenedACoarseBlockComesOverAll() {
        canvas.paint(new Canvas.Strip(3, 0, 1, 1, new int[] {BLUE, BLUE, BLUE, BLUE}), changed);
        canvas.reopen(new Region(1, 3, 2, 1));
        canvas.paint(new Canvas.Strip(0, 0, 8, 8, new int[] {RED}), changed);

        assertThat(canvas.image().getRGB(0, 3, 4, 1, null, 0, 4)).containsExactly(BLUE, RED, RED, BLUE);
    }

    @Test
    void nothingComesOverAHatchedRow() {
        canvas.hatch(2, changed);
        int[] hatched = canvas.image().getRGB(0, 2, 10, 1, null, 0, 10);
        canvas.paint(new Canvas.Strip(2, 0, 1, 1, new int[] {RED, RED, RED}), changed);

        assertThat(canvas.image().getRGB(0, 2, 10, 1, null, 0, 10)).isEqualTo(hatched).doesNotContain(RED);
    }

    @Test
    void whatWasNotPaintedIsTransparent() {
        assertThat(canvas.image().getRGB(0, 0, 10, 6, null, 0, 10)).containsOnly(0);
    }

    @Test
    void faultsAreToldInRunsOfRows() {
        Faults faults = new Faults();
        assertThat(faults.isEmpty()).isTrue();
        assertThat(faults.text()).isEmpty();
        for (int y = 0; y < 50; y++) {
            faults.add(2 * y, new IllegalStateException("even"));
        }
        faults.add(1, new IllegalStateException("odd"));

        assertThat(faults.text().lines()).hasSize(21).startsWith("row 0 was not rendered: java.lang.IllegalStateException: even",
            "row 1 was not rendered: java.lang.IllegalStateException: odd").endsWith("and 31 more such pieces");
    }
}
