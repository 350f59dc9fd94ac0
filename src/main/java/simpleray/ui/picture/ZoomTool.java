package simpleray.ui.picture;

import java.awt.Point;
import java.awt.event.ComponentAdapter;
import java.awt.event.ComponentEvent;
import java.awt.event.InputEvent;
import java.awt.event.MouseWheelEvent;
import java.util.Locale;
import java.util.function.Supplier;
import javax.swing.Action;
import javax.swing.ButtonGroup;
import javax.swing.JCheckBoxMenuItem;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JMenu;
import javax.swing.JRadioButtonMenuItem;
import javax.swing.JScrollPane;
import javax.swing.KeyStroke;
import javax.swing.SwingUtilities;
import simpleray.ui.widget.KeyBindings;

/** Zooms the picture: by the wheel with Ctrl about the cursor, by keys and the View menu about the middle; and shows its scale. */
public final class ZoomTool {
    /** Other keyboards and the number pad have other keys; the menu shows the first. */
    private static final String[] IN = {"control PLUS", "control EQUALS", "control shift EQUALS", "control shift PLUS", "control ADD"};
    private static final String[] OUT = {"control MINUS", "control SUBTRACT"};
    private static final String[] ACTUAL = {"control 0", "control NUMPAD0"};

    private final ZoomedComponent picture;
    private double turned;                                    // notches of the wheel that have not made a step yet

    /**
     * Adds the wheel to a picture.
     *
     * @param picture the picture
     */
    public ZoomTool(ZoomedComponent picture) {
        this.picture = picture;
        picture.addMouseWheelListener(this::wheel);
    }

    /**
     * Adds the zoom's items to a menu.
     *
     * @param menu the View menu
     */
    public void addTo(JMenu menu) {
        ButtonGroup one = new ButtonGroup();
        JRadioButtonMenuItem actual = new JRadioButtonMenuItem(action("Actual Size", () -> Zoom.ACTUAL, ACTUAL));
        JRadioButtonMenuItem fit = new JRadioButtonMenuItem(action("Fit to Window", () -> Zoom.FIT, "F"));
        one.add(actual);
        one.add(fit);
        fit.setSelected(true);
        picture.addPropertyChangeListener(ZoomedComponent.ZOOM, e -> {
            one.clearSelection();                             // at another scale it is neither
            actual.setSelected(picture.zoom().equals(Zoom.ACTUAL));
            fit.setSelected(picture.zoom().fitted());
        });
        scrollWithControl();
        menu.add(actual);
        menu.add(fit);
        menu.add(action("Zoom In", () -> picture.zoom().in(picture.placed().scale()), IN));
        JCheckBoxMenuItem wheel = new JCheckBoxMenuItem("Wheel Zooms");
        wheel.addActionListener(e -> picture.setWheelZooms(wheel.isSelected()));
        menu.add(action("Zoom Out", () -> picture.zoom().out(picture.placed().scale()), OUT));
        menu.add(wheel);
    }

    /**
     * {@return a label that says how large a picture is shown}
     *
     * @param picture the picture
     */
    public static JLabel label(ZoomedComponent picture) {
        JLabel label = new JLabel();
        label.setName("zoom");
        label.getAccessibleContext().setAccessibleDescription("Zoom");
        Runnable show = () -> label.setText(Zoom.percent(picture.shownScale()));
        picture.addPropertyChangeListener(ZoomedComponent.ZOOM, e -> show.run());
        picture.addComponentListener(new ComponentAdapter() {
            @Override
            public void componentResized(ComponentEvent e) {
                show.run();                                   // a fitted picture grows with the window
            }
        });
        show.run();
        return label;
    }

    /** The arrows alone move the camera. */
    private void scrollWithControl() {
        JScrollPane pane = (JScrollPane) SwingUtilities.getAncestorOfClass(JScrollPane.class, picture);
        for (String way : new String[] {"Left", "Right", "Up", "Down"}) {
            pane.getInputMap(JComponent.WHEN_ANCESTOR_OF_FOCUSED_COMPONENT)
                .put(KeyStroke.getKeyStroke("control " + way.toUpperCase(Locale.ROOT)), "unitScroll" + way);
        }
    }

    private Action action(String name, Supplier<Zoom> other, String... keys) {
        Action action = KeyBindings.action(name, keys[0], () -> picture.setZoom(other.get(), null));
        for (int i = 1; i < keys.length; i++) {
            KeyBindings.bind(picture, JComponent.WHEN_IN_FOCUSED_WINDOW, keys[i], action);
        }
        return action;
    }

    private void wheel(MouseWheelEvent e) {
        if ((e.getModifiersEx() & InputEvent.CTRL_DOWN_MASK) == 0 && !(picture.wheelZooms() && e.getModifiersEx() == 0)) {
            return;
        }
        e.consume();
        turned += e.getPreciseWheelRotation();                // a touchpad needs many small turns for a step
        Point about = e.getPoint();
        while (Math.abs(turned) >= 1) {
            double now = picture.placed().scale();
            Point before = picture.getLocation();
            picture.setZoom(turned < 0 ? picture.zoom().in(now) : picture.zoom().out(now), about);
            about.translate(before.x - picture.getX(), before.y - picture.getY());
            turned -= Math.signum(turned);
        }
    }
}
