package simpleray.ui.desktop;

import java.awt.BorderLayout;
import java.awt.Dimension;
import java.awt.GridLayout;
import java.awt.Rectangle;
import java.awt.event.FocusAdapter;
import java.awt.event.FocusEvent;
import java.io.File;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.concurrent.Executor;
import java.util.function.Consumer;
import javax.swing.BorderFactory;
import javax.swing.Box;
import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.Scrollable;
import javax.swing.SwingConstants;
import javax.swing.SwingUtilities;
import simpleray.ui.file.Samples;
import simpleray.ui.file.SceneSource;

/** The sample scenes as pictures to choose from, and beside them the recent scenes. For the event thread. */
final class ExamplesPane extends JPanel {
    private static final long serialVersionUID = 1L;
    private static final int MARGIN = 12;
    private static final int RECENT_WIDTH = 220;
    private static final int MAX_RECENT = 30;                 // letters

    private final transient Executor renderer;
    private final List<JButton> samples = new ArrayList<>();  // in reading order
    private boolean filling;

    /**
     * Lists the samples; their pictures come as they are rendered, while the pane is on the screen: in reading order, those in sight first.
     *
     * @param renderer renders them, one after another
     * @param open opens the one that is chosen
     */
    ExamplesPane(Executor renderer, Consumer<SceneSource> open) {
        super(new BorderLayout());
        setName("examples");
        this.renderer = renderer;
        Grid grid = new Grid();
        for (SceneSource sample : Samples.all()) {
            JButton button = button(label(sample), () -> open.accept(sample));
            button.setIcon(new Thumbnail(sample));
            button.setHorizontalTextPosition(SwingConstants.CENTER);
            button.setVerticalTextPosition(SwingConstants.BOTTOM);
            grid.add(button);
            samples.add(button);
        }
        JScrollPane scroll = new JScrollPane(grid, JScrollPane.VERTICAL_SCROLLBAR_AS_NEEDED, JScrollPane.HORIZONTAL_SCROLLBAR_NEVER);
        scroll.setBorder(BorderFactory.createEmptyBorder());
        add(titled("Examples", scroll), BorderLayout.CENTER);
        addHierarchyListener(e -> SwingUtilities.invokeLater(this::fill));      // once it is laid out
    }

    /** Renders one picture after another. Which is next is decided when the one before is there: the user may have scrolled meanwhile. */
    private void fill() {
        Optional<JButton> next = filling || !isShowing() ? Optional.empty()
            : samples.stream().filter(sample -> !picture(sample).isAsked())
                .min(Comparator.comparing(sample -> sample.getVisibleRect().isEmpty()));
        next.ifPresent(sample -> {
            filling = true;
            picture(sample).render(renderer, sample, () -> {
                filling = false;
                fill();
            });
        });
    }

    private static Thumbnail picture(JButton sample) {
        return (Thumbnail) sample.getIcon();
    }

    /**
     * Lists scenes at the left.
     *
     * @param recent their files
     * @param open opens the one that is chosen
     */
    void addRecent(List<Path> recent, Consumer<Path> open) {
        if (recent.isEmpty()) {
            return;
        }
        Box list = Box.createVerticalBox();
        for (Path file : recent) {
            String name = String.valueOf(file.getFileName());
            JButton button = button(name.length() > MAX_RECENT ? name.substring(0, MAX_RECENT) + '\u2026' : name, () -> open.accept(file));
            button.setToolTipText(file.toString());
            list.add(button);
        }
        JPanel pane = titled("Recent", list);
        pane.setPreferredSize(new Dimension(RECENT_WIDTH, 0));
        add(pane, BorderLayout.WEST);
    }

    private static JPanel titled(String title, JComponent content) {
        JLabel label = new JLabel(title);
        label.putClientProperty("FlatLaf.styleClass", "h2");
        label.setBorder(BorderFactory.createEmptyBorder(0, 4, MARGIN / 2, 0));
        JPanel pane = new JPanel(new BorderLayout());
        pane.setBorder(BorderFactory.createEmptyBorder(MARGIN, MARGIN, 0, 0));
        pane.add(label, BorderLayout.NORTH);
        pane.add(content, BorderLayout.CENTER);
        return pane;
    }

    /** {@return a flat button that Tab reaches} Where it is out of sight, it comes into sight with the keys. */
    private static JButton button(String text, Runnable task) {
        JButton button = new JButton(text);
        button.putClientProperty("JButton.buttonType", "borderless");
        button.addActionListener(e -> task.run());
        button.addFocusListener(new FocusAdapter() {
            @Override
            public void focusGained(FocusEvent e) {
                button.scrollRectToVisible(new Rectangle(button.getSize()));
            }
        });
        return button;
    }

    /** {@return a sample's name for people: {@code Ball pyramid}} */
    static String label(SceneSource sample) {
        String name = new File(sample.name()).getName().replaceFirst("\\.scene$", "").replace('-', ' ');
        return name.substring(0, 1).toUpperCase(Locale.ROOT) + name.substring(1);
    }

    /** As many columns as there is room for. */
    private static final class Grid extends JPanel implements Scrollable {
        private static final long serialVersionUID = 1L;
        private static final int GAP = 6;
        private static final int COLUMNS = 4;

        private final GridLayout columns = new GridLayout(0, COLUMNS, GAP, GAP);

        Grid() {
            setLayout(columns);
        }

        @Override
        public void setBounds(int x, int y, int width, int height) {
            int one = getComponentCount() == 0 ? 1 : getComponent(0).getPreferredSize().width + GAP;
            columns.setColumns(Math.max(1, width / one));
            super.setBounds(x, y, width, height);
        }

        @Override
        public Dimension getPreferredScrollableViewportSize() {
            return getPreferredSize();
        }

        @Override
        public int getScrollableUnitIncrement(Rectangle visible, int orientation, int direction) {
            return Thumbnail.HEIGHT / 4;
        }

        @Override
        public int getScrollableBlockIncrement(Rectangle visible, int orientation, int direction) {
            return visible.height;
        }

        @Override
        public boolean getScrollableTracksViewportWidth() {
            return true;
        }

        @Override
        public boolean getScrollableTracksViewportHeight() {
            return false;
        }
    }
}
