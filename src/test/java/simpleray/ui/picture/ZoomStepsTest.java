package simpleray.ui.picture;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Dimension;
import java.awt.Graphics2D;
import java.awt.Point;
import java.awt.Rectangle;
import java.awt.image.BufferedImage;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** The steps of the zoom, and where it puts a picture. */
class ZoomStepsTest {
    private static final Dimension PICTURE = new Dimension(60, 30);

    @Test
    void theStepsGoFromAnEighthTo32AndBack() {
        Zoom zoom = new Zoom(false, 0.125);
        StringBuilder steps = new StringBuilder(Zoom.percent(zoom.scale()));
        for (Zoom next = zoom.in(zoom.scale()); !next.equals(zoom); next = zoom.in(zoom.scale())) {
            assertThat(next.out(next.scale())).isEqualTo(zoom);
            zoom = next;
            steps.append(", ").append(Zoom.percent(zoom.scale()));
        }
        assertThat(steps).hasToString("12.5 %, 25 %, 50 %, 75 %, 100 %, 200 %, 300 %, 400 %, 600 %, 800 %, 1200 %, 1600 %, 2400 %, 3200 %");
        assertThat(new Zoom(false, 0.125).out(0.125)).isEqualTo(new Zoom(false, 0.125));
    }

    @ParameterizedTest
    @CsvSource({"1.4, 2, 1", "2, 3, 1", "1.9999, 3, 1", "0.3, 0.5, 0.25"})
    void fromAFittedPictureTheNextStepsAreTaken(double fitted, double in, double out) {
        assertThat(Zoom.FIT.in(fitted)).isEqualTo(new Zoom(false, in));
        assertThat(Zoom.FIT.out(fitted)).isEqualTo(new Zoom(false, out));
    }

    @Test
    void aFittedPictureLargerOrSmallerThanAllStepsStaysFitted() {
        assertThat(Zoom.FIT.in(40)).isEqualTo(Zoom.FIT);
        assertThat(Zoom.FIT.out(0.01)).isEqualTo(Zoom.FIT);
    }

    @Test
    void aSmallPictureIsInTheMiddleAndALargeOneBeginsAtTheCorner() {
        assertThat(Zoom.ACTUAL.place(new Dimension(100, 50), PICTURE, 1)).isEqualTo(new Zoom.Place(20, 10, 60, 30, 1));
        assertThat(new Zoom(false, 4).place(new Dimension(240, 120), PICTURE, 1)).isEqualTo(new Zoom.Place(0, 0, 240, 120, 4));
        assertThat(Zoom.FIT.place(new Dimension(120, 100), PICTURE, 1)).isEqualTo(new Zoom.Place(0, 20, 120, 60, 2));
    }

    @ParameterizedTest
    @CsvSource({"1.5, 40, 20", "2, 30, 15", "1.25, 48, 24"})
    void onAScaledDesktopAPixelOfThePictureIsStillOneOfTheScreen(double ui, int width, int height) {
        assertThat(Zoom.ACTUAL.size(PICTURE, ui)).isEqualTo(new Dimension(width, height));
        Zoom.Place place = Zoom.ACTUAL.place(new Dimension(width, height), PICTURE, ui);
        assertThat(place).isEqualTo(new Zoom.Place(0, 0, 60, 30, 1));
    }

    /** The component's corner lies at 7.5, 4.5 on the screen: between pixels, of which the next one is taken. */
    @ParameterizedTest
    @CsvSource({"1, 1", "1, 2", "1.5, 1", "1.5, 3", "2, 1", "2, 4"})
    void onAScaledDesktopEachPixelIsPaintedAsASquareOfTheScreensPixels(double ui, int scale) {
        BufferedImage picture = new BufferedImage(20, 10, BufferedImage.TYPE_INT_ARGB);
        for (int y = 0; y < 10; y++) {
            for (int x = 0; x < 20; x++) {
                picture.setRGB(x, y, 0xFF000000 | (x * 12) << 16 | (y * 25) << 8 | (x + y) % 2 * 255);
            }
        }
        BufferedImage screen = new BufferedImage(300, 200, BufferedImage.TYPE_INT_ARGB);
        Graphics2D canvas = screen.createGraphics();
        canvas.scale(ui, ui);
        canvas.translate(5, 3);
        canvas.setClip(0, 0, 150, 100);
        Dimension room = new Zoom(false, scale).size(new Dimension(20, 10), ui);
        new Zoom(false, scale).place(room, new Dimension(20, 10), ui).paint(canvas, picture, ui);

        int left = (int) Math.round(5 * ui);
        int top = (int) Math.round(3 * ui);
        for (int y = 0; y < 200; y++) {
            for (int x = 0; x < 300; x++) {
                boolean inside = x >= left && y >= top && x < left + 20 * scale && y < top + 10 * scale;
                assertThat(screen.getRGB(x, y)).as("%d, %d", x, y)
                    .isEqualTo(inside ? picture.getRGB((x - left) / scale, (y - top) / scale) : 0);
            }
        }
    }

    @Test
    void pixelsOfThePictureAreFoundByPixelsOfTheScreen() {
        Zoom.Place place = new Zoom.Place(20, 10, 120, 60, 2);

        assertThat(place.column(20)).isZero();
        assertThat(place.column(21)).isZero();
        assertThat(place.column(22)).isEqualTo(1);
        assertThat(place.column(19)).isEqualTo(-1);
        assertThat(place.row(69)).isEqualTo(29);
        assertThat(place.row(70)).isEqualTo(30);
    }

    /** The point is 50 pixels into the picture, which at twice the size is 100: the window goes to where these are under the cursor again. */
    @Test
    void thePointUnderTheCursorStays() {
        Zoom.Place before = new Zoom.Place(0, 0, 600, 300, 1);
        Zoom.Place after = new Zoom.Place(0, 0, 1200, 600, 2);

        assertThat(Zoom.kept(new Point(20, 10), before, new Point(30, 40), after, 1)).isEqualTo(new Point(80, 90));
        assertThat(Zoom.kept(new Point(20, 10), after, new Point(80, 90), before, 1)).isEqualTo(new Point(30, 40));
    }

    @Test
    void ofALargePictureOnlyWhatIsSeenOfItIsGivenToTheScreen() {
        BufferedImage large = new BufferedImage(3000, 2000, BufferedImage.TYPE_INT_ARGB);
        for (int y = 0; y < large.getHeight(); y++) {
            for (int x = 0; x < large.getWidth(); x++) {
                large.setRGB(x, y, 0xFF000000 | x / 12 << 16 | y / 8 << 8);
            }
        }
        Zoom.Place place = Zoom.FIT.place(new Dimension(340, 200), new Dimension(3000, 2000), 1);
        BufferedImage whole = place.shrunk(large, new Rectangle(place.x(), place.y(), place.width(), place.height()));
        Rectangle part = new Rectangle(60, 150, 100, 20);
        BufferedImage seen = place.shrunk(large, part);

        assertThat(new Dimension(seen.getWidth(), seen.getHeight())).isEqualTo(part.getSize());
        BufferedImage painted = new BufferedImage(340, 200, BufferedImage.TYPE_INT_RGB);
        Graphics2D g = painted.createGraphics();
        g.setClip(part);
        place.paint(g, large, 1);
        g.dispose();
        for (int y = 0; y < part.height; y++) {
            for (int x = 0; x < part.width; x++) {
                int expected = whole.getRGB(part.x - place.x() + x, part.y - place.y() + y);
                assertThat(seen.getRGB(x, y)).isEqualTo(expected);
                assertThat(painted.getRGB(part.x + x, part.y + y)).isEqualTo(expected);
            }
        }
        assertThat(painted.getRGB(part.x - 1, part.y) & 0xFFFFFF).isZero();
    }
}
