package simpleray.ui.picture;

import javax.swing.JFrame;
import simpleray.ui.file.SceneSource;
import simpleray.ui.widget.SidePanes;
import simpleray.ui.widget.Workers;

/** The window, as its parts know it. For the event thread unless a method says otherwise. */
public interface ViewerContext {
    /** {@return the window itself, the parent of dialogs} */
    JFrame frame();

    /** {@return the picture} */
    SimpleRay picture();

    /** {@return the picture, and what is beside it} */
    SidePanes sides();

    /** {@return its threads for tasks that take long} */
    Workers workers();

    /**
     * Shows a short message in the status bar.
     *
     * @param message the message
     */
    void say(String message);

    /** Shows in the status bar how far the rendering is, in place of a message. */
    void showProgress();

    /**
     * Shows another scene, once nothing is lost by that. The picture of the one before stays until something of the other can be shown: it
     * may have errors.
     *
     * @param source the scene
     */
    void open(SceneSource source);

    /** Says that the scene's file is now as this program wrote it. Any thread may call. */
    void wroteScene();
}
