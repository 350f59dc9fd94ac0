package simpleray.ui.editor;

import java.awt.Component;
import java.io.File;
import java.nio.file.Path;
import javax.swing.JFileChooser;
import javax.swing.JOptionPane;

/** What is asked and told when a scene's text is saved. For the event thread. */
final class SceneDialogs {
    /** The answer that saves. */
    static final int SAVE = 0;
    /** The answer that lets the changes go. */
    static final int DISCARD = 1;

    private SceneDialogs() {
    }

    /** {@return where a scene without a file is to be written; null for nowhere} Asks before something is overwritten. */
    static Path target(Component window) {
        JFileChooser chooser = new JFileChooser(new File("").getAbsoluteFile());
        chooser.setDialogTitle("Save Scene As");
        if (chooser.showSaveDialog(window) != JFileChooser.APPROVE_OPTION) {
            return null;
        }
        File file = chooser.getSelectedFile();
        boolean may = !file.exists() || JOptionPane.showConfirmDialog(window, file.getName() + " is there already. Replace it?",
            "Save Scene As", JOptionPane.OK_CANCEL_OPTION) == JOptionPane.OK_OPTION;
        return may ? file.toPath() : null;
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
