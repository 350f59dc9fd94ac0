package simpleray.ui;

import java.awt.AWTError;
import java.awt.GraphicsEnvironment;
import java.awt.HeadlessException;
import java.io.File;
import java.lang.reflect.InvocationTargetException;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.atomic.AtomicReference;
import javax.swing.SwingUtilities;
import simpleray.render.RenderRequest;
import simpleray.ui.desktop.Preferences;
import simpleray.ui.desktop.PreferencesFile;
import simpleray.ui.file.SceneSource;
import simpleray.ui.widget.Look;

/** Opens the window. */
public final class Viewer {
    private Viewer() {
    }

    /**
     * Looks for a display.
     *
     * @return whether there is one on which a window can be opened
     * @throws LinkageError if Java lacks what it needs for windows
     */
    public static boolean hasDisplay() {
        try {
            return !GraphicsEnvironment.isHeadless()
                && GraphicsEnvironment.getLocalGraphicsEnvironment().getScreenDevices().length > 0;
        } catch (AWTError | HeadlessException e) {    // no such display
            return false;
        }
    }

    /**
     * Opens the window with the look that was chosen last. Not for the event thread.
     *
     * @param source the scene
     * @param request what is asked for beside the scene file
     */
    public static void view(SceneSource source, RenderRequest request) {
        view(source, request, null);
    }

    /**
     * Opens the window, and returns when it was closed and all its threads have ended. Not for the event thread.
     *
     * @param source the scene
     * @param request what is asked for beside the scene file
     * @param asked the look; null for the one that was chosen last
     */
    public static void view(SceneSource source, RenderRequest request, Look asked) {
        findHome();
        Preferences preferences = Preferences.load(PreferencesFile.find());
        Look look = asked == null ? preferences.look() : asked;
        boolean dark = look.isDark();
        CountDownLatch closed = new CountDownLatch(1);
        AtomicReference<ViewerFrame> frame = new AtomicReference<>();
        try {
            SwingUtilities.invokeAndWait(() -> {
                Look.install(dark);
                frame.set(new ViewerFrame(source, request, preferences, look, closed::countDown));
                if (CdsTrainingRun.isAskedFor()) {
                    CdsTrainingRun.begin(frame.get());
                } else {
                    frame.get().setVisible(true);
                }
            });
            closed.await();
            frame.get().await();
        } catch (InterruptedException e) {
            SwingUtilities.invokeLater(() -> frame.get().close());
            Thread.currentThread().interrupt();
        } catch (InvocationTargetException e) {
            throw new IllegalStateException("the window cannot be opened", e.getCause());
        }
    }

    /** Has Java's fonts, which keep a list in the user's home, make no folder {@code ?} for a user who is not in {@code /etc/passwd}. */
    private static void findHome() {
        if (!new File(System.getProperty("user.home")).isAbsolute()) {
            String home = System.getenv().getOrDefault("HOME", "");
            System.setProperty("user.home", new File(home).isAbsolute() ? home : "/dev/null");
        }
    }
}
