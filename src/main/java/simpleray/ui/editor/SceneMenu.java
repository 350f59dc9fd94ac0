package simpleray.ui.editor;

import java.awt.event.KeyEvent;
import java.util.List;
import javax.swing.Action;
import javax.swing.JCheckBoxMenuItem;
import javax.swing.JMenu;
import simpleray.ui.widget.KeyBindings;

/** The Scene menu: the scene's text and its problems. */
public final class SceneMenu {
    private final JMenu menu = new JMenu("Scene");
    private final JCheckBoxMenuItem text;
    private final JMenu insert;
    private final SceneDocument document;
    private final Action saveAs;
    private final List<Action> all;

    /**
     * Creates the menu.
     *
     * @param document the scene's text
     * @param problems the problems
     */
    public SceneMenu(SceneDocument document, DiagnosticsPane problems) {
        this.document = document;
        menu.setMnemonic(KeyEvent.VK_N);
        text = new JCheckBoxMenuItem(KeyBindings.action("Scene Text", "control E", this::toggle));
        Action render = KeyBindings.action("Render Text", "control ENTER", document::render);
        Action save = KeyBindings.action("Save Scene", "control shift S", document::save);
        saveAs = KeyBindings.action("Save Scene As\u2026", "control alt S", document::saveAs);
        Action colour = KeyBindings.action("Choose Colour\u2026", "control shift P", document::chooseColour);
        Action find = KeyBindings.action("Find in Text\u2026", "control F", document::find);
        Action next = KeyBindings.action("Next Problem", "F4", () -> problems.step(1));
        Action previous = KeyBindings.action("Previous Problem", "shift F4", () -> problems.step(-1));
        JCheckBoxMenuItem renders = new JCheckBoxMenuItem("Render While Typing", true);
        renders.addActionListener(e -> document.setRenders(renders.isSelected()));
        menu.add(render);
        menu.add(renders);
        menu.add(save);
        menu.addSeparator();
        insert = new InsertMenu(document).menu();
        menu.add(insert);
        menu.add(colour);
        menu.addSeparator();
        menu.add(find);
        menu.add(next);
        menu.add(previous);
        all = List.of(text.getAction(), render, save, saveAs, colour, find, next, previous);
    }

    private void toggle() {
        document.toggle();
        text.setSelected(document.isShown());
    }

    /** {@return the action that begins a new scene} */
    public Action create() {
        return KeyBindings.action("New", "control N", document::create);
    }

    /** {@return the action that writes the text into another file} */
    public Action saveAs() {
        return saveAs;
    }

    /** {@return the menu} */
    public JMenu menu() {
        return menu;
    }

    /** {@return the item that shows and hides the text} */
    public JCheckBoxMenuItem text() {
        return text;
    }

    /**
     * Enables the items that can be used now, and ticks the text if it is shown.
     *
     * @param opened whether there is a scene
     */
    public void refresh(boolean opened) {
        all.forEach(action -> action.setEnabled(opened));
        insert.setEnabled(opened);
        text.setSelected(document.isShown());
    }
}
