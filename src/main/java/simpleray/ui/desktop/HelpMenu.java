package simpleray.ui.desktop;

import java.awt.event.KeyEvent;
import javax.swing.Action;
import javax.swing.JMenu;
import javax.swing.JOptionPane;
import simpleray.ui.picture.ViewerContext;
import simpleray.ui.widget.KeyBindings;

/** Help: what the mouse does, all keys, and which program this is. */
final class HelpMenu {
    private final ViewerContext window;
    private final JMenu menu = new JMenu("Help");

    HelpMenu(ViewerContext window) {
        this.window = window;
        menu.setMnemonic(KeyEvent.VK_H);
        Action shortcuts = KeyBindings.action("Mouse and Keys", "F1", () -> new ShortcutsDialog(window.frame()).setVisible(true));
        Shortcuts.addKey(window.frame(), shortcuts, "typed ?");
        menu.add(shortcuts);
        menu.add(KeyBindings.action("About SimpleRay", null, this::about));
    }

    JMenu menu() {
        return menu;
    }

    private void about() {
        JOptionPane.showMessageDialog(window.frame(), aboutText(), "About SimpleRay", JOptionPane.INFORMATION_MESSAGE, ProgramIcon.large());
    }

    /** {@return the version of the program, of Java and of the system} */
    static String aboutText() {
        String version = HelpMenu.class.getPackage().getImplementationVersion();
        return "SimpleRay " + (version == null ? "(not packaged)" : version)
            + "\nA ray tracer after the thesis \u201CRay Tracing Using Java\u201D (2014)\n\n"
            + "Java " + System.getProperty("java.version") + ", " + System.getProperty("java.vm.name") + "\n"
            + System.getProperty("os.name") + " " + System.getProperty("os.version") + ", " + System.getProperty("os.arch") + "\n\n"
            + "Licence: Apache-2.0";
    }
}
