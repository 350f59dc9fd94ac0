package simpleray.ui;

import java.awt.event.ActionEvent;
import java.awt.event.KeyEvent;
import javax.swing.AbstractAction;
import javax.swing.JComponent;
import javax.swing.KeyStroke;

/** What fields for text have in common: keys that type something are theirs, though the window has them for shortcuts. */
final class KeyBindings {
    private KeyBindings() {
    }

    /**
     * {@return whether a key types a character} Swing offers a pressed key to the window's menus before it types anything: whoever has
     * a text must say that it took the key.
     */
    static boolean isCharacter(KeyEvent e) {
        boolean command = e.isMetaDown() || (e.isControlDown() || e.isAltDown()) && !e.isAltGraphDown();
        return !command && e.getKeyChar() != KeyEvent.CHAR_UNDEFINED && !Character.isISOControl(e.getKeyChar());
    }

    /** Has a key do something wherever in a component the keys are. */
    static void bind(JComponent component, int condition, String key, Runnable task) {
        component.getInputMap(condition).put(KeyStroke.getKeyStroke(key), key);
        component.getActionMap().put(key, new AbstractAction() {
            private static final long serialVersionUID = 1L;

            @Override
            public void actionPerformed(ActionEvent e) {
                task.run();
            }
        });
    }
}
