package simpleray.ui.desktop;

import java.awt.Image;
import java.awt.Window;
import java.net.URL;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import javax.swing.Icon;
import javax.swing.ImageIcon;
import javax.swing.SwingUtilities;

/** The program's icon, which the program rendered itself. */
public final class ProgramIcon {
    private static final URL PICTURE = ProgramIcon.class.getResource("/simpleray/icon.png");
    private static final Integer[] SIDES = {16, 24, 32, 48, 64, 128, 256};
    private static final int LARGE = 96;

    private ProgramIcon() {
    }

    /** Gives a window the icon, in the sizes that desktops ask for. They are made on another thread: the window need not wait for them. {@return it} */
    static Thread set(Window window) {
        Thread making = new Thread(() -> {
            List<Image> all = Sizes.ALL;
            SwingUtilities.invokeLater(() -> {
                if (window.isDisplayable()) {
                    window.setIconImages(all);
                }
            });
        }, "simpleray-icon");
        making.setDaemon(true);
        making.start();
        return making;
    }

    /** {@return the icon for a dialog} */
    public static Icon large() {
        return scaled(LARGE);
    }

    private static ImageIcon scaled(int side) {
        return new ImageIcon(new ImageIcon(PICTURE).getImage().getScaledInstance(side, side, Image.SCALE_SMOOTH));
    }

    /** Made once, when the first window asks. */
    private static final class Sizes {
        static final List<Image> ALL = Stream.of(SIDES).map(side -> scaled(side).getImage()).collect(Collectors.toList());
    }
}
