package simpleray.ui.desktop;

import java.awt.event.KeyEvent;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import javax.swing.JMenu;
import javax.swing.JMenuItem;
import simpleray.ui.file.SceneSource;
import simpleray.ui.picture.ViewerContext;

/** File &gt; Open Recent. A file that is gone is found out when it is chosen: no disk is asked to show a menu. */
final class RecentMenu extends JMenu {
    private static final long serialVersionUID = 1L;
    private static final int LONGEST = 60;

    private final transient ViewerContext window;
    private final transient Preferences preferences;

    RecentMenu(ViewerContext window, Preferences preferences) {
        super("Open Recent");
        this.window = window;
        this.preferences = preferences;
        setMnemonic(KeyEvent.VK_R);
        refresh();
    }

    /** Lists the scenes that were opened until now. */
    void refresh() {
        removeAll();
        List<Path> files = preferences.recent();
        for (int i = 0; i < files.size(); i++) {
            Path file = files.get(i);
            int number = (i + 1) % 10;
            JMenuItem item = new JMenuItem(number + " " + shortened(file.toString()));
            item.setMnemonic(KeyEvent.VK_0 + number);
            item.setToolTipText(file.toString());
            item.addActionListener(e -> open(file));
            add(item);
        }
        addSeparator();
        JMenuItem clear = new JMenuItem("Clear");
        clear.setMnemonic(KeyEvent.VK_C);
        clear.addActionListener(e -> {
            preferences.clearRecent();
            refresh();
        });
        add(clear);
        setEnabled(!files.isEmpty());
    }

    /** Notes that a scene is opened, if it has a file. */
    void opened(SceneSource source) {
        if (source.path() != null && Files.isRegularFile(source.path())) {
            preferences.opened(source.path());
            refresh();
        }
    }

    /** Opens one of them, or says that it is gone. */
    void open(Path file) {
        if (Files.exists(file)) {
            window.open(SceneSource.file(file));
        } else {
            preferences.forget(file);
            refresh();
            window.say(file + " is not there any more");
        }
    }

    private static String shortened(String path) {
        return path.length() <= LONGEST ? path : "\u2026" + path.substring(path.length() - LONGEST + 1);
    }
}
