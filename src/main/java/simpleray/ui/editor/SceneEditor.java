package simpleray.ui.editor;

import java.awt.BorderLayout;
import java.awt.Rectangle;
import java.awt.geom.Rectangle2D;
import java.util.List;
import javax.swing.BorderFactory;
import javax.swing.JPanel;
import javax.swing.SwingUtilities;
import javax.swing.event.DocumentEvent;
import javax.swing.event.DocumentListener;
import javax.swing.text.BadLocationException;
import org.fife.ui.rtextarea.RTextScrollPane;
import simpleray.text.Diagnostic;
import simpleray.text.NumberParser;
import simpleray.ui.widget.KeyBindings;

/** The scene's text with its line numbers, and below it a line for finding. It knows nothing of files. */
final class SceneEditor extends JPanel {
    private static final long serialVersionUID = 1L;

    private final SceneArea area = new SceneArea();
    private final RTextScrollPane scroll = new Pane(area);
    private final transient Runnable moved;
    private final FindBar find = new FindBar(area);

    /**
     * Creates an editor without text.
     *
     * @param changed called when the text has changed
     * @param moved called when the caret is at another value
     */
    SceneEditor(Runnable changed, Runnable moved) {
        super(new BorderLayout());
        scroll.setIconRowHeaderEnabled(true);
        scroll.setFoldIndicatorEnabled(false);
        scroll.setBorder(BorderFactory.createEmptyBorder());
        add(scroll, BorderLayout.CENTER);
        add(find, BorderLayout.SOUTH);
        TextColours.apply(area, scroll.getGutter());
        KeyBindings.bind(this, WHEN_ANCESTOR_OF_FOCUSED_COMPONENT, "control F", this::find);
        KeyBindings.bind(this, WHEN_ANCESTOR_OF_FOCUSED_COMPONENT, "F3", () -> find.again(true));
        KeyBindings.bind(this, WHEN_ANCESTOR_OF_FOCUSED_COMPONENT, "shift F3", () -> find.again(false));
        this.moved = moved;
        area.addCaretListener(e -> moved.run());
        area.setMoved(moved);
        area.getDocument().addDocumentListener(new DocumentListener() {
            @Override
            public void insertUpdate(DocumentEvent e) {
                area.values().changed(e.getOffset(), e.getLength(), 0);
                changed.run();
            }

            @Override
            public void removeUpdate(DocumentEvent e) {
                area.values().changed(e.getOffset(), 0, e.getLength());
                changed.run();
            }

            @Override
            public void changedUpdate(DocumentEvent e) {
                // of styles, and there are none
            }
        });
    }

    /** Keeps the caret's line in sight if it was there before its height changed: what opens below must not cover what is being typed. */
    private static final class Pane extends RTextScrollPane {
        private static final long serialVersionUID = 1L;

        Pane(SceneArea area) {
            super(area);
        }

        /** At once, not when an event tells of it: problems that close and open again move the text twice between two events. */
        @Override
        public void doLayout() {
            Rectangle before = caret();
            boolean seen = before != null && getViewport().getViewRect().intersects(before);
            super.doLayout();
            Rectangle now = caret();
            if (seen && now != null && now.getMaxY() > getViewport().getViewRect().getMaxY()) {
                getTextArea().scrollRectToVisible(now);
            }
        }

        private Rectangle caret() {
            try {
                Rectangle2D place = getTextArea() == null ? null : getTextArea().modelToView2D(getTextArea().getCaretPosition());
                return place == null ? null : place.getBounds();
            } catch (BadLocationException e) {
                throw new IllegalStateException(e);           // the caret is in the text
            }
        }
    }

    SceneArea area() {
        return area;
    }

    String text() {
        return area.getText();
    }

    /** {@return whether the text is that} */
    boolean holds(String text) {
        return area.getDocument().getLength() == text.length() && area.getText().equals(text);
    }

    /** Begins with a text, which cannot be undone. */
    void begin(String text) {
        mark(List.of());
        area.setValues(ValueTable.NONE);
        area.setText(text);
        area.discardAllEdits();
        area.setCaretPosition(0);
    }

    void mark(List<Diagnostic> problems) {
        area.mark(problems, scroll.getGutter());
    }

    /** Takes the values of the text. */
    void setValues(ValueTable values) {
        area.setValues(values);
        moved.run();
    }

    /** {@return what the value at the caret is; a blank for none} */
    String valueLine() {
        int i = area.values().at(area.getCaretPosition());
        return i < 0 ? " " : area.values().value(i).toString();
    }

    /**
     * Adds a line behind the last object or light, and raises their number; all of that is undone in one step.
     *
     * @param what "object" or "light"
     * @return whether the text has such a number
     */
    boolean insert(String what, String line) {
        ValueTable values = area.values();
        int count = values.count(what);
        Long number = count < 0 ? null
            : NumberParser.parseInteger(area.getText().substring(values.start(count), values.end(count)), 0, Integer.MAX_VALUE);
        if (number == null) {
            return false;
        }
        int last = values.last(what);
        int lineEnd = area.getText().indexOf('\n', values.end(last));
        int end = lineEnd < 0 ? area.getDocument().getLength() : lineEnd;
        boolean shared = last + 1 < values.size() && values.start(last + 1) < end;
        int at = shared ? values.end(last) : end;
        area.beginAtomicEdit();
        try {
            area.insert("\n" + line + (shared ? "\n" : ""), at);
            area.replaceRange(String.valueOf(number + 1), values.start(count), values.end(count));
        } finally {
            area.endAtomicEdit();
        }
        area.setCaretPosition(area.getText().indexOf(line, values.end(count)));
        area.requestFocusInWindow();
        return true;
    }

    /** Puts the caret at a line and a column, counted from 1, and gives the text the keys. */
    void goTo(int line, int column) {
        area.setCaretPosition(area.offset(line, column));
        area.requestFocusInWindow();
    }

    /** Shows the line for finding. */
    void find() {
        find.open();
    }

    @Override
    public void updateUI() {
        super.updateUI();
        if (scroll != null) {                                 // not while the constructor above makes this
            SwingUtilities.invokeLater(() -> TextColours.apply(area, scroll.getGutter()));      // when all parts have the new look
        }
    }
}
