package simpleray.ui.widget;

import java.awt.BorderLayout;
import java.awt.Color;
import java.awt.FlowLayout;
import java.util.LinkedHashMap;
import java.util.Map;
import javax.accessibility.AccessibleContext;
import javax.accessibility.AccessibleRole;
import javax.swing.Action;
import javax.swing.BorderFactory;
import javax.swing.BoxLayout;
import javax.swing.JButton;
import javax.swing.JLabel;
import javax.swing.JPanel;

/** Notices across the top of a window that stay until their reason is over, each perhaps with buttons. */
public final class Banner extends JPanel {
    private static final long serialVersionUID = 1L;

    private final Map<String, Notice> notices = new LinkedHashMap<>();

    /** Creates a banner without a notice. */
    public Banner() {
        setLayout(new BoxLayout(this, BoxLayout.Y_AXIS));
        setName("banner");
    }

    /**
     * Shows a notice, in place of an earlier one about the same.
     *
     * @param about what it is about
     * @param message what it says
     * @param actions what can be done, each a button; their mnemonics work
     */
    public void show(String about, String message, Action... actions) {
        Notice shown = notices.get(about);
        if (shown != null && shown.message.getText().equals(message)) {
            return;
        }
        hide(about);
        Notice notice = new Notice(message, actions);
        notices.put(about, notice);
        add(notice);
        revalidate();
        repaint();
    }

    /**
     * Takes away the notice about something; nothing happens if there is none.
     *
     * @param about what it is about
     */
    public void hide(String about) {
        Notice notice = notices.remove(about);
        if (notice != null) {
            remove(notice);
            revalidate();
            repaint();
        }
    }

    /**
     * {@return the message about something; null for none}
     *
     * @param about what it is about
     */
    public String message(String about) {
        Notice notice = notices.get(about);
        return notice == null ? null : notice.message.getText();
    }

    /** One message and its buttons. */
    private static final class Notice extends JPanel {
        private static final long serialVersionUID = 1L;
        private static final Color LIGHT = new Color(0xFFF3CD);
        private static final Color DARK = new Color(0x4D4321);

        private final JLabel message;

        Notice(String text, Action... actions) {
            super(new BorderLayout(12, 0));
            message = new JLabel(text, new WarningIcon(), JLabel.LEADING);
            message.setName("notice");
            setBorder(BorderFactory.createEmptyBorder(4, 10, 4, 10));
            add(message, BorderLayout.CENTER);
            JPanel buttons = new JPanel(new FlowLayout(FlowLayout.TRAILING, 6, 0));
            buttons.setOpaque(false);
            for (Action action : actions) {
                buttons.add(new JButton(action));
            }
            if (actions.length > 0) {
                add(buttons, BorderLayout.EAST);
            }
        }

        @Override
        public Color getBackground() {
            return Look.isDark(this) ? DARK : LIGHT;
        }

        @Override
        public AccessibleContext getAccessibleContext() {
            if (accessibleContext == null) {
                accessibleContext = new AccessibleJPanel() {
                    private static final long serialVersionUID = 1L;

                    @Override
                    public AccessibleRole getAccessibleRole() {
                        return AccessibleRole.ALERT;
                    }
                };
                accessibleContext.setAccessibleName(message.getText());
            }
            return accessibleContext;
        }
    }
}
