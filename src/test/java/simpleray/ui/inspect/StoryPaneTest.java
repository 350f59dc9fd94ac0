package simpleray.ui.inspect;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.stream.Collectors;
import javax.swing.tree.DefaultMutableTreeNode;
import javax.swing.tree.TreeNode;
import org.junit.jupiter.api.Test;
import simpleray.render.RenderSettings;
import simpleray.render.Renderer;
import simpleray.render.Stage;
import simpleray.render.StoryText;
import simpleray.scene.SceneFile;
import simpleray.scene.SimpleCamera;
import simpleray.ui.TestScenes;

/** A story's lines as a tree. */
class StoryPaneTest {
    @Test
    void theTreeHasEveryLineBelowTheOneItBelongsTo() throws IOException {
        List<StoryText.Line> lines = StoryText.lines(new Renderer(SceneFile.read(TestScenes.MIRRORS).scene(), new SimpleCamera(20, 20),
            new RenderSettings(Stage.FINAL, 3, 2, 1)).explainer().story(10, 10));

        List<TreeNode> nodes = Collections.list(StoryPane.tree(lines).preorderEnumeration());

        assertThat(nodes.stream().map(DefaultMutableTreeNode.class::cast)
            .map(node -> node.getLevel() + " " + node.getUserObject()).collect(Collectors.toList()))
            .isEqualTo(lines.stream().map(line -> line.level() + " " + line.text()).collect(Collectors.toList()));
        assertThat(lines).hasSizeGreaterThan(100);
        assertThat(new ArrayList<>(lines)).extracting(StoryText.Line::level).contains(0, 1, 2, 3, 4, 5, 6);
    }
}
