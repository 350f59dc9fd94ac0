package simpleray.ui.inspect;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Component;
import java.awt.Container;
import java.awt.Point;
import java.awt.Rectangle;
import java.awt.event.ActionEvent;
import java.awt.event.MouseEvent;
import java.awt.event.MouseListener;
import java.io.IOException;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import javax.swing.JButton;
import javax.swing.JFrame;
import javax.swing.KeyStroke;
import javax.swing.SwingUtilities;
import javax.swing.tree.DefaultMutableTreeNode;
import javax.swing.tree.TreeNode;
import javax.swing.tree.TreePath;
import simpleray.rays.StoryText;
import simpleray.render.PixelStory;
import simpleray.render.RenderSettings;
import simpleray.render.Renderer;
import simpleray.render.Stage;
import simpleray.scene.Scene;
import simpleray.scene.SceneFile;
import simpleray.scene.SimpleCamera;
import simpleray.ui.OpenWindow;
import simpleray.ui.Screen;
import simpleray.ui.TestScenes;
import simpleray.ui.WindowTest;

/** A story's lines as a tree. */
class StoryPaneTest {
    private static final SimpleCamera CAMERA = new SimpleCamera(20, 20);

    @WindowTest
    void theTreeHasEveryLineBelowTheOneItBelongsTo() throws IOException {
        List<StoryText.Line> lines = mirrors();

        List<TreeNode> nodes = Collections.list(StoryTree.tree(lines).preorderEnumeration());

        assertThat(nodes.stream().map(DefaultMutableTreeNode.class::cast)
            .map(node -> node.getLevel() + " " + node.getUserObject()).collect(Collectors.toList()))
            .isEqualTo(lines.stream().map(line -> line.level() + " " + line.text()).collect(Collectors.toList()));
        assertThat(lines).hasSizeGreaterThan(100);
        assertThat(new ArrayList<>(lines)).extracting(StoryText.Line::level).contains(0, 1, 2, 3, 4, 5, 6);
    }

    @WindowTest
    void ofSeveralSamplesTheMiddleOneIsOpenWithWhatTheRayFromTheEyeHits() throws IOException {
        DefaultMutableTreeNode root = StoryTree.tree(mirrors());
        OpenWindow.run(() -> {
            StoryPane pane = new StoryPane(() -> { }, () -> { }, (ray, lamp) -> { }, line -> { });
            pane.show("Pixel 10, 10", root, false);
            StoryTree tree = tree(pane);
            List<String> open = new ArrayList<>();
            for (int i = 0; i < tree.getRowCount(); i++) {
                open.add(tree.getPathForRow(i).getLastPathComponent().toString());
            }
            assertThat(open.stream().filter(line -> line.startsWith("sample at ")).count()).isEqualTo(4);
            int middle = IntStream.range(0, open.size()).filter(i -> open.get(i).startsWith("sample at 10.25,10.75: "))
                .findFirst().orElseThrow();
            assertThat(open.get(middle + 1)).contains(" (line ");
            assertThat(open.get(middle + 2)).contains(" = mirror ");
            assertThat(open.subList(0, middle)).noneMatch(line -> line.contains(" (line "));
        });
    }

    @WindowTest
    void theOtherSamplesAreToldWhenTheyAreOpened() throws IOException {
        DefaultMutableTreeNode root = StoryTree.tree(StoryText.outline(mirror(), scene(), CAMERA));
        int begun = Collections.list(root.preorderEnumeration()).size();
        List<String> all = mirrors().stream().map(StoryText.Line::text).collect(Collectors.toList());
        assertThat(begun).isLessThan(all.size() / 2);
        OpenWindow.run(() -> {
            StoryPane pane = new StoryPane(() -> { }, () -> { }, (ray, lamp) -> { }, line -> { });
            pane.show("Pixel 10, 10", root, false);
            for (TreeNode sample : Collections.list(root.children())) {
                tree(pane).expandPath(new TreePath(new Object[] {root, sample}));
            }
            assertThat(IntStream.range(0, tree(pane).getRowCount()).filter(row -> tree(pane).getPathForRow(row).getPathCount() == 3))
                .hasSize(4);
        });

        assertThat(Collections.list(root.preorderEnumeration()).stream().map(Object::toString).collect(Collectors.toList())).isEqualTo(all);
    }

    @WindowTest
    void rowsAreWrappedAtAnyWidthAndNoButtonIsCut() throws IOException {
        DefaultMutableTreeNode root = StoryTree.tree(mirrors());
        StoryPane pane = OpenWindow.ask(() -> new StoryPane(() -> { }, () -> { }, (ray, lamp) -> { }, line -> { }));
        JFrame frame = OpenWindow.ask(() -> new JFrame());
        try {
            OpenWindow.run(() -> {
                frame.add(pane);
                frame.setSize(900, 300);
                frame.setVisible(true);
                pane.show("Pixel 10, 10", root, false);
            });
            List<Integer> heights = new ArrayList<>();
            for (int width : new int[] {700, 330, 500, 150}) {
                OpenWindow.run(() -> {
                    frame.setSize(width, 300);
                    frame.validate();
                });
                Screen.until("all rows fit into " + width, () -> {
                    StoryTree tree = tree(pane);
                    return pane.getWidth() <= width && IntStream.range(0, tree.getRowCount())
                        .allMatch(i -> tree.getRowBounds(i).getMaxX() <= tree.getParent().getWidth());
                });
                heights.add(OpenWindow.ask(() -> tree(pane).getPreferredSize().height));
                OpenWindow.run(() -> {
                    for (JButton button : buttons(pane)) {
                        Rectangle place = SwingUtilities.convertRectangle(button.getParent(), button.getBounds(), pane);
                        assertThat(place.getMaxX()).as(button.getText()).isLessThanOrEqualTo(pane.getWidth());
                        assertThat(place.width).isEqualTo(button.getPreferredSize().width);
                    }
                    assertThat(pane.getMinimumSize().width).isLessThan(250);
                });
            }
            assertThat(heights.get(1)).as("narrow rows are higher").isGreaterThan(heights.get(2));
            assertThat(heights.get(2)).isGreaterThanOrEqualTo(heights.get(0));
        } finally {
            OpenWindow.run(frame::dispose);
        }
    }

    @WindowTest
    void symbolsAndNumbersHaveTipsAndLinesAreLinks() throws IOException {
        DefaultMutableTreeNode root = StoryTree.tree(mirrors());
        List<Integer> shown = new ArrayList<>();
        OpenWindow.run(() -> {
            StoryPane pane = new StoryPane(() -> { }, () -> { }, (ray, lamp) -> { }, shown::add);
            pane.show("Pixel 10, 10", root, false);
            StoryTree tree = tree(pane);
            tree.setSize(tree.getPreferredSize());
            int row = IntStream.range(0, tree.getRowCount()).filter(i -> text(tree, i).contains(" (line ")).findFirst().orElseThrow();
            Rectangle place = tree.getRowBounds(row);
            StoryText.Part link = IntStream.range(place.x, place.x + place.width).mapToObj(x -> tree.partAt(new Point(x, place.y + 8)))
                .filter(part -> part != null && part.source() > 0).findFirst().orElseThrow();
            assertThat(link.text()).isEqualTo("line " + link.source());
            int x = IntStream.range(place.x, place.x + place.width).filter(i -> tree.partAt(new Point(i, place.y + 8)) == link)
                .findFirst().orElseThrow();
            MouseEvent click = new MouseEvent(tree, MouseEvent.MOUSE_CLICKED, 0, 0, x + 2, place.y + 8, 1, false, MouseEvent.BUTTON1);
            assertThat(tree.getToolTipText(click)).startsWith("object ").contains(" of the scene, a ");
            for (MouseListener listener : tree.getMouseListeners()) {
                listener.mouseClicked(click);
            }
            assertThat(shown).containsExactly(link.source());
            tree.setSelectionRow(row);
            tree.getActionForKeyStroke(KeyStroke.getKeyStroke("ENTER")).actionPerformed(new ActionEvent(tree, 0, ""));
            assertThat(shown).containsExactly(link.source(), link.source());
        });
    }

    private static String text(StoryTree tree, int row) {
        return tree.getPathForRow(row).getLastPathComponent().toString();
    }

    private static StoryTree tree(StoryPane pane) {
        return all(pane).stream().filter(StoryTree.class::isInstance).map(StoryTree.class::cast).findFirst().orElseThrow();
    }

    private static List<JButton> buttons(StoryPane pane) {
        return all(pane).stream().filter(part -> part instanceof JButton button && !button.getText().isEmpty()).map(JButton.class::cast)
            .collect(Collectors.toList());
    }

    private static List<Component> all(Container parent) {
        List<Component> all = new ArrayList<>();
        for (Component child : parent.getComponents()) {
            all.add(child);
            if (child instanceof Container container) {
                all.addAll(all(container));
            }
        }
        return all;
    }

    /** {@return the story of a pixel with four samples and many mirror rays} */
    private static List<StoryText.Line> mirrors() throws IOException {
        return StoryText.lines(mirror(), scene(), CAMERA);
    }

    private static PixelStory mirror() throws IOException {
        return new Renderer(scene(), CAMERA, new RenderSettings(Stage.FINAL, 3, 2, 1)).explainer().story(10, 10);
    }

    private static Scene scene() throws IOException {
        return SceneFile.read(TestScenes.MIRRORS).scene();
    }
}
