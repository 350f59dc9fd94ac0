package simpleray.ui.editor;

import java.awt.Color;
import java.awt.Cursor;
import java.awt.Dimension;
import java.awt.Insets;
import java.awt.event.FocusEvent;
import java.awt.event.FocusListener;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import javax.swing.JTextPane;
import javax.swing.JViewport;
import javax.swing.UIManager;
import javax.swing.text.AttributeSet;
import javax.swing.text.BadLocationException;
import javax.swing.text.DefaultHighlighter;
import javax.swing.text.SimpleAttributeSet;
import javax.swing.text.StyleConstants;
import simpleray.text.Diagnostic;
import simpleray.ui.widget.KeyBindings;
import simpleray.ui.widget.Look;

/**
 * The problems of a scene as messages show them, each with its source line. A problem's place is a link; one of the problems is
 * selected, by the arrow keys or a click, and Enter or a double click follows its link.
 */
public final class DiagnosticsPane extends JTextPane {
    private static final long serialVersionUID = 1L;
    private static final int MAX_LINES = 6;

    private final transient Consumer<Diagnostic> follower;
    private final transient List<Entry> entries = new ArrayList<>();
    private int selected = -1;
    private boolean visited;                                  // the link of one of these problems was followed

    /** A problem, where in the text it begins and ends, and where its place ends. */
    private record Entry(Diagnostic problem, int from, int to, int linked) {
    }

    /**
     * Creates an empty pane.
     *
     * @param follower called with the problem whose link was followed
     */
    public DiagnosticsPane(Consumer<Diagnostic> follower) {
        this.follower = follower;
        setName("problems");
        getAccessibleContext().setAccessibleName("Problems of the scene");
        getAccessibleContext().setAccessibleDescription("Enter goes to the selected problem's line");
        setEditable(false);
        setFont(Look.monospaced());
        KeyBindings.bind(this, WHEN_FOCUSED, "ENTER", this::follow);
        addCaretListener(e -> selectAt(e.getDot()));
        addFocusListener(new FocusListener() {
            @Override
            public void focusGained(FocusEvent e) {
                getCaret().setVisible(true);                  // else a text that is not edited shows none
            }

            @Override
            public void focusLost(FocusEvent e) {
                getCaret().setVisible(false);
            }
        });
        MouseAdapter mouse = new MouseAdapter() {
            @Override
            public void mouseClicked(MouseEvent e) {
                if (e.getButton() == MouseEvent.BUTTON1 && (e.getClickCount() == 2 || isLink(viewToModel2D(e.getPoint())))) {
                    follow();
                }
            }

            @Override
            public void mouseMoved(MouseEvent e) {
                boolean link = isLink(viewToModel2D(e.getPoint()));
                setCursor(Cursor.getPredefinedCursor(link ? Cursor.HAND_CURSOR : Cursor.TEXT_CURSOR));
            }
        };
        addMouseListener(mouse);
        addMouseMotionListener(mouse);
    }

    /**
     * Shows other problems.
     *
     * @param text the whole report
     * @param problems those with a place, in the order in which they stand in the text
     */
    public void show(String text, List<Diagnostic> problems) {
        entries.clear();
        visited = false;
        selected = -1;
        setText(text);
        int end = 0;
        for (Diagnostic problem : problems) {
            String shown = problem.toString();
            int at = text.indexOf(shown, end);
            if (at >= 0) {
                end = at + shown.length();
                String place = problem.file() + ':' + problem.line() + ':' + problem.column();
                entries.add(new Entry(problem, at, end, at + place.length()));
            }
        }
        paintLinks();
        setCaretPosition(0);
        selectAt(0);
    }

    /**
     * Selects the next problem or the one before, from the last on to the first, and follows its link; at first that of the first.
     *
     * @param by 1 for the next, -1 for the one before
     */
    public void step(int by) {
        if (!entries.isEmpty()) {
            int from = visited ? selected : by > 0 ? -1 : 0;
            setCaretPosition(entries.get(Math.floorMod(from + by, entries.size())).from);
            follow();
        }
    }

    /** {@return the problem that is selected; null for none} */
    Diagnostic selected() {
        return selected < 0 ? null : entries.get(selected).problem;
    }

    private void follow() {
        if (selected >= 0) {
            visited = true;
            follower.accept(entries.get(selected).problem);
        }
    }

    private boolean isLink(int offset) {
        return entries.stream().anyMatch(entry -> offset >= entry.from && offset < entry.linked);
    }

    /** Selects the problem whose text holds an offset. */
    private void selectAt(int offset) {
        int found = -1;
        for (int i = 0; i < entries.size(); i++) {
            if (offset >= entries.get(i).from && offset <= entries.get(i).to) {
                found = i;
            }
        }
        selected = found;
        getHighlighter().removeAllHighlights();
        if (found >= 0 && entries.size() > 1) {
            try {
                getHighlighter().addHighlight(entries.get(found).from, entries.get(found).to,
                    new DefaultHighlighter.DefaultHighlightPainter(Look.isDark(this) ? new Color(0x3A4A5C) : new Color(0xE3EEFB)));
            } catch (BadLocationException e) {
                throw new IllegalStateException(e);           // entries are of this text
            }
        }
    }

    private void paintLinks() {
        AttributeSet plain = new SimpleAttributeSet();
        getStyledDocument().setCharacterAttributes(0, getDocument().getLength(), plain, true);
        Color colour = UIManager.getColor("Component.linkColor");
        SimpleAttributeSet link = new SimpleAttributeSet();
        StyleConstants.setUnderline(link, true);
        StyleConstants.setForeground(link, colour == null ? getForeground() : colour);
        for (Entry entry : entries) {
            getStyledDocument().setCharacterAttributes(entry.from, entry.linked - entry.from, link, true);
        }
    }

    @Override
    public void updateUI() {
        super.updateUI();
        if (entries != null) {                                // not while the constructor above makes this
            setFont(Look.monospaced());
            paintLinks();
            selectAt(getCaretPosition());
        }
    }

    /** Lines are as long as they are, so that a caret stands under its word. */
    @Override
    public boolean getScrollableTracksViewportWidth() {
        return getParent().getWidth() > getUI().getPreferredSize(this).width;
    }

    @Override
    public Dimension getPreferredScrollableViewportSize() {
        int lines = Math.min(MAX_LINES, (int) getText().lines().count() + 1);      // one for a scroll bar
        return new Dimension(getPreferredSize().width, height(lines));
    }

    private int height(int lines) {
        Insets insets = getInsets();
        return lines * getFontMetrics(getFont()).getHeight() + insets.top + insets.bottom;
    }

    /**
     * {@return the greatest height, no greater than a given one, in which no line is cut; that one if all have room, or none has}
     *
     * @param height of a scroll pane that shows this and has been laid out
     */
    public int whole(int height) {
        if (!(getParent() instanceof JViewport port)) {
            return height;
        }
        int around = port.getParent().getHeight() - port.getHeight();             // with a scroll bar, if there is one
        int lines = (height - around - height(0)) / getFontMetrics(getFont()).getHeight();
        return lines > 0 && lines < getText().lines().count() ? height(lines) + around : height;
    }
}
