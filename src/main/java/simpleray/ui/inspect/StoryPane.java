package simpleray.ui.inspect;

import java.awt.BorderLayout;
import java.awt.Dimension;
import java.awt.Rectangle;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.function.BiConsumer;
import javax.swing.BorderFactory;
import javax.swing.Box;
import javax.swing.BoxLayout;
import javax.swing.JButton;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.JTree;
import javax.swing.tree.DefaultMutableTreeNode;
import javax.swing.tree.DefaultTreeCellRenderer;
import javax.swing.tree.DefaultTreeModel;
import javax.swing.tree.TreeNode;
import javax.swing.tree.TreePath;
import javax.swing.tree.TreeSelectionModel;
import simpleray.render.StoryText;
import simpleray.scene.RayTree;

/** The story of a pixel as a tree: each line below the one it belongs to, to be opened where one wants to know more. */
final class StoryPane extends JPanel {
    private static final long serialVersionUID = 1L;
    /** The width at first. */
    static final int WIDTH = 400;
    private static final int INDENT = 20;
    /** Lines above this level are open at first: down to the hit and the share of each light. */
    private static final int OPEN = 3;

    /** A line in the tree. */
    private static final class Node extends DefaultMutableTreeNode {
        private static final long serialVersionUID = 1L;
        private final transient StoryText.Line line;

        Node(StoryText.Line line) {
            super(line.text());
            this.line = line;
        }
    }

    private boolean showing;                                  // the selection is not the user's
    private final JLabel title = new JLabel(" ");
    private final JTree tree = new JTree(new DefaultTreeModel(new DefaultMutableTreeNode("")));

    StoryPane(Runnable copy, Runnable close, BiConsumer<RayTree, RayTree.Lamp> chosen) {
        super(new BorderLayout());
        title.setName("story title");
        tree.setName("story");
        tree.getAccessibleContext().setAccessibleName("Story of the pixel");
        tree.getSelectionModel().setSelectionMode(TreeSelectionModel.DISCONTIGUOUS_TREE_SELECTION);
        DefaultTreeCellRenderer plain = new DefaultTreeCellRenderer();
        plain.setLeafIcon(null);
        plain.setOpenIcon(null);
        plain.setClosedIcon(null);
        tree.setCellRenderer(plain);
        tree.addTreeSelectionListener(e -> {
            if (!showing && tree.getSelectionCount() == 1
                && tree.getLastSelectedPathComponent() instanceof Node node && node.line.ray() != null) {
                chosen.accept(node.line.ray(), node.line.lamp());
            }
        });
        JPanel head = new JPanel();
        head.setLayout(new BoxLayout(head, BoxLayout.X_AXIS));
        head.setBorder(BorderFactory.createEmptyBorder(4, 8, 4, 8));
        head.add(title);
        head.add(Box.createHorizontalGlue());
        head.add(button("Copy", "Copy Story (Ctrl+Shift+I)", copy));
        head.add(Box.createHorizontalStrut(6));
        head.add(button("Close", "Close Story (Shift+I)", close));
        JScrollPane scroll = new JScrollPane(tree);
        scroll.setPreferredSize(new Dimension(WIDTH, WIDTH));
        add(head, BorderLayout.NORTH);
        add(scroll, BorderLayout.CENTER);
        setMinimumSize(new Dimension(WIDTH / 3, 0));
    }

    private static JButton button(String text, String tip, Runnable task) {
        JButton button = new JButton(text);
        button.setToolTipText(tip);
        button.getAccessibleContext().setAccessibleName(tip.substring(0, tip.indexOf(" (")));
        button.addActionListener(e -> task.run());
        return button;
    }

    /** {@return a tree of lines} Any thread may call; long stories take their time. */
    static DefaultMutableTreeNode tree(List<StoryText.Line> lines) {
        List<DefaultMutableTreeNode> last = new ArrayList<>();   // on each level
        for (StoryText.Line line : lines) {
            DefaultMutableTreeNode node = new Node(line);
            if (line.level() > 0) {
                last.get(line.level() - 1).add(node);
            }
            last.subList(line.level(), last.size()).clear();
            last.add(node);
        }
        return last.get(0);
    }

    /** Shows a story, and takes the keys if it is to be read by them. */
    void show(String name, DefaultMutableTreeNode root, boolean focus) {
        title.setText(name);
        showing = true;
        tree.setModel(new DefaultTreeModel(root));
        open(root);
        tree.setSelectionRow(0);
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
            if (any instanceof Node node && node.line.ray() == ray && node.line.lamp() == lamp) {
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

    /** Opens the upper levels; of several samples none, or the pane would be full of the first one. */
    private void open(DefaultMutableTreeNode node) {
        boolean several = node.isRoot() && node.getChildCount() > 1;
        tree.expandPath(new TreePath(node.getPath()));
        for (int i = 0; !several && i < node.getChildCount() && node.getLevel() + 1 < OPEN; i++) {
            open((DefaultMutableTreeNode) node.getChildAt(i));
        }
    }
}
