package simpleray.ui.inspect;

import java.awt.Color;
import java.awt.Component;
import java.awt.Cursor;
import java.awt.Dimension;
import java.awt.FontMetrics;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.Point;
import java.awt.Rectangle;
import java.awt.RenderingHints;
import java.awt.Toolkit;
import java.awt.event.ComponentAdapter;
import java.awt.event.ComponentEvent;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.function.IntConsumer;
import javax.swing.JTree;
import javax.swing.JViewport;
import javax.swing.SwingUtilities;
import javax.swing.ToolTipManager;
import javax.swing.UIManager;
import javax.swing.event.TreeExpansionEvent;
import javax.swing.event.TreeWillExpandListener;
import javax.swing.plaf.basic.BasicTreeUI;
import javax.swing.tree.DefaultMutableTreeNode;
import javax.swing.tree.DefaultTreeCellRenderer;
import javax.swing.tree.DefaultTreeModel;
import javax.swing.tree.TreePath;
import simpleray.image.Picture;
import simpleray.math.Colour;
import simpleray.rays.StoryText.Line;
import simpleray.rays.StoryText.Part;
import simpleray.ui.widget.KeyBindings;

/** A story as a tree, whose lines are wrapped at the width that is seen, with swatches, tips and links. For the event thread. */
final class StoryTree extends JTree {
    private static final long serialVersionUID = 1L;
    /** A line at a deep level is not wrapped at less than this width; one scrolls to its end. */
    private static final int MIN_WIDTH = 60;
    private static final int MARGIN = 2;
    private static final int CHILD_INDENT = 7;                // on both sides of the handle
    private static final int UNSEEN = 400;                    // the width while it is not on the screen

    /** A line in the tree. */
    static final class Node extends DefaultMutableTreeNode {
        private static final long serialVersionUID = 1L;
        final transient Line line;

        Node(Line line) {
            super(line.text());
            this.line = line;
        }

        @Override
        public boolean isLeaf() {
            return line.more() == null && super.isLeaf();
        }
    }

    private final transient IntConsumer goTo;
    private int wrappedAt;                                    // the width for which the heights of the rows are known

    /** Creates an empty tree, which has a line of the scene's text shown when its name is clicked. */
    StoryTree(IntConsumer goTo) {
        super(new DefaultTreeModel(new DefaultMutableTreeNode("")));
        this.goTo = goTo;
        setName("story");
        getAccessibleContext().setAccessibleName("Story of the pixel");
        setCellRenderer(new Cell());
        setRowHeight(0);                                      // each row has its own
        ToolTipManager.sharedInstance().registerComponent(this);
        KeyBindings.bind(this, WHEN_FOCUSED, "ENTER", this::goToSelected);
        MouseAdapter mouse = new MouseAdapter() {
            @Override
            public void mouseMoved(MouseEvent e) {
                Part part = partAt(e.getPoint());
                setCursor(part != null && part.source() > 0 ? Cursor.getPredefinedCursor(Cursor.HAND_CURSOR) : null);
            }

            @Override
            public void mouseClicked(MouseEvent e) {
                Part part = partAt(e.getPoint());
                if (part != null && part.source() > 0 && SwingUtilities.isLeftMouseButton(e)) {
                    goTo.accept(part.source());
                }
            }
        };
        addMouseListener(mouse);
        addMouseMotionListener(mouse);
        addTreeWillExpandListener(new TreeWillExpandListener() {
            @Override
            public void treeWillExpand(TreeExpansionEvent e) {
                growAt(e.getPath());
            }

            @Override
            public void treeWillCollapse(TreeExpansionEvent e) {
                // its lines stay
            }
        });
    }

    /** {@return a tree of lines} Any thread may call; long stories take their time. */
    static DefaultMutableTreeNode tree(List<Line> lines) {
        List<DefaultMutableTreeNode> last = new ArrayList<>();
        add(lines, last);
        return last.get(0);
    }

    /** Adds lines to a tree, of which the last node on each level is given. */
    private static void add(List<Line> lines, List<DefaultMutableTreeNode> last) {
        for (Line line : lines) {
            DefaultMutableTreeNode node = new Node(line);
            if (line.level() > 0) {
                last.get(line.level() - 1).add(node);
            }
            last.subList(line.level(), last.size()).clear();
            last.add(node);
        }
    }

    private void growAt(TreePath path) {
        if (path.getLastPathComponent() instanceof Node node && node.getChildCount() == 0 && node.line.more() != null) {
            List<DefaultMutableTreeNode> above = new ArrayList<>();
            for (Object part : path.getPath()) {
                above.add((DefaultMutableTreeNode) part);
            }
            add(node.line.more().get(), above);
            ((DefaultTreeModel) getModel()).nodeStructureChanged(node);
        }
    }

    @Override
    public void updateUI() {
        super.updateUI();
        if (getCellRenderer() instanceof Cell) {
            setCellRenderer(new Cell());                      // in the colours and the font of the look
        }
        if (getUI() instanceof BasicTreeUI ui) {
            ui.setLeftChildIndent(CHILD_INDENT);
            ui.setRightChildIndent(CHILD_INDENT);
        }
    }

    @Override
    public void addNotify() {
        super.addNotify();
        getParent().addComponentListener(new ComponentAdapter() {
            @Override
            public void componentResized(ComponentEvent e) {
                wrap();
            }
        });
    }

    /** Has the heights of the rows computed anew if the width has changed. */
    private void wrap() {
        if (getParent() != null && getParent().getWidth() != wrappedAt) {
            wrappedAt = getParent().getWidth();
            setRowHeight(getRowHeight() == 0 ? -1 : 0);       // both mean the same; the change alone makes the tree ask again
        }
    }

    @Override
    public boolean getScrollableTracksViewportWidth() {
        return getParent() instanceof JViewport seen && getPreferredSize().width <= seen.getWidth();
    }

    private void goToSelected() {
        if (getLastSelectedPathComponent() instanceof Node node) {
            node.line.parts().stream().filter(part -> part.source() > 0).findFirst().ifPresent(part -> goTo.accept(part.source()));
        }
    }

    @Override
    public String getToolTipText(MouseEvent e) {
        Part part = partAt(e.getPoint());
        return part == null ? null : part.tip();
    }

    /** {@return the part of a line at a place; null if there is none} */
    Part partAt(Point place) {
        TreePath path = getPathForLocation(place.x, place.y);
        if (path == null || !(path.getLastPathComponent() instanceof Node node)) {
            return null;
        }
        Rectangle row = getPathBounds(path);
        return flow(node).words.stream().filter(word -> word.place.contains(place.x - row.x, place.y - row.y)).map(word -> word.part)
            .findFirst().orElse(null);
    }

    /** {@return where a line's words go} */
    private Flow flow(Node node) {
        int indent = 2 * CHILD_INDENT * (node.getLevel() + (getShowsRootHandles() ? 1 : 0));
        int width = (getParent() == null || getParent().getWidth() == 0 ? UNSEEN : getParent().getWidth()) - indent - 4 * MARGIN;
        return new Flow(node.line.parts(), getFontMetrics(getFont()), Math.max(MIN_WIDTH, width));
    }

    /** A word of a part, and its place in the row. */
    private record Word(Part part, String text, boolean swatch, Rectangle place) {
    }

    /** The words of a line, broken where they no longer fit. */
    private static final class Flow {
        final List<Word> words = new ArrayList<>();
        private final FontMetrics metrics;
        private final int width;
        private final List<Word> run = new ArrayList<>();     // words between which no break is
        private int x = MARGIN;
        private int y = MARGIN;
        private int right;

        Flow(List<Part> parts, FontMetrics metrics, int width) {
            this.metrics = metrics;
            this.width = width;
            for (Part part : parts) {
                boolean whole = part.meaning() != null || part.source() > 0;
                int from = 0;
                for (int space = part.text().indexOf(' '); !whole && space >= 0; space = part.text().indexOf(' ', from)) {
                    add(part, part.text().substring(from, space + 1), false);
                    from = space + 1;
                    place();
                }
                add(part, part.text().substring(from), part.swatch() != null);
            }
            place();
        }

        private void add(Part part, String text, boolean swatch) {
            if (!text.isEmpty()) {
                run.add(new Word(part, text, swatch, new Rectangle(0, 0, width(text, swatch), metrics.getHeight())));
            }
        }

        private void place() {
            if (width(run) <= width) {
                placeTogether();
                return;
            }
            List<Word> all = List.copyOf(run);
            run.clear();
            for (Word word : all) {                           // together longer than a line: broken at blanks, or where they must
                boolean swatch = word.swatch;
                for (String piece : word.text.split("(?<= )", -1)) {
                    for (String rest = piece; !rest.isEmpty();) {
                        int end = rest.length();
                        while (end > 1 && width(rest.substring(0, end), swatch) > width) {
                            end--;
                        }
                        add(word.part, rest.substring(0, end), swatch);
                        placeTogether();
                        swatch = false;
                        rest = rest.substring(end);
                    }
                }
            }
        }

        private void placeTogether() {
            if (x > MARGIN && x + width(run) > MARGIN + width) {
                x = MARGIN;
                y += metrics.getHeight();
            }
            for (Word word : run) {
                word.place.setLocation(x, y);
                x += word.place.width;
                right = Math.max(right, x);
            }
            words.addAll(run);
            run.clear();
        }

        private int width(String text, boolean swatch) {
            return metrics.stringWidth(text) + (swatch ? metrics.getHeight() : 0);
        }

        private static int width(List<Word> words) {
            return words.stream().mapToInt(word -> word.place.width).sum();
        }

        Dimension size() {
            return new Dimension(right + MARGIN, y + metrics.getHeight() + MARGIN);
        }
    }

    /** Paints a line. */
    private final class Cell extends DefaultTreeCellRenderer {
        private static final long serialVersionUID = 1L;
        private transient Flow flow;

        Cell() {
            setLeafIcon(null);
            setOpenIcon(null);
            setClosedIcon(null);
        }

        @Override
        public Component getTreeCellRendererComponent(JTree tree, Object value, boolean chosen, boolean expanded, boolean leaf, int row,
                boolean focused) {
            super.getTreeCellRendererComponent(tree, value, chosen, expanded, leaf, row, focused);
            flow = value instanceof Node node ? flow(node) : null;
            return this;
        }

        @Override
        public Dimension getPreferredSize() {
            return flow == null ? super.getPreferredSize() : flow.size();
        }

        @Override
        public void paint(Graphics g) {
            if (flow == null) {
                super.paint(g);
                return;
            }
            Graphics2D canvas = (Graphics2D) g.create();
            if (Toolkit.getDefaultToolkit().getDesktopProperty("awt.font.desktophints") instanceof Map<?, ?> hints) {
                canvas.addRenderingHints(hints);
            } else {
                canvas.setRenderingHint(RenderingHints.KEY_TEXT_ANTIALIASING, RenderingHints.VALUE_TEXT_ANTIALIAS_ON);
            }
            FontMetrics metrics = StoryTree.this.getFontMetrics(StoryTree.this.getFont());
            canvas.setFont(StoryTree.this.getFont());
            Color link = UIManager.getColor("Component.linkColor");
            for (Word word : flow.words) {
                int left = word.place.x;
                int base = word.place.y + metrics.getAscent();
                if (word.swatch) {
                    int side = metrics.getAscent() - 2;
                    canvas.setColor(shown(word.part.swatch()));
                    canvas.fillRect(left, base - side + 1, side, side);
                    canvas.setColor(Color.GRAY);
                    canvas.drawRect(left, base - side + 1, side, side);
                    left += metrics.getHeight();
                }
                boolean isLink = word.part.source() > 0;
                canvas.setColor(isLink && !selected && link != null ? link : getForeground());
                canvas.drawString(word.text, left, base);
                if (isLink) {
                    canvas.drawLine(left, base + 1, left + metrics.stringWidth(word.text) - 1, base + 1);
                }
            }
            canvas.dispose();
        }

        private static Color shown(Colour c) {
            return new Color(Picture.level(c.r), Picture.level(c.g), Picture.level(c.b));
        }
    }
}
