package simpleray.ui;

import java.awt.Graphics;
import java.awt.Image;
import javax.swing.Timer;
import simpleray.ui.desktop.ProgramIcon;

/**
 * The training run for the archive of classes (class data sharing) that the script {@code simpleray} makes: a window that is not shown renders,
 * is painted and closes, and so loads the classes that a window needs.
 */
final class CdsTrainingRun {
    /** The system property that asks for it. */
    static final String PROPERTY = "simpleray.rehearsal";
    private static final int LOOK = 20;                       // milliseconds

    private CdsTrainingRun() {
    }

    static boolean isAskedFor() {
        return Boolean.getBoolean(PROPERTY);
    }

    /** Paints a window that is not shown once its picture is finished, and closes it. For the event thread. */
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
