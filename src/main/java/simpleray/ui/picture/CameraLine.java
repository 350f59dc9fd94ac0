package simpleray.ui.picture;

import java.awt.FlowLayout;
import javax.swing.BorderFactory;
import javax.swing.JButton;
import javax.swing.JLabel;
import javax.swing.JPanel;

/** The line at the picture's foot: it tells how to move the camera until someone does, and then how to go back or to keep the view. */
final class CameraLine extends JPanel {
    private static final long serialVersionUID = 1L;
    private static final String GESTURES = "Click: why this colour   Drag: orbit   Middle button: pan   Wheel: nearer   F1: help";

    private final JLabel text = new JLabel(GESTURES);
    private final JButton home;
    private final JButton save;
    private final JButton key;                                // in place of that, if the camera has keys

    CameraLine(Runnable home, Runnable save, Runnable key) {
        super(new FlowLayout(FlowLayout.LEADING, 8, 0));
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
        text.setText(moved ? "Camera moved:" : known ? " " : GESTURES);
        home.setVisible(moved);
        save.setVisible(moved && !keyed);
        key.setVisible(moved && keyed);
    }
}
