package simpleray.ui.editor;

import java.awt.BorderLayout;
import java.util.List;
import javax.swing.BorderFactory;
import javax.swing.JPanel;
import javax.swing.SwingUtilities;
import javax.swing.event.DocumentEvent;
import javax.swing.event.DocumentListener;
import org.fife.ui.rtextarea.RTextScrollPane;
import simpleray.text.Diagnostic;
import simpleray.ui.widget.KeyBindings;

/** The scene's text with its line numbers, and below it a line for finding. It knows nothing of files. */
final class SceneEditor extends JPanel {
    private static final long serialVersionUID = 1L;

    private final SceneArea area = new SceneArea();
    private final RTextScrollPane scroll = new RTextScrollPane(area);
    private final FindBar find = new FindBar(area);

    /**
     * Creates an editor without text.
     *
     * @param changed called when the text has changed
     */
    SceneEditor(Runnable changed) {
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
        area.getDocument().addDocumentListener(new DocumentListener() {
            @Override
            public void insertUpdate(DocumentEvent e) {
                changed.run();
            }

            @Override
            public void removeUpdate(DocumentEvent e) {
                changed.run();
            }

            @Override
            public void changedUpdate(DocumentEvent e) {
                // of styles, and there are none
            }
        });
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
        area.setText(text);
        area.discardAllEdits();
        area.setCaretPosition(0);
    }

    void mark(List<Diagnostic> problems) {
        area.mark(problems, scroll.getGutter());
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
