package simpleray.ui.editor;

import java.awt.Component;
import java.io.File;
import java.nio.file.FileSystems;
import java.nio.file.Path;
import javax.swing.JFileChooser;
import javax.swing.JOptionPane;
import javax.swing.filechooser.FileNameExtensionFilter;

/** What is asked and told when a scene's text is saved. For the event thread. */
final class SceneDialogs {
    /** The answer that saves. */
    static final int SAVE = 0;
    /** The answer that lets the changes go. */
    static final int DISCARD = 1;

    private SceneDialogs() {
    }

    /**
     * {@return where a scene is to be written; null for nowhere} Asks before something is overwritten.
     *
     * @param window the window
     * @param home the scene's path, or the one it would have, whose name is proposed
     */
    static Path target(Component window, Path home) {
        boolean real = home.getFileSystem() == FileSystems.getDefault();      // else it is in the program's jar
        File folder = real ? home.toAbsolutePath().toFile().getParentFile() : new File("").getAbsoluteFile();
        JFileChooser chooser = new JFileChooser(folder);
        chooser.setDialogTitle("Save Scene As");
        chooser.setFileFilter(new FileNameExtensionFilter("Scenes (*.scene, *.txt)", "scene", "txt"));
        chooser.setSelectedFile(new File(folder, home.getFileName().toString()));
        while (chooser.showSaveDialog(window) == JFileChooser.APPROVE_OPTION) {
            File chosen = chooser.getSelectedFile();
            File file = chosen.getName().contains(".") ? chosen : new File(chosen.getPath() + ".scene");
            if (!file.exists() || JOptionPane.showConfirmDialog(window, file.getName() + " is there already. Replace it?",
                "Save Scene As", JOptionPane.OK_CANCEL_OPTION, JOptionPane.WARNING_MESSAGE) == JOptionPane.OK_OPTION) {
                return file.toPath();
            }
        }
        return null;
    }

    /** {@return SAVE, DISCARD, or another number to go on as before} */
    static int unsaved(Component window, String name) {
        String[] answers = {"Save", "Don\u2019t Save", "Cancel"};
        return JOptionPane.showOptionDialog(window, name + " has changes that are not saved.", "Unsaved Changes",
            JOptionPane.DEFAULT_OPTION, JOptionPane.WARNING_MESSAGE, null, answers, answers[0]);
    }

    /** Says why a scene was not saved. */
    static void failed(Component window, Path path, String why) {
        JOptionPane.showMessageDialog(window, path + "\n" + why, "The scene was not saved", JOptionPane.ERROR_MESSAGE);
    }
}
