package simpleray.ui;

import java.nio.file.Path;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import simpleray.text.Diagnostic;
import simpleray.ui.file.SceneSource;
import simpleray.ui.picture.RenderJob;
import simpleray.ui.picture.SceneReport;

/** The picture's share of the window, whatever is open beside it and below. */
class PictureShareTest {
    private static final double MIN_SHARE = 0.4;
    private static final List<String> NAMES = List.of("scene-text", "rays", "histogram", "story");
    private static final Map<String, String> ITEMS = Map.of("scene-text", "Scene Text", "rays", "Rays", "histogram", "Histogram",
        "story", "Story of the Pixel");

    @TempDir
    private Path folder;

    private OpenWindow window;

    @AfterEach
    void close() {
        window.close();
    }

    @ParameterizedTest
    @CsvSource({"1024, 768, false", "1366, 768, false", "1400, 1000, false", "1024, 768, true", "1366, 768, true", "1400, 1000, true"})
    void noCombinationOfPanesLeavesItLessThanTwoFifths(int width, int height, boolean film) {
        Path scene = TestScenes.write(folder.resolve("ball.scene"),
            "1\n0  -1 0 -2 1  1 1 1  1 1 1  0 0 0  0\n0.3 0.3 0.3\n1\n0 1 1 1  0 0 9\n"
            + (film ? "frames 3 25\nkey 0 object 1 0 0 0\nkey 2 object 1 2 0 0\n" : ""));
        window = new OpenWindow(SceneSource.file(scene), 90, 60, made -> made.frame().setSize(width, height));
        window.untilState(RenderJob.State.FINISHED);
        for (int problems : new int[] {1, 60}) {
            for (int i = 1; i <= 1 << NAMES.size(); i++) {
                String name = NAMES.get(Math.min(Integer.numberOfTrailingZeros(i), NAMES.size() - 1));   // a Gray code: one pane at a time
                toggle(name);
                SceneReport report = SceneReport.of(Collections.nCopies(problems, new Diagnostic("a.scene", 1, 1, true, "wrong", null)));
                OpenWindow.run(() -> window.viewer().showFaults(report));
                keepsItsShare(open() + ", " + problems + " problems");
                OpenWindow.run(() -> window.viewer().showFaults(null));
            }
        }
        OpenWindow.run(() -> window.frame.setSize(900, 600));
        keepsItsShare("a smaller window");
    }

    private void keepsItsShare(String when) {
        Screen.until("the picture has its share with " + when, () ->
            share(window.scroll().getWidth(), window.frame.getContentPane().getWidth())
            && share(window.scroll().getHeight(), window.frame.getContentPane().getHeight()));
    }

    private static boolean share(int part, int whole) {
        return part >= MIN_SHARE * whole;
    }

    private void toggle(String name) {
        boolean was = isOpen(name);
        String item = was && "story".equals(name) ? "Close Story" : ITEMS.get(name);
        OpenWindow.run(window.item(item)::doClick);
        if (was && isOpen(name)) {                            // it was behind another one, and came to the front first
            OpenWindow.run(window.item(item)::doClick);
        }
        Screen.until(name + (was ? " is gone" : " is there"), () -> isOpen(name) != was);
    }

    private List<String> open() {
        return NAMES.stream().filter(this::isOpen).toList();
    }

    private boolean isOpen(String name) {
        return OpenWindow.ask(() -> OpenWindow.all(window.frame.getContentPane()).anyMatch(c -> name.equals(c.getName())));
    }
}
