package simpleray.ui.picture;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Rectangle;
import java.awt.image.BufferedImage;
import org.junit.jupiter.api.AfterEach;
import simpleray.math.Ray;
import simpleray.scene.SceneFile;
import simpleray.ui.OpenWindow;
import simpleray.ui.Screen;
import simpleray.ui.TestScenes;
import simpleray.ui.WindowTest;
import simpleray.ui.file.SceneSource;

/** A program that fails at some rows: it says so, marks them, and shows the others. */
class FailedRowsTest {
    private static final int SIDE = 100;
    private OpenWindow window;

    @AfterEach
    void close() {
        if (window != null) {
            window.close();
        }
    }

    @WindowTest
    void rowsThatCouldNotBeRenderedAreHatchedAndTold() {
        window = new OpenWindow(TestScenes.watched(TestScenes.THESIS, ray -> {
            int row = row(ray);
            if (row >= 12 && row <= 14 || row == 40) {
                throw new IllegalStateException("a fault of this object");
            }
        }), SIDE, SIDE);
        window.untilState(RenderJob.State.FAILED);

        assertThat(window.problems().getText()).isEqualTo("rows 12 to 14 were not rendered: java.lang.IllegalStateException: a fault of "
            + "this object\nrow 40 was not rendered: java.lang.IllegalStateException: a fault of this object");
        assertThat(window.status()).startsWith("Failed: 9,600 of 10,000 rays");
        assertThat(window.canDo("Save Picture As…")).isFalse();
        BufferedImage good = TestScenes.rendered(TestScenes.THESIS, SIDE, SIDE);
        window.untilShown("what is above", good, 0, 12);
        window.untilShown("what is between", good, 15, 40);
        window.untilShown("what is below", good, 41, SIDE);
        BufferedImage screen = OpenWindow.ask(() -> window.screen.capture(window.picture(), window.picture().place()));
        for (int y : new int[] {12, 13, 14, 40}) {
            assertThat(screen.getRGB(0, y, SIDE, 1, null, 0, SIDE)).as("row " + y).containsOnly(0xFFE04040, 0xFF202020);
        }
    }

    @WindowTest
    void whereNothingCanBeRenderedAllOfItIsHatched() {
        window = new OpenWindow(TestScenes.watched(TestScenes.THESIS, ray -> {
            throw new StackOverflowError();
        }), SIDE, SIDE);
        window.untilState(RenderJob.State.FAILED);

        assertThat(window.problems().getText()).isEqualTo("rows 0 to 99 were not rendered: StackOverflowError");
        Screen.until("all is hatched", () -> {
            Rectangle place = window.picture().place();
            return place.width == SIDE && onlyHatched(window.screen.capture(window.picture(), place));
        });
    }

    @WindowTest
    void aSceneThatIsTooLargeForTheMemoryIsToldAsSuch() {
        window = new OpenWindow(new SceneSource() {
            @Override
            public String name() {
                return "vast.scene";
            }

            @Override
            public SceneFile read() {
                throw new OutOfMemoryError("made up");
            }
        }, SIDE, SIDE);
        window.untilState(RenderJob.State.FAILED);

        assertThat(window.problems().getText()).isEqualTo("the scene or the picture is too large for the memory: make it "
            + "smaller, or give java more by -Xmx");
    }

    @WindowTest
    void theNextRenderingDoesNotSayItAgain() {
        boolean[] faulty = {true};
        window = new OpenWindow(TestScenes.watched(TestScenes.THESIS, ray -> {
            if (faulty[0] && row(ray) == 40) {
                throw new IllegalStateException("a fault of this object");
            }
        }), SIDE, SIDE);
        window.untilState(RenderJob.State.FAILED);
        OpenWindow.run(() -> {
            faulty[0] = false;
            window.picture().restart();
        });

        window.untilState(RenderJob.State.FINISHED);
        Screen.until("the pane is gone", () -> window.problems() == null);
        window.untilShown("the picture", TestScenes.rendered(TestScenes.THESIS, SIDE, SIDE));
    }

    private static boolean onlyHatched(BufferedImage image) {
        for (int pixel : image.getRGB(0, 0, SIDE, SIDE, null, 0, SIDE)) {
            if (pixel != 0xFFE04040 && pixel != 0xFF202020) {
                return false;
            }
        }
        return true;
    }

    /** {@return the row of the picture that a ray from the eye goes through; -1 for other rays} */
    private static int row(Ray ray) {
        boolean fromTheEye = ray.origin.x == 0 && ray.origin.y == 0 && ray.origin.z == 2;
        return fromTheEye ? (int) ((ray.direction.y / ray.direction.z + 1) / 2 * SIDE) : -1;
    }

    @WindowTest
    void rowsWithTheSameFaultShareALine() {
        FailedRows rows = new FailedRows();
        assertThat(rows.isEmpty()).isTrue();
        assertThat(rows.text()).isEmpty();
        for (int y = 0; y < 50; y++) {
            rows.add(2 * y, new IllegalStateException("even"));
        }
        rows.add(1, new IllegalStateException("odd"));

        assertThat(rows.text().lines()).hasSize(21).startsWith("row 0 was not rendered: java.lang.IllegalStateException: even",
            "row 1 was not rendered: java.lang.IllegalStateException: odd").endsWith("and 31 more such pieces");
    }
}
