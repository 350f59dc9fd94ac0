package simpleray.ui;

import java.awt.event.KeyEvent;
import java.nio.file.Path;
import javax.swing.JFileChooser;
import javax.swing.JTextField;
import javax.swing.SwingUtilities;

/** A dialog that asks for a file and is open on the screen. */
public final class FileDialog {
    private final Screen screen;
    private final JTextField name;

    public FileDialog(Screen screen) {
        this.screen = screen;
        name = OpenWindow.appears("a dialog that asks for a file", JTextField.class, FileDialog::asksForFile);
        Screen.until("the dialog has the keys", name::isFocusOwner);
    }

    private static boolean asksForFile(JTextField field) {
        return SwingUtilities.getAncestorOfClass(JFileChooser.class, field) != null;
    }

    /** {@return where the file's name is typed} */
    public JTextField field() {
        return name;
    }

    /** {@return the file that the dialog proposes} */
    public String proposal() {
        return OpenWindow.ask(name::getText);
    }

    /** {@return the folder that it shows} */
    public Path folder() {
        return OpenWindow.ask(() -> (JFileChooser)
            SwingUtilities.getAncestorOfClass(JFileChooser.class, name)).getCurrentDirectory().toPath();
    }

    /** Types the path of a file in place of what is there, and Enter. */
    public void enter(Path path) {
        screen.press(KeyEvent.VK_CONTROL, KeyEvent.VK_A);
        screen.type(path.toString());
        Screen.until("the path is typed", () -> name.getText().equals(path.toString()));
        screen.press(KeyEvent.VK_ENTER);
    }

    /** Puts a path, of any signs, in place of what is there, and types Enter. */
    public void put(Path path) {
        OpenWindow.run(() -> name.setText(path.toString()));
        screen.press(KeyEvent.VK_ENTER);
    }

    public void untilClosed() {
        Screen.until("the dialog is gone", () -> !name.isShowing());
    }
}
