package simpleray.ui;

import com.formdev.flatlaf.FlatLightLaf;
import java.awt.AWTError;
import java.awt.GraphicsEnvironment;
import java.awt.HeadlessException;
import java.lang.reflect.InvocationTargetException;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.atomic.AtomicReference;
import javax.swing.SwingUtilities;
import simpleray.render.RenderRequest;

/** Opens the window. */
public final class Viewer {
    private Viewer() {
    }

    /** {@return whether there is a display on which a window can be opened} */
    public static boolean hasDisplay() {
        try {
            return !GraphicsEnvironment.isHeadless()
                && GraphicsEnvironment.getLocalGraphicsEnvironment().getScreenDevices().length > 0;
        } catch (AWTError | HeadlessException | LinkageError e) {   // no such display, or a Java without windows
            return false;
        }
    }

    /**
     * Opens the window, and returns when it was closed and all its threads have ended. Not for the event thread.
     *
     * @param source the scene
     * @param request what is asked for beside the scene file
     */
    public static void view(SceneSource source, RenderRequest request) {
        CountDownLatch closed = new CountDownLatch(1);
        AtomicReference<ViewerFrame> frame = new AtomicReference<>();
        try {
            SwingUtilities.invokeAndWait(() -> {
                FlatLightLaf.setup();
                frame.set(new ViewerFrame(source, request, closed::countDown));
                frame.get().setVisible(true);
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
}
