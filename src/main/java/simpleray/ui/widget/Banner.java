package simpleray.ui.widget;

import java.awt.BorderLayout;
import java.awt.Color;
import java.awt.Dimension;
import java.awt.FlowLayout;
import java.awt.Rectangle;
import java.awt.event.ComponentAdapter;
import java.awt.event.ComponentEvent;
import java.util.LinkedHashMap;
import java.util.Map;
import javax.accessibility.AccessibleContext;
import javax.accessibility.AccessibleRole;
import javax.swing.Action;
import javax.swing.BorderFactory;
import javax.swing.BoxLayout;
import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.SwingUtilities;

/**
 * Notices at the top of a window that stay until their reason is over, each with buttons. The latest lies over the right end of another
 * component, so that nothing moves when one comes or goes; the others wait until it goes. One that only tells waits for those that ask.
 */
public final class Banner extends JPanel {
    private static final long serialVersionUID = 1L;

    private final Map<String, Notice> notices = new LinkedHashMap<>();
    private final JComponent under;

    /**
     * Creates a banner without a notice.
     *
     * @param under what it lies over
     */
    public Banner(JComponent under) {
        this.under = under;
        setLayout(new BoxLayout(this, BoxLayout.Y_AXIS));
        setName("banner");
        setVisible(false);
        under.addComponentListener(new ComponentAdapter() {
            @Override
            public void componentResized(ComponentEvent e) {
                place();
            }

            @Override
            public void componentMoved(ComponentEvent e) {
                place();
            }
        });
    }

    /** Takes the room of what is under it, from the right as far as the latest notice needs; one that asks goes first. */
    private void place() {
        setVisible(!notices.isEmpty());
        Notice seen = null;
        for (Notice notice : notices.values()) {
            seen = seen == null || notice.asks || !seen.asks ? notice : seen;
        }
        for (Notice notice : notices.values()) {
            notice.setVisible(notice == seen);
        }
        if (isVisible() && getParent() != null) {
            Rectangle room = SwingUtilities.convertRectangle(under.getParent(), under.getBounds(), getParent());
            Dimension wanted = getPreferredSize();
            int width = Math.min(room.width, wanted.width);
            setBounds(room.x + room.width - width, room.y, width, Math.max(room.height, wanted.height));
            revalidate();
            repaint();
        }
    }

    /**
     * Shows a notice, in place of an earlier one about the same.
     *
     * @param about what it is about
     * @param message what it says
     * @param actions what can be done, each a button; their mnemonics work; without any, the notice can be hidden
     */
    public void show(String about, String message, Action... actions) {
        Notice shown = notices.get(about);
        if (shown != null && shown.message.getText().equals(message)) {
            return;
        }
        hide(about);
        Notice notice = new Notice(message, actions.length > 0,
            actions.length > 0 ? actions : new Action[] {KeyBindings.action("Hide", null, () -> hide(about))});
        notices.put(about, notice);
        add(notice);
        place();
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
            place();
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
        private final boolean asks;                           // what to do

        Notice(String text, boolean asks, Action... actions) {
            super(new BorderLayout(12, 0));
            this.asks = asks;
            message = new JLabel(text, new WarningIcon(), JLabel.LEADING);
            message.setName("notice");
            message.setToolTipText(text);                     // a narrow window cuts it
            setBorder(BorderFactory.createEmptyBorder(1, 10, 1, 10));
            add(message, BorderLayout.CENTER);
            JPanel buttons = new JPanel(new FlowLayout(FlowLayout.TRAILING, 6, 0));
            buttons.setOpaque(false);
            for (Action action : actions) {
                buttons.add(new JButton(action));
            }
            add(buttons, BorderLayout.EAST);
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
