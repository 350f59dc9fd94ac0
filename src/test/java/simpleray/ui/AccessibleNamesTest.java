package simpleray.ui;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Component;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Collectors;
import javax.accessibility.AccessibleRole;
import javax.swing.AbstractButton;
import javax.swing.JProgressBar;
import javax.swing.text.JTextComponent;
import org.junit.jupiter.api.io.TempDir;
import simpleray.ui.file.SceneSource;
import simpleray.ui.picture.RenderJob;
import simpleray.ui.picture.SimpleRay;

/** What a screen reader is told. */
class AccessibleNamesTest {
    @WindowTest
    void everythingThatCanBeUsedHasAName(@TempDir Path folder) {
        Path bad = TestScenes.write(folder.resolve("bad.scene"), "oops");
        try (OpenWindow window = new OpenWindow(SceneSource.file(bad), 64, 64)) {
            window.untilState(RenderJob.State.FAILED);
            List<Component> used = OpenWindow.ask(() -> OpenWindow.all(window.frame).filter(AccessibleNamesTest::isUsed)
                .collect(Collectors.toList()));

            assertThat(used).hasSizeGreaterThanOrEqualTo(7).allSatisfy(c ->
                assertThat(c.getAccessibleContext().getAccessibleName()).as(c.toString()).isNotBlank());
        }
    }

    @WindowTest
    void thePictureIsACanvasByTheNameOfPicture() {
        try (OpenWindow window = new OpenWindow(SceneSource.NONE, 64, 64)) {
            assertThat(window.picture().getAccessibleContext().getAccessibleName()).isEqualTo("Picture");
            assertThat(window.picture().getAccessibleContext().getAccessibleRole())
                .isEqualTo(AccessibleRole.CANVAS);
        }
    }

    /** Menus and their items, the picture, the problems, the progress; not what is part of another component, such as scroll bars. */
    private static boolean isUsed(Component c) {
        return c instanceof AbstractButton && c.isFocusable() || c instanceof SimpleRay || c instanceof JTextComponent
            || c instanceof JProgressBar;
    }
}
