package simpleray.ui.picture;

import java.awt.FlowLayout;
import java.util.ArrayList;
import java.util.List;
import javax.swing.BorderFactory;
import javax.swing.JButton;
import javax.swing.JLabel;
import javax.swing.JPanel;

/** The line at the picture's foot: it tells how to move the camera until someone does, and then how to go back or to keep the view. */
final class CameraLine extends JPanel {
    private static final long serialVersionUID = 1L;
    private static final int GAP = 8;
    private static final List<String> GESTURES = List.of("Click: why this colour", "Drag: orbit", "Middle button: pan", "Wheel: nearer",
        "F1: help");

    private final JLabel text = new JLabel(joined(GESTURES));
    private List<String> told = GESTURES;                     // what the text says where there is room
    private List<String> others;                              // the gestures of what is in the picture's place; null for the picture's
    private boolean known;
    private boolean blank;                                    // there is no picture
    private final JButton home;
    private final JButton save;
    private final JButton key;                                // in place of that, if the camera has keys

    CameraLine(Runnable home, Runnable save, Runnable key) {
        super(new FlowLayout(FlowLayout.LEADING, GAP, 0));
        setName("camera line");
        setBorder(BorderFactory.createEmptyBorder(2, 2, 2, 2));
        text.setName("gestures");
        this.home = button("Home", "Back to the Scene's Camera (Home)", home);
        this.save = button("Save in Scene", "Save View in Scene (Ctrl+Shift+V)", save);
        this.key = button("Set Camera Key", "Set Camera Key (K)", key);
        add(text);
        add(this.home);
        add(this.save);
        add(this.key);
        setPreferredSize(getPreferredSize());                 // with the buttons, so that it stays as high
        show(false, false, false);
    }

    private static JButton button(String name, String tip, Runnable task) {
        JButton button = new JButton(name);
        button.setToolTipText(tip);
        button.setFocusable(false);                           // the picture keeps the keys
        button.addActionListener(e -> task.run());
        return button;
    }

    void show(boolean moved, boolean known, boolean keyed) {
        this.known = known;
        home.setVisible(moved);
        save.setVisible(moved && !keyed);
        key.setVisible(moved && keyed);
        tell();
    }

    /** Tells other gestures than the picture's; null for those. */
    void setGestures(List<String> other) {
        others = other;
        tell();
    }

    /** Tells nothing of a picture while there is none. */
    void setBlank(boolean none) {
        if (blank != none) {
            blank = none;
            tell();
        }
    }

    private void tell() {
        told = blank ? GESTURES.subList(GESTURES.size() - 1, GESTURES.size()) : home.isVisible() ? List.of("Camera moved:") : others != null ? others : known ? List.of() : GESTURES;
        revalidate();
        doLayout();
    }

    /** Leaves out whole gestures from the last but one on, until the line has room: the last one leads to all. */
    @Override
    public void doLayout() {
        int room = getWidth() - getInsets().left - getInsets().right - 2 * GAP;
        for (JButton button : List.of(home, save, key)) {
            room -= button.isVisible() ? button.getPreferredSize().width + GAP : 0;
        }
        List<String> shown = new ArrayList<>(told);
        while (!shown.isEmpty() && text.getFontMetrics(text.getFont()).stringWidth(joined(shown)) > room) {
            shown.remove(Math.max(0, shown.size() - 2));
        }
        text.setText(shown.isEmpty() ? " " : joined(shown));
        text.setToolTipText(shown.size() == told.size() ? null : joined(told));
        super.doLayout();
    }

    private static String joined(List<String> gestures) {
        return String.join("   ", gestures);
    }
}
