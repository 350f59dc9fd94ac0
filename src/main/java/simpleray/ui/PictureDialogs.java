package simpleray.ui;

import java.io.File;
import java.io.IOException;
import java.nio.file.FileSystemException;
import java.nio.file.Path;
import java.util.Locale;
import java.util.concurrent.ExecutionException;
import javax.swing.JFileChooser;
import javax.swing.JOptionPane;
import javax.swing.SwingWorker;
import javax.swing.filechooser.FileNameExtensionFilter;
import simpleray.image.Picture;
import simpleray.image.PictureFile;

/** Asks for a scene to open, and for a place to save the picture. */
final class PictureDialogs {
    private final ViewerFrame frame;
    private File folder = new File("").getAbsoluteFile();

    PictureDialogs(ViewerFrame frame) {
        this.frame = frame;
    }

    void open() {
        JFileChooser chooser = new JFileChooser(folder);
        chooser.setDialogTitle("Open Scene");
        chooser.setFileFilter(new FileNameExtensionFilter("Scenes (*.scene, *.txt)", "scene", "txt"));
        if (chooser.showOpenDialog(frame) == JFileChooser.APPROVE_OPTION) {
            folder = chooser.getCurrentDirectory();
            frame.open(SceneSource.file(chooser.getSelectedFile().toPath()));
        }
    }

    /** Asks where, adds .png where it is missing, asks before it overwrites, and writes on a thread of its own. */
    void save() {
        Picture picture = frame.picture().lastWhole();
        JFileChooser chooser = new JFileChooser(folder);
        chooser.setDialogTitle("Save Picture As");
        chooser.setFileFilter(new FileNameExtensionFilter("PNG pictures (*.png)", "png"));
        chooser.setSelectedFile(new File(folder, suggestion()));
        while (chooser.showSaveDialog(frame) == JFileChooser.APPROVE_OPTION) {
            folder = chooser.getCurrentDirectory();
            File chosen = withExtension(chooser.getSelectedFile());
            if (!chosen.exists() || mayReplace(chosen)) {
                write(picture, chosen.toPath());
                return;
            }
        }
    }

    private String suggestion() {
        String name = new File(frame.picture().source().name().replaceAll("[<>]", "")).getName();
        int dot = name.lastIndexOf('.');
        return (dot > 0 ? name.substring(0, dot) : name) + ".png";
    }

    private static File withExtension(File file) {
        return file.getName().toLowerCase(Locale.ROOT).endsWith(".png") ? file : new File(file.getPath() + ".png");
    }

    private boolean mayReplace(File file) {
        return JOptionPane.showConfirmDialog(frame, file.getName() + " is there already. Replace it?", "Save Picture As",
            JOptionPane.OK_CANCEL_OPTION, JOptionPane.WARNING_MESSAGE) == JOptionPane.OK_OPTION;
    }

    private void write(Picture picture, Path path) {
        new SwingWorker<Void, Void>() {
            @Override
            protected Void doInBackground() throws IOException {
                try (PictureFile file = new PictureFile(path)) {
                    file.write(picture);
                }
                return null;
            }

            @Override
            protected void done() {
                try {
                    get();
                    frame.say("Saved " + path);
                } catch (ExecutionException | InterruptedException e) {
                    Throwable cause = e.getCause();
                    String reason = cause instanceof FileSystemException f && f.getReason() != null ? f.getReason() : String.valueOf(cause);
                    JOptionPane.showMessageDialog(frame, path + "\n" + reason, "The picture was not saved", JOptionPane.ERROR_MESSAGE);
                }
            }
        }.execute();
    }
}
