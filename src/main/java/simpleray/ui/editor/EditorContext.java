package simpleray.ui.editor;

import simpleray.ui.file.SceneSource;
import simpleray.ui.picture.CameraMenu;
import simpleray.ui.picture.SceneReport;
import simpleray.ui.picture.ViewerContext;
import simpleray.ui.widget.Banner;

/** The window, as the scene's text knows it. For the event thread. */
public interface EditorContext extends ViewerContext {
    /** {@return the notices at the top of the window} */
    Banner banner();

    /** {@return the camera, which may be another than the text's} */
    CameraMenu camera();

    /**
     * Renders the scene as it was found on the disk. If it has errors, they are shown only if it does not change again at once.
     *
     * @param source the scene
     */
    void reload(SceneSource source);

    /**
     * Shows the problems of a text that is not rendered.
     *
     * @param faults the problems; null for those of the picture
     */
    void showFaults(SceneReport faults);

    /**
     * Shows in the status bar what a value of the text is, while no pixel is told.
     *
     * @param line a line about the value; a blank for none
     */
    void tellValue(String line);

    /** Shows the scene's name in the title, and whether its text has changes that are not saved. */
    void refreshTitle();

    /**
     * Notes that a text was saved after it was rendered.
     *
     * @param text the text
     * @param file the file that it is in now
     */
    void saved(SceneSource text, SceneSource file);
}
