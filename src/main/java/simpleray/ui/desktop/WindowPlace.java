package simpleray.ui.desktop;

import java.awt.Dimension;
import java.awt.Frame;
import java.awt.GraphicsDevice;
import java.awt.GraphicsEnvironment;
import java.awt.Rectangle;
import java.awt.event.ComponentAdapter;
import java.awt.event.ComponentEvent;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Collectors;
import javax.swing.JFrame;

/** Puts a window where it was, if it can be seen there, or else makes it as large as its parts need; and notes where it is at the end. */
final class WindowPlace {
    /** The piece of a window's upper edge that must be on a screen, so that it can be taken hold of. */
    private static final int GRIP_WIDTH = 100;
    private static final int GRIP_HEIGHT = 24;
    /** How large a window is at first, at least. */
    private static final Dimension MIN = new Dimension(760, 560);
    /** The share of the screen that it takes at first, of a screen up to some size. */
    private static final double SHARE = 0.8;
    private static final Dimension LARGE = new Dimension(1600, 1200);

    private final JFrame frame;
    private final Preferences preferences;
    private Rectangle normal;                                 // not that of a window that fills the screen

    WindowPlace(JFrame frame, Preferences preferences) {
        this.frame = frame;
        this.preferences = preferences;
        Rectangle place = seen(preferences.place(), screens());
        if (place == null) {
            Dimension needed = frame.getPreferredSize();
            Dimension screen = frame.getToolkit().getScreenSize();
            frame.setSize(side(screen.width, LARGE.width, MIN.width, needed.width),
                side(screen.height, LARGE.height, MIN.height, needed.height));
            frame.setLocationRelativeTo(null);                // AWT often does not learn where an X11 desktop puts it: menus open elsewhere
        } else {
            frame.setBounds(place);
        }
        frame.addNotify();                                    // of that size: late word of another one would be taken for the user's wish
        if (preferences.isMaximised()) {
            frame.setExtendedState(Frame.MAXIMIZED_BOTH);
        }
        normal = frame.getBounds();
        ComponentAdapter listener = new ComponentAdapter() {
            @Override
            public void componentMoved(ComponentEvent e) {
                note();
            }

            @Override
            public void componentResized(ComponentEvent e) {
                note();
            }
        };
        frame.addComponentListener(listener);
    }

    private static int side(int screen, int large, int least, int needed) {
        return Math.min(screen, Math.max((int) (SHARE * Math.min(screen, large)), Math.max(least, needed)));
    }

    private void note() {
        if (frame.getExtendedState() == Frame.NORMAL) {
            normal = frame.getBounds();
        }
    }

    /** Notes where the window is. */
    void remember() {
        note();
        preferences.setPlace(normal, (frame.getExtendedState() & Frame.MAXIMIZED_BOTH) == Frame.MAXIMIZED_BOTH);
    }

    private static List<Rectangle> screens() {
        return Arrays.stream(GraphicsEnvironment.getLocalGraphicsEnvironment().getScreenDevices())
            .map(GraphicsDevice::getDefaultConfiguration).map(c -> c.getBounds()).collect(Collectors.toList());
    }

    /** {@return the place, made no larger than the screen that its upper edge is on; null if no screen shows that edge} */
    static Rectangle seen(Rectangle place, List<Rectangle> screens) {
        if (place == null) {
            return null;
        }
        for (Rectangle screen : screens) {
            Rectangle grip = screen.intersection(new Rectangle(place.x, place.y, place.width, GRIP_HEIGHT));
            if (grip.width >= Math.min(GRIP_WIDTH, place.width) && grip.height >= GRIP_HEIGHT) {
                return new Rectangle(place.x, place.y, Math.min(place.width, screen.width), Math.min(place.height, screen.height));
            }
        }
        return null;
    }
}
