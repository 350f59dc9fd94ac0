package simpleray.ui.widget;

import java.awt.event.ActionEvent;
import java.awt.event.KeyEvent;
import javax.swing.AbstractAction;
import javax.swing.Action;
import javax.swing.JComponent;
import javax.swing.KeyStroke;

/** Makes actions and binds them to keys. */
public final class KeyBindings {
    private KeyBindings() {
    }

    /**
     * {@return whether a key types a character} Swing offers a pressed key to the window's menus before it types anything: a component with
     * text must say that it took the key.
     *
     * @param e the key
     */
    public static boolean isCharacter(KeyEvent e) {
        boolean command = e.isMetaDown() || (e.isControlDown() || e.isAltDown()) && !e.isAltGraphDown();
        return !command && e.getKeyChar() != KeyEvent.CHAR_UNDEFINED && !Character.isISOControl(e.getKeyChar());
    }

    /**
     * {@return an action for a menu}
     *
     * @param name the text of its item
     * @param key its key as {@link KeyStroke#getKeyStroke(String)} reads it; null for none
     * @param task what it does
     */
    public static Action action(String name, String key, Runnable task) {
        Action action = new AbstractAction(name) {
            private static final long serialVersionUID = 1L;

            @Override
            public void actionPerformed(ActionEvent e) {
                task.run();
            }
        };
        action.putValue(Action.ACCELERATOR_KEY, key == null ? null : KeyStroke.getKeyStroke(key));
        return action;
    }

    /**
     * Binds a key to a task.
     *
     * @param component the component
     * @param condition when the key works, a constant of {@link JComponent}
     * @param key the key as {@link KeyStroke#getKeyStroke(String)} reads it
     * @param task what it does
     */
    public static void bind(JComponent component, int condition, String key, Runnable task) {
        bind(component, condition, key, action(key, null, task));
    }

    /**
     * Binds a key to an action.
     *
     * @param component the component
     * @param condition when the key works, a constant of {@link JComponent}
     * @param key the key as {@link KeyStroke#getKeyStroke(String)} reads it
     * @param action the action
     */
    public static void bind(JComponent component, int condition, String key, Action action) {
        component.getInputMap(condition).put(KeyStroke.getKeyStroke(key), action.getValue(Action.NAME));
        component.getActionMap().put(action.getValue(Action.NAME), action);
    }
}
