package simpleray.ui.widget;

import javax.swing.InputMap;
import javax.swing.JComponent;
import javax.swing.JMenuBar;
import javax.swing.JMenuItem;
import javax.swing.KeyStroke;
import javax.swing.MenuElement;
import javax.swing.MenuSelectionManager;
import javax.swing.event.ChangeListener;

/**
 * Has the keys without a modifier that items of a menu bar have rest while a menu is open, so that arrow keys walk through all menus, Space
 * chooses and Escape closes. Swing gives such a key to an item that is on the screen before it gives it to its menu.
 */
public final class MenuKeys {
    private static final String REST = "simpleray.rest";

    private MenuKeys() {
    }

    /**
     * Does so for a menu bar from now on, and for items that it gets later.
     *
     * @param bar the menu bar, whose items are walked when a menu opens or closes
     */
    public static void restWhileOpen(JMenuBar bar) {
        MenuSelectionManager menus = MenuSelectionManager.defaultManager();
        boolean[] open = new boolean[1];
        ChangeListener listener = e -> {
            boolean now = menus.getSelectedPath().length > 0;   // this bar's or a menu on the picture
            if (now != open[0]) {
                open[0] = now;
                setResting(bar, now);
            }
        };
        bar.addHierarchyListener(e -> {                       // the manager outlives the window
            menus.removeChangeListener(listener);
            if (bar.isDisplayable()) {
                menus.addChangeListener(listener);
            }
        });
    }

    private static void setResting(MenuElement element, boolean rest) {
        if (element instanceof JMenuItem item && item.getAccelerator() != null && item.getAccelerator().getModifiers() == 0) {
            InputMap own = item.getInputMap(JComponent.WHEN_IN_FOCUSED_WINDOW);
            KeyStroke key = item.getAccelerator();
            if (rest) {
                own.put(key, REST);                           // no action has this name
            } else {
                own.remove(key);
            }
        }
        for (MenuElement part : element.getSubElements()) {
            setResting(part, rest);
        }
    }
}
