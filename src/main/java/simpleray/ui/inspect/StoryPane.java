package simpleray.ui.inspect;

import java.awt.BorderLayout;
import java.awt.Dimension;
import java.awt.FlowLayout;
import java.awt.Rectangle;
import java.util.Collections;
import java.util.List;
import java.util.function.BiConsumer;
import java.util.function.IntConsumer;
import java.util.stream.Collectors;
import javax.swing.BorderFactory;
import javax.swing.JButton;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.tree.DefaultMutableTreeNode;
import javax.swing.tree.DefaultTreeModel;
import javax.swing.tree.TreeNode;
import javax.swing.tree.TreePath;
import javax.swing.tree.TreeSelectionModel;
import simpleray.scene.RayTree;

/** The story of a pixel as a tree: each line below the one it belongs to, to be opened where one wants to know more. */
final class StoryPane extends JPanel {
    private static final long serialVersionUID = 1L;
    /** The width at first. */
    static final int WIDTH = 400;
    private static final int INDENT = 20;
    private static final int GAP = 6;
    /** More lights than these are not opened at first. */
    private static final int MAX_OPEN = 3;

    private boolean showing;                                  // the selection is not the user's
    private final JLabel title = new JLabel(" ");
    private final StoryTree tree;

    /** Creates a pane, which hands on the ray and the light of a line that is chosen, and the line of the scene's text to be shown. */
    StoryPane(Runnable copy, Runnable close, BiConsumer<RayTree, RayTree.Lamp> chosen, IntConsumer goTo) {
        super(new BorderLayout());
        tree = new StoryTree(goTo);
        title.setName("story title");
        tree.getSelectionModel().setSelectionMode(TreeSelectionModel.DISCONTIGUOUS_TREE_SELECTION);
        tree.addTreeSelectionListener(e -> {
            if (!showing && tree.getSelectionCount() == 1 && tree.getLastSelectedPathComponent() instanceof StoryTree.Node node) {
                chosen.accept(node.line.ray(), node.line.lamp());
            }
        });
        JPanel buttons = new JPanel(new FlowLayout(FlowLayout.TRAILING, GAP, 0));
        buttons.add(button("Copy", "Copy Story (Ctrl+Shift+I)", copy));
        buttons.add(button("Close", "Close Story (Shift+I)", close));
        JPanel head = new JPanel(new BorderLayout());         // a title too long is cut, the buttons never are
        head.setBorder(BorderFactory.createEmptyBorder(4, 8, 4, 2));
        head.add(title, BorderLayout.CENTER);
        head.add(buttons, BorderLayout.EAST);
        JScrollPane scroll = new JScrollPane(tree);
        scroll.setPreferredSize(new Dimension(WIDTH, WIDTH));
        add(head, BorderLayout.NORTH);
        add(scroll, BorderLayout.CENTER);
        title.setMinimumSize(new Dimension(0, 0));
        title.setPreferredSize(new Dimension(0, buttons.getPreferredSize().height));
        setMinimumSize(head.getPreferredSize());
    }

    private static JButton button(String text, String tip, Runnable task) {
        JButton button = new JButton(text);
        button.setToolTipText(tip);
        button.getAccessibleContext().setAccessibleName(tip.substring(0, tip.indexOf(" (")));
        button.addActionListener(e -> task.run());
        return button;
    }

    /** Shows a story, and takes the keys if it is to be read by them. */
    void show(String name, DefaultMutableTreeNode root, boolean focus) {
        title.setText(name);
        showing = true;
        tree.setModel(new DefaultTreeModel(root));
        tree.setSelectionRow(0);
        open(root);
        showing = false;
        if (focus) {
            tree.requestFocusInWindow();
        }
    }

    /** Selects the first line about a ray, or about a light at its hit. */
    @SuppressWarnings("ReferenceEquality")                    // the very ray, not one like it
    void select(RayTree ray, RayTree.Lamp lamp) {
        DefaultMutableTreeNode root = (DefaultMutableTreeNode) tree.getModel().getRoot();
        for (TreeNode any : Collections.list(root.preorderEnumeration())) {
            if (any instanceof StoryTree.Node node && node.line.ray() == ray && node.line.lamp() == lamp) {
                TreePath path = new TreePath(node.getPath());
                showing = true;
                tree.setSelectionPath(path);
                showing = false;
                Rectangle place = tree.getPathBounds(path);
                tree.scrollRectToVisible(new Rectangle(Math.max(0, place.x - INDENT), place.y, INDENT + WIDTH / 2, place.height));
                return;
            }
        }
    }

    /** Opens the story of the ray from the eye; of several samples that of the middle one, whose rays are drawn. */
    private void open(TreeNode root) {
        List<TreeNode> samples = parents(root);
        TreePath path = new TreePath(root);
        tree.expandPath(path);
        if (samples.size() > 1) {
            TreeNode middle = samples.get(samples.size() / 2);
            path = path.pathByAddingChild(middle);
            samples = parents(middle);
        }
        if (!samples.isEmpty()) {
            path = path.pathByAddingChild(samples.get(0));
            tree.expandPath(path);
            openLights(path);
        }
        Rectangle top = tree.getPathBounds(path.getPathCount() > 2 ? path.getParentPath() : path);
        if (top != null && path.getPathCount() > 2) {
            tree.scrollRectToVisible(new Rectangle(0, top.y, 1, tree.getVisibleRect().height));
        }
    }

    /** Opens the lights that reach the point, if they are few: their terms are what the sum is made of. */
    private void openLights(TreePath ray) {
        List<TreeNode> lit = parents((TreeNode) ray.getLastPathComponent()).stream()
            .filter(child -> ((StoryTree.Node) child).line.lamp() != null && ((StoryTree.Node) child).line.lamp().verdict().isLit())
            .collect(Collectors.toList());
        if (lit.size() <= MAX_OPEN) {
            lit.forEach(child -> tree.expandPath(ray.pathByAddingChild(child)));
        }
    }

    private static List<TreeNode> parents(TreeNode node) {
        return Collections.list(node.children()).stream().filter(child -> !child.isLeaf()).collect(Collectors.toList());
    }
}
