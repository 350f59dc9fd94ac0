package simpleray.ui.editor;

import java.awt.AWTEvent;
import java.awt.Color;
import java.awt.Container;
import java.awt.Graphics;
import java.awt.Point;
import java.awt.Rectangle;
import java.awt.event.KeyEvent;
import java.awt.event.MouseEvent;
import java.awt.event.MouseWheelEvent;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import javax.swing.JScrollPane;
import javax.swing.KeyStroke;
import javax.swing.SwingUtilities;
import javax.swing.ToolTipManager;
import javax.swing.text.BadLocationException;
import javax.swing.text.DefaultHighlighter;
import javax.swing.text.Highlighter;
import org.fife.ui.rsyntaxtextarea.RSyntaxDocument;
import org.fife.ui.rsyntaxtextarea.RSyntaxTextArea;
import org.fife.ui.rsyntaxtextarea.SquiggleUnderlineHighlightPainter;
import org.fife.ui.rtextarea.Gutter;
import simpleray.text.Diagnostic;
import simpleray.text.SourceValue;
import simpleray.ui.widget.KeyBindings;
import simpleray.ui.widget.Look;
import simpleray.ui.widget.WarningIcon;

/** The text of a scene, coloured, with its problems marked. */
final class SceneArea extends RSyntaxTextArea {
    private static final long serialVersionUID = 1L;
    /** Keys that editors have for something, and this window for something else. */
    private static final String[] WINDOWS = {"control ENTER", "control ADD", "control SUBTRACT"};

    private final transient List<Mark> marks = new ArrayList<>();
    private transient ValueTable values = ValueTable.NONE;
    private final transient List<Object> lit = new ArrayList<>();
    private transient SourceValue.Thing litThing;
    private transient ValueTable litOf = ValueTable.NONE;
    private transient Point pointed;                          // the place of the mouse; null if it is elsewhere
    private transient Runnable moved = () -> { };
    private final transient NumberTool numbers = new NumberTool(this);
    private final transient ColourTool colours = new ColourTool(this);

    /** A marked piece of the text, which moves with it. */
    private record Mark(Highlighter.Highlight place, Diagnostic problem) {
    }

    SceneArea() {
        ((RSyntaxDocument) getDocument()).setSyntaxStyle(new SceneTokens());
        setName("scene-text");
        getAccessibleContext().setAccessibleName("Scene text");
        setTabSize(4);
        setCodeFoldingEnabled(false);
        setBracketMatchingEnabled(false);
        setCloseCurlyBraces(false);
        setInsertPairedCharacters(false);
        setAutoIndentEnabled(true);
        for (String key : WINDOWS) {
            getInputMap().put(KeyStroke.getKeyStroke(key), "none");
        }
        numbers.setClicked(colours::choose);
        ToolTipManager.sharedInstance().registerComponent(this);
        enableEvents(AWTEvent.MOUSE_WHEEL_EVENT_MASK);        // see below
    }

    /** Marks problems, each with a wavy line and a sign in the gutter, in place of those that were marked. */
    void mark(List<Diagnostic> problems, Gutter gutter) {
        marks.forEach(mark -> getHighlighter().removeHighlight(mark.place));
        marks.clear();
        gutter.removeAllTrackingIcons();
        SquiggleUnderlineHighlightPainter red = new SquiggleUnderlineHighlightPainter(new Color(0xE5443F));
        SquiggleUnderlineHighlightPainter amber = new SquiggleUnderlineHighlightPainter(new Color(0xD99A00));
        try {
            for (Diagnostic problem : problems) {
                int from = offset(problem.line(), problem.column());
                int to = wordEnd(from);
                int shown = to > from ? from : Math.max(0, from - 1);     // at an end of the text: the character before it
                marks.add(new Mark((Highlighter.Highlight) getHighlighter().addHighlight(shown, to, problem.error() ? red : amber),
                    problem));
                gutter.addOffsetTrackingIcon(from, new WarningIcon(problem.error()), problem.message());
            }
        } catch (BadLocationException e) {
            throw new IllegalStateException(e);               // all offsets are of this text
        }
    }

    /** Takes the values of the text. */
    void setValues(ValueTable other) {
        values = other;
        repaint();
    }

    ValueTable values() {
        return values;
    }

    /** {@return the messages of the marks, each with the text that is marked} */
    List<String> marked() {
        return marks.stream().map(mark -> {
            int from = mark.place.getStartOffset();
            return getText().substring(from, mark.place.getEndOffset()) + ": " + mark.problem.message();
        }).toList();
    }

    /** {@return the offset of a line and a column, both counted from 1; beyond the text, the nearest offset} */
    int offset(int line, int column) {
        try {
            if (line > getLineCount()) {
                return getDocument().getLength();
            }
            int from = getLineStartOffset(line - 1);
            int end = line == getLineCount() ? getDocument().getLength() : getLineEndOffset(line - 1) - 1;
            String text = getText(from, end - from);
            return from + text.offsetByCodePoints(0, Math.min(column - 1, text.codePointCount(0, text.length())));
        } catch (BadLocationException e) {
            throw new IllegalStateException(e);               // the line is one of this text
        }
    }

    private int wordEnd(int from) throws BadLocationException {
        int end = from;
        while (end < getDocument().getLength() && !Character.isWhitespace(getText(end, 1).charAt(0)) && getText(end, 1).charAt(0) != '#') {
            end++;
        }
        return end;
    }

    @Override
    public void scrollRectToVisible(Rectangle place) {
        Rectangle whole = new Rectangle(place);
        if (whole.x <= getInsets().left) {                    // at the start of a line the margin before it is seen, too
            whole.add(new Point(0, whole.y));
        }
        super.scrollRectToVisible(whole);
    }

    @Override
    public void undoLastAction() {
        numbers.end();                                        // a step that the wheel has begun
        super.undoLastAction();
    }

    /**
     * Replaces the text, except for an equal start and end, so that carets stay and it can be undone.
     *
     * @return the offset of the last letter that was replaced
     */
    int replaceAll(String text) {
        String now = getText();
        int same = 0;
        int least = Math.min(now.length(), text.length());
        while (same < least && now.charAt(same) == text.charAt(same)) {
            same++;
        }
        int below = 0;
        while (below < least - same && now.charAt(now.length() - 1 - below) == text.charAt(text.length() - 1 - below)) {
            below++;
        }
        replaceRange(text.substring(same, text.length() - below), same, now.length() - below);
        return Math.max(same, text.length() - below - 1);
    }

    /** {@return the object or light under the mouse, or else at the caret; null for none} */
    SourceValue.Thing thing() {
        int mouse = pointed == null ? -1 : values.at(viewToModel2D(pointed));
        int i = mouse >= 0 && values.value(mouse).thing() != null ? mouse : values.at(getCaretPosition());
        return i < 0 ? null : values.value(i).thing();
    }

    /** Lights up the values of an object or light; null for none. */
    void light(SourceValue.Thing thing) {
        if (values == litOf && Objects.equals(thing, litThing)) {
            return;
        }
        litOf = values;
        litThing = thing;
        lit.forEach(getHighlighter()::removeHighlight);
        lit.clear();
        DefaultHighlighter.DefaultHighlightPainter painter = new DefaultHighlighter.DefaultHighlightPainter(
            Look.isDark(this) ? new Color(0x5C4A12) : new Color(0xFFE9B0));
        try {
            for (int i : values.of(thing)) {
                lit.add(getHighlighter().addHighlight(values.start(i), values.end(i), painter));
            }
        } catch (BadLocationException e) {
            throw new IllegalStateException(e);               // the values are of this text
        }
    }

    /** Sets what is called when another place of the text is under the mouse. */
    void setMoved(Runnable other) {
        moved = other;
    }

    /** {@return the values that are lit up} */
    List<String> lit() {
        return lit.stream().map(Highlighter.Highlight.class::cast)
            .map(place -> getText().substring(place.getStartOffset(), place.getEndOffset())).toList();
    }

    NumberTool numbers() {
        return numbers;
    }

    ColourTool colours() {
        return colours;
    }

    @Override
    protected void paintComponent(Graphics g) {
        super.paintComponent(g);
        colours.paint(g);
    }

    @Override
    protected void processMouseEvent(MouseEvent e) {
        if (e.getID() == MouseEvent.MOUSE_EXITED) {
            pointed = null;
            moved.run();
        }
        if (!numbers.takes(e)) {
            super.processMouseEvent(e);
        }
    }

    @Override
    protected void processMouseMotionEvent(MouseEvent e) {
        pointed = e.getPoint();
        moved.run();
        if (!numbers.takes(e)) {
            super.processMouseMotionEvent(e);
        }
    }

    @Override
    protected void processMouseWheelEvent(MouseWheelEvent e) {
        Container pane = SwingUtilities.getAncestorOfClass(JScrollPane.class, this);
        if (numbers.takes(e)) {
            e.consume();
        } else if (pane != null) {                            // which would have it, did this not ask for it
            pane.dispatchEvent(SwingUtilities.convertMouseEvent(this, e, pane));
        }
    }

    /** {@return the messages of the problems at a place, or else what the value there is; null for none} */
    @Override
    public String getToolTipText(MouseEvent e) {
        int at = viewToModel2D(e.getPoint());
        StringBuilder tip = new StringBuilder();
        for (Mark mark : marks) {
            if (at >= mark.place.getStartOffset() && at <= mark.place.getEndOffset()) {
                tip.append(tip.length() == 0 ? "" : "\n").append(mark.problem.message());
            }
        }
        if (tip.length() > 0) {
            return tip.toString();                            // which names the value
        }
        int i = values.at(at);
        return i >= 0 && at < values.end(i) ? values.value(i).toString() : null;
    }

    @Override
    protected boolean processKeyBinding(KeyStroke key, KeyEvent e, int condition, boolean pressed) {
        return super.processKeyBinding(key, e, condition, pressed) || condition == WHEN_FOCUSED && KeyBindings.isCharacter(e);
    }
}
