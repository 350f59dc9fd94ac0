package simpleray.ui;

import java.util.Arrays;
import java.util.List;
import java.util.stream.Stream;
import javax.swing.AbstractButton;
import javax.swing.BorderFactory;
import javax.swing.JButton;
import javax.swing.JCheckBoxMenuItem;
import javax.swing.JMenuBar;
import javax.swing.JMenuItem;
import javax.swing.JRadioButtonMenuItem;
import javax.swing.JToggleButton;
import javax.swing.JToolBar;
import javax.swing.MenuElement;
import simpleray.ui.desktop.Shortcuts;

/** A slim row of buttons for what is used most. Each is an item of the menus over again: it does the same, and can when that can. */
final class ToolBar extends JToolBar {
    private static final long serialVersionUID = 1L;
    /** The items, and what their buttons say; a blank is a gap. */
    private static final List<String[]> BUTTONS = List.of(new String[] {"Open\u2026", "Open"}, new String[] {"Reload", "Reload"},
        new String[] {"Save Picture As\u2026", "Save"}, new String[0], new String[] {"Original Scene", "Original"},
        new String[] {"With Lighting", "Lighting"}, new String[] {"With Shadows and Reflections", "Final"}, new String[0],
        new String[] {"Story of the Pixel", "Story"}, new String[] {"Rays", "Rays"}, new String[] {"Scene Text", "Text"}, new String[0],
        new String[] {"Side by Side", "Compare"}, new String[] {"Pause", "Pause"}, new String[] {"Play Film", "Play"});

    ToolBar(JMenuBar menus) {
        setName("tools");
        getAccessibleContext().setAccessibleName("Tools");
        setFloatable(false);
        setBorder(BorderFactory.createEmptyBorder(1, 4, 1, 4));
        for (String[] button : BUTTONS) {
            if (button.length == 0) {
                addSeparator();
            } else {
                add(button(item(menus, button[0]), button[1]));
            }
        }
    }

    private static AbstractButton button(JMenuItem item, String text) {
        boolean stays = item instanceof JCheckBoxMenuItem || item instanceof JRadioButtonMenuItem;
        AbstractButton button = stays ? new JToggleButton(text, item.isSelected()) : new JButton(text);
        button.setFocusable(false);                           // keys stay with the picture or the text
        button.setToolTipText(Shortcuts.tip(item));
        button.setEnabled(item.isEnabled());
        item.addPropertyChangeListener("enabled", e -> button.setEnabled(item.isEnabled()));
        item.addItemListener(e -> button.setSelected(item.isSelected()));
        button.addActionListener(e -> {
            item.doClick(0);
            button.setSelected(item.isSelected());            // that of a stage stays pressed
        });
        return button;
    }

    /** {@return the item of the menus that says something} */
    static JMenuItem item(JMenuBar menus, String text) {
        return items(menus).filter(item -> item.getText().equals(text)).findFirst().orElseThrow();
    }

    private static Stream<JMenuItem> items(MenuElement menu) {
        return Arrays.stream(menu.getSubElements())
            .flatMap(part -> Stream.concat(part instanceof JMenuItem item ? Stream.of(item) : Stream.empty(), items(part)));
    }
}
