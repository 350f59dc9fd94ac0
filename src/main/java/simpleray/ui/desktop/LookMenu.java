package simpleray.ui.desktop;

import com.formdev.flatlaf.FlatLaf;
import java.awt.event.KeyEvent;
import java.awt.event.WindowAdapter;
import java.awt.event.WindowEvent;
import javax.swing.ButtonGroup;
import javax.swing.JFrame;
import javax.swing.JMenu;
import javax.swing.JRadioButtonMenuItem;
import javax.swing.SwingUtilities;
import simpleray.ui.widget.Look;

/** View &gt; Look: shows a choice at once and remembers it; follows the desktop's look whenever the window gets the focus. */
final class LookMenu {
    private final JFrame frame;
    private final Runnable changed;                           // follows another look where Swing does not
    private final Preferences preferences;
    private final ButtonGroup one = new ButtonGroup();
    private final JMenu menu = new JMenu("Look");
    private Look look;
    private volatile Thread asking;                           // the desktop; null if nobody has

    LookMenu(JFrame frame, Preferences preferences, Look look, Runnable changed) {
        this.frame = frame;
        this.changed = changed;
        this.preferences = preferences;
        this.look = look;
        menu.setMnemonic(KeyEvent.VK_L);
        add(Look.LIGHT, "Light", KeyEvent.VK_L);
        add(Look.DARK, "Dark", KeyEvent.VK_D);
        add(Look.SYSTEM, "System", KeyEvent.VK_S);
        frame.addWindowListener(new WindowAdapter() {
            @Override
            public void windowActivated(WindowEvent e) {
                if (LookMenu.this.look == Look.SYSTEM) {
                    show();
                }
            }
        });
    }

    JMenu menu() {
        return menu;
    }

    /** Asks no more. */
    void close() {
        if (asking != null) {
            asking.interrupt();
        }
    }

    /** Waits until nobody asks; not for the event thread. */
    void await() throws InterruptedException {
        if (asking != null) {
            asking.join();
        }
    }

    private void add(Look choice, String name, int mnemonic) {
        JRadioButtonMenuItem item = new JRadioButtonMenuItem(name, choice == look);
        item.setMnemonic(mnemonic);
        item.addActionListener(e -> choose(choice));
        one.add(item);
        menu.add(item);
    }

    private void choose(Look choice) {
        look = choice;
        preferences.setLook(choice);
        show();
    }

    /** Asks the desktop, where it must be asked, on a thread of its own. */
    private void show() {
        if (look == Look.SYSTEM) {
            if (asking != null && asking.isAlive()) {
                return;                                       // its answer will do
            }
            asking = new Thread(() -> {
                boolean dark = Look.SYSTEM.isDark();
                SwingUtilities.invokeLater(() -> {
                    if (look == Look.SYSTEM) {
                        install(dark);
                    }
                });
            }, "simpleray-look");
            asking.setDaemon(true);
            asking.start();
        } else {
            install(look.isDark());
        }
    }

    private void install(boolean dark) {
        if (frame.isDisplayable() && dark != FlatLaf.isLafDark()) {
            Look.install(dark);
            changed.run();
        }
    }
}
