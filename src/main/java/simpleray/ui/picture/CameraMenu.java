package simpleray.ui.picture;

import java.awt.Point;
import java.awt.Toolkit;
import java.awt.datatransfer.StringSelection;
import java.awt.event.KeyEvent;
import java.io.IOException;
import java.nio.file.FileSystemException;
import java.util.List;
import java.util.concurrent.Executor;
import java.util.function.BiConsumer;
import java.util.function.Supplier;
import javax.swing.Action;
import javax.swing.JComponent;
import javax.swing.JMenu;
import javax.swing.SwingUtilities;
import simpleray.scene.FreeView;
import simpleray.scene.PerspectiveCamera.Pose;
import simpleray.scene.SceneFile;
import simpleray.scene.SceneSettings;
import simpleray.scene.ViewLines;
import simpleray.ui.file.FileSource;
import simpleray.ui.widget.KeyBindings;

/** The Camera menu: moves the camera in steps, goes back to the scene's own, copies and saves it. */
public final class CameraMenu {
    private static final double STEP = 5;                     // degrees
    private static final double PIECE = 0.05;                 // of the picture's height
    private static final String TITLE = "The view was not saved";

    private final ViewerContext window;
    private final SimpleRay picture;
    private final CameraTool tool;
    private final JMenu menu = new JMenu("Camera");
    private final Executor writer;
    private final TextChange edit;
    private final CameraLine line;

    /**
     * Creates the menu.
     *
     * @param window the window
     * @param text supplies the scene's text as it is edited; null if it is not
     * @param replacement takes the text with another view in it, and what was done
     */
    public CameraMenu(ViewerContext window, Supplier<String> text, BiConsumer<String, String> replacement) {
        this.window = window;
        picture = window.picture();
        writer = window.workers().finishing("simpleray-view");
        edit = new TextChange(window, text, replacement, writer, TITLE);
        tool = new CameraTool(picture);
        line = new CameraLine(tool::reset, this::save, this::setKey);
        menu.setMnemonic(KeyEvent.VK_C);
        add("Orbit Left", "LEFT", () -> tool.turn(-STEP, 0));
        add("Orbit Right", "RIGHT", () -> tool.turn(STEP, 0));
        add("Orbit Up", "UP", () -> tool.turn(0, STEP));
        add("Orbit Down", "DOWN", () -> tool.turn(0, -STEP));
        menu.addSeparator();
        add("Pan Left", "shift LEFT", () -> tool.pan(-PIECE, 0));
        add("Pan Right", "shift RIGHT", () -> tool.pan(PIECE, 0));
        add("Pan Up", "shift UP", () -> tool.pan(0, PIECE));
        add("Pan Down", "shift DOWN", () -> tool.pan(0, -PIECE));
        menu.addSeparator();
        add("Nearer", "PAGE_UP", () -> tool.dolly(1));
        add("Farther", "PAGE_DOWN", () -> tool.dolly(-1));
        add("Back to the Scene's Camera", "HOME", tool::reset);
        add("Undo Camera Step", "control Z", tool::undo);
        add("Redo Camera Step", "control shift Z", tool::redo);
        menu.addSeparator();
        add("Copy Camera", "control shift C", this::copy);
        add("Save View in Scene", "control shift V", this::save);
        add("Set Camera Key", "K", this::setKey);
    }

    /** {@return a line for the picture's foot, which tells how to move the camera, and once it is moved what to do about that} */
    public JComponent line() {
        tool.setListener(() -> line.show(tool.isMoved(), tool.isKnown(), tool.isMoved() && hasKeys()));
        return line;
    }

    /**
     * Tells in that line what the mouse and keys do where the picture is.
     *
     * @param gestures a few words each, the most useful first, help last; null for those of the picture itself
     */
    public void tellGestures(List<String> gestures) {
        line.setGestures(gestures);
    }

    /**
     * Tells nothing of a picture in that line while there is none.
     *
     * @param none whether there is no picture, and none to come
     */
    public void setBlank(boolean none) {
        line.setBlank(none);
    }

    /** {@return the menu} */
    public JMenu menu() {
        return menu;
    }

    /**
     * Turns the camera until what a pixel shows is in the middle.
     *
     * @param pixel the pixel
     */
    public void lookAt(Point pixel) {
        tool.lookAt(pixel);
    }

    /** Lets go of the moves: another scene comes. */
    public void forget() {
        tool.forget();
    }

    /** Adds an item. Its key also works where the pane round the picture would take it for scrolling. */
    private void add(String name, String key, Runnable task) {
        Action action = KeyBindings.action(name, key, task);
        KeyBindings.bind(picture, JComponent.WHEN_FOCUSED, key, action);
        menu.add(action);
    }

    /** Puts the lines of a scene file on the clipboard: a camera, or window and centre of projection if no free camera shows the same. */
    private void copy() {
        SceneSettings view = tool.view();
        if (view == null) {
            window.say("There is no camera to copy: no scene was read");
            return;
        }
        if (FreeView.isExact(view)) {
            view = FreeView.alone(view);
        }
        String lines = ViewLines.of(shortest(view));
        Toolkit.getDefaultToolkit().getSystemClipboard().setContents(new StringSelection(lines), null);
        window.say("Copied: " + lines.strip().replace("\n", "; "));
    }

    /** {@return a free camera with the shortest numbers that show the same; other settings as they are} */
    private SceneSettings shortest(SceneSettings view) {
        return view == null || !view.isFree() ? view : ShortView.of(view, picture.imageSize().width, picture.imageSize().height);
    }

    /** Writes the view on the screen into the scene's file, or into its text if that is open. */
    public void save() {
        SceneSettings view = shortest(tool.view());
        if (view == null) {
            window.say("There is no view to save: no scene was read");
        } else if (hasKeys()) {
            window.say("The camera has keys: Camera > Set Camera Key writes this view as one of them");
        } else if (edit.isPossible() && tool.isOther()) {
            edit.make((bytes, path, reach) -> ViewLines.put(bytes, path, view, reach), "Saved the view", tool::release);
        } else if (!(picture.source() instanceof FileSource file)) {
            edit.tell("The scene is in no file yet: File > Save Scene As\u2026 writes one");
        } else if (!tool.isOther()) {
            window.say("The scene has this view already");
        } else {
            writer.execute(() -> {
                String failure = failure(file, (bytes, path, reach) -> ViewLines.put(bytes, path, view, reach));
                if (failure == null) {
                    window.wroteScene();                       // else it would be read twice
                }
                SwingUtilities.invokeLater(() -> saved(file, view, failure));
            });
        }
    }

    /** {@return whether the scene on the screen is seen by another camera than its own} */
    public boolean isOther() {
        return tool.isOther();
    }

    /** {@return what puts the view on the screen into a scene's text; null if the scene has it, or has keys} */
    public ViewLines.Change unsaved() {
        SceneSettings view = tool.isOther() && !hasKeys() ? shortest(tool.view()) : null;
        return view == null ? null : (bytes, path, reach) -> ViewLines.put(bytes, path, view, reach);
    }

    /** Asks for no camera but the scene's own from the next start on: the view was written into it. */
    public void release() {
        tool.release();
    }

    private boolean hasKeys() {
        RenderJob read = picture.seen() == null ? picture.job() : picture.seen();      // the latest may not have its scene yet
        SceneFile film = read.snapshot().film();
        return film != null && film.scene().settings.hasCameraKeys();
    }

    /** Makes the view a key of the frame on the screen. */
    private void setKey() {
        SceneSettings view = tool.view();
        RenderJob.Snapshot now = view == null ? null : picture.job().snapshot();
        if (now == null || now.film() == null || now.film().scene().settings.frames == null) {
            window.say("Only a film has keys: frames n fps, in the scene's text, makes one");
            return;
        }
        SceneSettings free = FreeView.alone(view);
        if (free.camera == null) {
            window.say("A camera of parallel rays can have no keys");
            return;
        }
        Pose pose = shortest(free).camera;
        ViewLines.Change change = (bytes, path, reach) -> ViewLines.putKey(bytes, path, now.frame(), pose, reach);
        String done = "Set the camera's key at frame " + now.frame();
        if (edit.isPossible()) {
            edit.make(change, done, tool::release);
        } else if (picture.source() instanceof FileSource file) {
            writer.execute(() -> {
                String failure = failure(file, change);
                if (failure == null) {
                    window.wroteScene();                       // else it would be read twice
                }
                SwingUtilities.invokeLater(() -> {
                    if (failure != null) {
                        edit.tell(file.name() + '\n' + failure);
                    } else if (window.frame().isDisplayable() && picture.source() == file) {
                        tool.adopt();
                        window.say(done + " in " + file.name() + file.note());
                    }
                });
            });
        } else {
            edit.tell("The scene is in no file yet: File > Save Scene As\u2026 writes one");
        }
    }

    private void saved(FileSource file, SceneSettings view, String failure) {
        if (failure != null) {
            edit.tell(file.name() + '\n' + failure);
            return;
        }
        if (!window.frame().isDisplayable()) {                         // closed meanwhile: nothing is to be rendered any more
            return;
        }
        SceneSettings now = picture.source() == file ? tool.view() : null;
        if (now != null && ViewLines.of(shortest(now)).equals(ViewLines.of(view))) {
            tool.adopt();                                     // unless it was moved on meanwhile
        }
        window.say("Saved the view in " + file.name() + file.note());
    }

    /** {@return why the view could not be saved, a line; null if it was} */
    private static String failure(FileSource file, ViewLines.Change change) {
        try {
            file.save(change);
            return null;
        } catch (FileSystemException e) {
            return e.getReason() != null ? e.getReason() : e.toString();
        } catch (IOException | RuntimeException | OutOfMemoryError e) {
            return e.toString();
        }
    }
}
