package simpleray.ui.editor;

import java.awt.BorderLayout;
import java.awt.event.KeyEvent;
import javax.swing.BorderFactory;
import javax.swing.Box;
import javax.swing.BoxLayout;
import javax.swing.JButton;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JTextField;
import javax.swing.KeyStroke;
import javax.swing.event.DocumentEvent;
import javax.swing.event.DocumentListener;
import org.fife.ui.rtextarea.RTextArea;
import org.fife.ui.rtextarea.SearchContext;
import org.fife.ui.rtextarea.SearchEngine;
import org.fife.ui.rtextarea.SearchResult;
import simpleray.ui.widget.KeyBindings;

/** A line below a text for finding something in it: as one types, forwards and backwards, round the end. */
final class FindBar extends JPanel {
    private static final long serialVersionUID = 1L;
    private static final int COLUMNS = 16;

    private final RTextArea area;
    private final JTextField field = new JTextField(COLUMNS) {
        private static final long serialVersionUID = 1L;

        @Override
        protected boolean processKeyBinding(KeyStroke key, KeyEvent e, int condition, boolean pressed) {
            return super.processKeyBinding(key, e, condition, pressed) || condition == WHEN_FOCUSED && KeyBindings.isCharacter(e);
        }
    };
    private final JLabel found = new JLabel(" ");

    FindBar(RTextArea area) {
        super(new BorderLayout(8, 0));
        this.area = area;
        setVisible(false);
        setBorder(BorderFactory.createEmptyBorder(4, 8, 4, 8));
        field.setName("find");
        field.getAccessibleContext().setAccessibleName("Find");
        found.setName("found");
        JPanel buttons = new JPanel();
        buttons.setLayout(new BoxLayout(buttons, BoxLayout.X_AXIS));
        buttons.add(found);
        buttons.add(Box.createHorizontalStrut(8));
        buttons.add(button("\u2191", "Previous (Shift+Enter)", () -> find(false, area.getSelectionStart())));
        buttons.add(button("\u2193", "Next (Enter)", () -> find(true, area.getSelectionEnd())));
        buttons.add(button("\u00D7", "Close (Esc)", this::close));
        add(new JLabel("Find:"), BorderLayout.WEST);
        add(field, BorderLayout.CENTER);
        add(buttons, BorderLayout.EAST);
        KeyBindings.bind(field, WHEN_FOCUSED, "ENTER", () -> find(true, area.getSelectionEnd()));
        KeyBindings.bind(field, WHEN_FOCUSED, "shift ENTER", () -> find(false, area.getSelectionStart()));
        KeyBindings.bind(this, WHEN_ANCESTOR_OF_FOCUSED_COMPONENT, "ESCAPE", this::close);
        field.getDocument().addDocumentListener(new DocumentListener() {
            @Override
            public void insertUpdate(DocumentEvent e) {
                find(true, area.getSelectionStart());
            }

            @Override
            public void removeUpdate(DocumentEvent e) {
                find(true, area.getSelectionStart());
            }

            @Override
            public void changedUpdate(DocumentEvent e) {
                // of styles, and there are none
            }
        });
    }

    private static JButton button(String sign, String name, Runnable task) {
        JButton button = new JButton(sign);
        button.putClientProperty("JButton.buttonType", "toolBarButton");
        button.setToolTipText(name);
        button.getAccessibleContext().setAccessibleName(name);
        button.addActionListener(e -> task.run());
        return button;
    }

    /** Shows the line, with the selected text as the text to find. */
    void open() {
        String selected = area.getSelectedText();
        if (selected != null && selected.indexOf('\n') < 0) {
            field.setText(selected);
        }
        setVisible(true);
        field.selectAll();
        field.requestFocusInWindow();
    }

    /** Finds the same text again. */
    void again(boolean forward) {
        find(forward, forward ? area.getSelectionEnd() : area.getSelectionStart());
    }

    private void close() {
        setVisible(false);
        SearchEngine.markAll(area, new SearchContext());
        area.requestFocusInWindow();
    }

    private void find(boolean forward, int from) {
        SearchContext context = new SearchContext(field.getText());
        context.setSearchForward(forward);
        context.setSearchWrap(true);
        if (field.getText().isEmpty()) {
            SearchEngine.markAll(area, context);
            found.setText(" ");
            return;
        }
        area.setCaretPosition(from);
        SearchResult result = SearchEngine.find(area, context);
        found.setText(result.wasFound() ? result.getMarkedCount() + (result.isWrapped() ? " found, from the other end" : " found")
            : "not found");
    }
}
