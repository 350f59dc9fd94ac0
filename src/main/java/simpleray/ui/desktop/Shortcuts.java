package simpleray.ui.desktop;

import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.util.ArrayList;
import java.util.List;
import javax.swing.AbstractButton;
import javax.swing.Action;
import javax.swing.JComponent;
import javax.swing.JFrame;
import javax.swing.JMenu;
import javax.swing.JMenuBar;
import javax.swing.JMenuItem;
import javax.swing.KeyStroke;
import javax.swing.MenuElement;

/** All keys of a window, taken from its menus, so that none can be forgotten; and the gestures of the mouse. */
public final class Shortcuts {
    /** The property of an action for its second key; the menu shows the first. */
    static final String ALSO = "simpleray.also";

    /** Gestures of the mouse, and keys that work on the picture alone; no menu shows these. */
    public static final List<Shortcut> GESTURES = List.of(
        new Shortcut("Picture", "Tell a pixel's values", "Point at it"),
        new Shortcut("Picture", "Tell a pixel's story", "Click"),
        new Shortcut("Picture", "Show a menu about a pixel", "Right button"),
        new Shortcut("Picture", "Zoom about the cursor", "Ctrl+Wheel"),
        new Shortcut("Picture", "Scroll", "Wheel, Shift+Wheel, Ctrl+Arrows"),
        new Shortcut("Picture", "Render a rectangle first", "Shift+Drag"),
        new Shortcut("Picture", "Let go of the rectangle", "Escape, Shift+Click"),
        new Shortcut("Picture", "Take the pixel along, while its rays are shown", "Drag its frame, Ctrl+Drag"),
        new Shortcut("Camera", "Orbit", "Drag"),
        new Shortcut("Camera", "Pan", "Middle button, Space+Drag"),
        new Shortcut("Camera", "Go nearer, go away", "Wheel"),
        new Shortcut("Rays", "Go round them", "Drag, Arrows"),
        new Shortcut("Rays", "Pan the rays", "Right or middle button"),
        new Shortcut("Rays", "Go nearer to the rays, go away", "Wheel, Page Up, Page Down"),
        new Shortcut("Rays", "Go back to where all of them are seen", "Home"),
        new Shortcut("Rays", "Select a ray, and its line of the story", "Click"),
        new Shortcut("Story", "Mark what a line tells about", "Click, Arrows"),
        new Shortcut("Story", "Show the object or light in the text", "Click on its line, Enter"),
        new Shortcut("Problems", "Go to its place in the text", "Click, Enter"),
        new Shortcut("Text", "Save the scene", "Ctrl+S"),
        new Shortcut("Text", "Find the next, the one before", "F3, Shift+F3"),
        new Shortcut("Text", "Tell what a number is", "Point at it"),
        new Shortcut("Text", "Change a number", "Alt+Drag, Alt+Wheel"),
        new Shortcut("Text", "Pick the colour that a number is of", "Alt+Click"),
        new Shortcut("Wipe", "Move the divider", "Drag"),
        new Shortcut("Wipe", "Move the divider by 1 %, by 10 %", "Left, Right; with Shift"),
        new Shortcut("Wipe", "Move the divider to the edge", "Home, End"),
        new Shortcut("Window", "Open a scene", "Drop its file"));

    private Shortcuts() {
    }

    /**
     * A command and how it is given.
     *
     * @param place the menu it is in, or what the gesture is made on
     * @param command what it does
     * @param keys the keys or the gesture
     */
    public record Shortcut(String place, String command, String keys) {
    }

    /**
     * {@return the keys of all items of the menus, in their order}
     *
     * @param bar the menus
     */
    public static List<Shortcut> of(JMenuBar bar) {
        List<Shortcut> all = new ArrayList<>();
        for (MenuElement menu : bar.getSubElements()) {
            collect(menu, ((AbstractButton) menu.getComponent()).getText(), all);
        }
        return all;
    }

    /** Gives an action of a window's menus a second key. */
    static void addKey(JFrame frame, Action action, String key) {
        KeyStroke stroke = KeyStroke.getKeyStroke(key);
        action.putValue(ALSO, stroke);
        frame.getRootPane().getInputMap(JComponent.WHEN_IN_FOCUSED_WINDOW).put(stroke, action);
        frame.getRootPane().getActionMap().put(action, action);
    }

    private static void collect(MenuElement element, String menu, List<Shortcut> all) {
        if (element instanceof JMenuItem item && !(item instanceof JMenu) && item.getAccelerator() != null) {
            all.add(new Shortcut(menu, item.getText(), keys(item)));
        }
        for (MenuElement part : element.getSubElements()) {
            collect(part, part instanceof JMenu inner ? menu + " > " + inner.getText() : menu, all);
        }
    }

    /**
     * {@return what an item does and by which keys, for a tool tip}
     *
     * @param item the item
     */
    public static String tip(JMenuItem item) {
        return item.getText() + (item.getAccelerator() == null ? "" : " (" + keys(item) + ')');
    }

    private static String keys(JMenuItem item) {
        Action action = item.getAction();
        boolean more = action != null && action.getValue(ALSO) != null;
        return name(item.getAccelerator()) + (more ? ", " + name((KeyStroke) action.getValue(ALSO)) : "");
    }

    /** {@return a key as a keyboard names it} */
    static String name(KeyStroke key) {
        if (key.getKeyCode() == KeyEvent.VK_UNDEFINED) {
            return Character.toString(key.getKeyChar());
        }
        String with = InputEvent.getModifiersExText(key.getModifiers());
        return (with.isEmpty() ? "" : with + "+") + KeyEvent.getKeyText(key.getKeyCode());
    }
}
