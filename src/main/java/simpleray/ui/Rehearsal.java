package simpleray.ui;

import java.awt.Graphics;
import java.awt.Image;
import javax.swing.Timer;

/**
 * A start of the window that nobody sees, by which the script {@code simpleray} finds out the classes it needs: the window is made,
 * renders, is painted and closes.
 */
final class Rehearsal {
    /** The system property that asks for it. */
    static final String PROPERTY = "simpleray.rehearsal";
    private static final int LOOK = 20;                       // milliseconds

    private Rehearsal() {
    }

    static boolean isAskedFor() {
        return Boolean.getBoolean(PROPERTY);
    }

    /** Closes a window that is not shown when its picture is there; for the event thread. */
    static void begin(ViewerFrame frame) {
        Timer look = new Timer(LOOK, null);
        look.addActionListener(e -> {
            if (!frame.picture().isBusy()) {
                look.stop();
                Image screen = frame.createVolatileImage(frame.getWidth(), frame.getHeight());   // painted as the screen is
                Graphics g = screen.getGraphics();
                frame.getRootPane().paint(g);
                g.dispose();
                ProgramIcon.large();                          // another thread makes those that a window shows
                frame.close();
            }
        });
        look.start();
    }
}
