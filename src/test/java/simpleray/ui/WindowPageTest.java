package simpleray.ui;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import simpleray.Project;
import simpleray.ui.desktop.Shortcuts;
import simpleray.ui.file.SceneSource;

/** docs/window.md, beside the window itself. */
class WindowPageTest {
    private static final int LARGEST = 200_000;

    private final Path page = Project.root().resolve("docs/window.md");

    @WindowTest
    void itsTableOfKeysIsThatOfTheMenus() throws IOException {
        List<String> keys;
        try (OpenWindow window = new OpenWindow(SceneSource.NONE, 64, 64)) {
            keys = OpenWindow.ask(() -> Shortcuts.of(window.frame.getJMenuBar()).stream()
                .map(key -> key.keys() + " | " + key.place() + " > " + key.command()).collect(Collectors.toList()));
        }

        assertThat(rows("Keys")).hasSizeGreaterThan(50).containsExactlyElementsOf(keys);
    }

    @WindowTest
    void itsTableOfGesturesIsThatOfTheDialog() throws IOException {
        assertThat(rows("Mouse, and keys of single panes")).containsExactlyElementsOf(Shortcuts.GESTURES.stream()
            .map(gesture -> gesture.keys() + " | " + gesture.place() + ": " + gesture.command()).collect(Collectors.toList()));
    }

    @WindowTest
    void itsCapturesAreThereAndSmall() throws IOException {
        Matcher images = Pattern.compile("!\\[[^\\]]+\\]\\(([^)]+)\\)").matcher(Files.readString(page));
        List<String> shown = images.results().map(image -> image.group(1)).collect(Collectors.toList());

        assertThat(shown).hasSizeGreaterThanOrEqualTo(10).allSatisfy(image -> assertThat(page.resolveSibling(image)).isRegularFile());
        for (String image : Project.names(page.resolveSibling("images"), ".png")) {
            assertThat(Files.size(page.resolveSibling("images").resolve(image + ".png"))).as(image).isLessThan(LARGEST);
        }
    }

    /** {@return the first two cells of each row of the table below a heading} */
    private List<String> rows(String heading) throws IOException {
        return Files.readString(page).split("\n## " + heading + "\n", 2)[1].lines().skip(1)
            .takeWhile(line -> line.isEmpty() || line.startsWith("|")).filter(line -> line.startsWith("| "))
            .skip(1).map(line -> line.split(" \\| | \\|$")).map(cells -> cells[0].substring(2) + " | " + cells[1])
            .collect(Collectors.toList());
    }
}
