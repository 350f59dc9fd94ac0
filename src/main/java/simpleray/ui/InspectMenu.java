package simpleray.ui;

import java.awt.event.KeyEvent;
import javax.swing.JMenu;

/** The menu about single pixels. */
final class InspectMenu {
    private InspectMenu() {
    }

    static JMenu of(Inspector inspector) {
        JMenu menu = new JMenu("Inspect");
        menu.setMnemonic(KeyEvent.VK_I);
        menu.add(ViewerMenus.action("Story of the Pixel", "I", inspector::openStory));
        menu.add(ViewerMenus.action("Copy Story", "control shift I", inspector::copy));
        menu.add(ViewerMenus.action("Close Story", "shift I", inspector::closeStory));
        menu.addSeparator();
        menu.add(ViewerMenus.action("Pixel Cursor Left", "alt LEFT", () -> inspector.move(-1, 0)));
        menu.add(ViewerMenus.action("Pixel Cursor Right", "alt RIGHT", () -> inspector.move(1, 0)));
        menu.add(ViewerMenus.action("Pixel Cursor Up", "alt UP", () -> inspector.move(0, -1)));
        menu.add(ViewerMenus.action("Pixel Cursor Down", "alt DOWN", () -> inspector.move(0, 1)));
        return menu;
    }
}
