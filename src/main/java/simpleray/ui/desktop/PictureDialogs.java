package simpleray.ui.desktop;

import java.io.File;
import java.io.IOException;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import java.util.concurrent.Executor;
import java.util.function.Consumer;
import javax.swing.JFileChooser;
import javax.swing.JFrame;
import javax.swing.JOptionPane;
import javax.swing.SwingUtilities;
import javax.swing.filechooser.FileNameExtensionFilter;
import simpleray.image.Picture;
import simpleray.image.png.PictureFile;
import simpleray.ui.file.SceneSource;
import simpleray.ui.picture.RenderJob;
import simpleray.ui.picture.ViewerContext;

/** Asks for a scene to open, and for a place to save the picture. */
public final class PictureDialogs {
    private final ViewerContext window;
    private final JFrame frame;
    private final Executor writer;
    private final Preferences preferences;
    private File folder;

    /**
     * Begins in the folder of the last dialog.
     *
     * @param window the window
     * @param preferences what it remembers
     */
    public PictureDialogs(ViewerContext window, Preferences preferences) {
        this.window = window;
        frame = window.frame();
        writer = window.workers().finishing("simpleray-saving");
        this.preferences = preferences;
        Path last = preferences.folder();
        folder = last != null && Files.isDirectory(last) ? last.toFile() : new File("").getAbsoluteFile();
    }

    /** Asks for a scene and opens it. */
    public void open() {
        JFileChooser chooser = new JFileChooser(sceneFolder());
        chooser.setDialogTitle("Open Scene");
        chooser.setFileFilter(new FileNameExtensionFilter("Scenes, pictures that carry theirs, and models (*.scene, *.txt, *.png, *.obj)",
            "scene", "txt", "png", "obj"));
        if (chooser.showOpenDialog(frame) == JFileChooser.APPROVE_OPTION) {
            stayIn(chooser.getCurrentDirectory());
            window.open(SceneSource.file(chooser.getSelectedFile().toPath()));
        }
    }

    /** {@return the folder of the scene on the screen; of one that came by standard input the working folder, of none the last folder} */
    private File sceneFolder() {
        SceneSource source = window.picture().source();
        if (source == SceneSource.NONE) {
            return folder;
        }
        Path path = source.path() == null ? Path.of("scene") : source.path();
        return path.toAbsolutePath().getParent().toFile();
    }

    /** Asks where, adds .png where it is missing, and asks before it overwrites. */
    public void save() {
        Picture picture = window.picture().whole();
        JFileChooser chooser = new JFileChooser(folder);
        chooser.setDialogTitle("Save Picture As");
        chooser.setFileFilter(new FileNameExtensionFilter("PNG pictures (*.png)", "png"));
        chooser.setSelectedFile(new File(folder, pictureName(window.picture().source())));
        while (chooser.showSaveDialog(frame) == JFileChooser.APPROVE_OPTION) {
            stayIn(chooser.getCurrentDirectory());
            File chosen = withExtension(chooser.getSelectedFile());
            if (window.picture().job().reads(chosen.toPath())) {
                failed(chosen.toPath(), RenderJob.READ);
            } else if (!chosen.exists() || mayReplace(chosen)) {
                write(picture, chosen.toPath());
                return;
            }
        }
    }

    private void stayIn(File other) {
        folder = other;
        preferences.setFolder(other.toPath());
    }

    /** {@return the name of a picture's file that the scene suggests; another than that of a picture which carries the scene} */
    static String pictureName(SceneSource source) {
        String name = new File(source.name().replaceAll("[<>]", "")).getName();
        int dot = name.lastIndexOf('.');
        return (dot > 0 ? name.substring(0, dot) : name) + (isNamedPicture(name) ? "-new.png" : ".png");
    }

    private static boolean isNamedPicture(String name) {
        return name.toLowerCase(Locale.ROOT).endsWith(".png");
    }

    private static File withExtension(File file) {
        return isNamedPicture(file.getName()) ? file : new File(file.getPath() + ".png");
    }

    private boolean mayReplace(File file) {
        return JOptionPane.showConfirmDialog(frame, file.getName() + " is there already. Replace it?", "Save Picture As",
            JOptionPane.OK_CANCEL_OPTION, JOptionPane.WARNING_MESSAGE) == JOptionPane.OK_OPTION;
    }

    /** Writes on a thread of its own. */
    private void write(Picture picture, Path path) {
        writer.execute(() -> {
            StringBuilder saved = new StringBuilder("Saved " + path);
            String failure = failure(picture, path, note -> saved.append(": ").append(note));
            SwingUtilities.invokeLater(() -> {
                if (failure == null) {
                    window.say(saved.toString());
                } else {
                    failed(path, failure);
                }
            });
        });
    }

    private void failed(Path path, String why) {
        JOptionPane.showMessageDialog(frame, path + "\n" + why, "The picture was not saved", JOptionPane.ERROR_MESSAGE);
    }

    /** {@return why the picture could not be written; null if it was} */
    private static String failure(Picture picture, Path path, Consumer<String> notes) {
        try (PictureFile file = new PictureFile(path, notes)) {
            file.write(picture);
            return null;
        } catch (FileSystemException e) {
            return e.getReason() != null ? e.getReason() : e.toString();
        } catch (IOException | RuntimeException e) {
            return e.toString();
        }
    }
}
