package simpleray.ui.picture;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.concurrent.Executor;
import java.util.function.BiConsumer;
import java.util.function.Supplier;
import javax.swing.JOptionPane;
import javax.swing.SwingUtilities;
import simpleray.scene.ViewLines;
import simpleray.text.SceneFormatException;
import simpleray.ui.file.SceneSource;

/** Changes the scene's text beside the picture, in which something may be typed that the file does not have. For the event thread. */
final class TextChange {
    private final ViewerContext window;
    private final Supplier<String> text;
    private final BiConsumer<String, String> replacement;
    private final Executor writer;
    private final String title;

    /**
     * Creates it.
     *
     * @param window the window
     * @param text supplies the scene's text as it is edited; null if it is not
     * @param replacement takes the changed text, and what was done
     * @param writer reads and changes texts
     * @param title the title of a message about a failure
     */
    TextChange(ViewerContext window, Supplier<String> text, BiConsumer<String, String> replacement, Executor writer, String title) {
        this.window = window;
        this.text = text;
        this.replacement = replacement;
        this.writer = writer;
        this.title = title;
    }

    /** {@return whether the text is shown, and so can be changed} */
    boolean isPossible() {
        return text.get() != null;
    }

    /**
     * Changes the text, in the background; a failure is told.
     *
     * @param change the change
     * @param done what the change does, as said when it is done
     * @param before is run before the changed text is taken
     */
    void make(ViewLines.Change change, String done, Runnable before) {
        SceneSource source = window.picture().source();
        String edited = text.get();
        Path path = source.home() == null ? Path.of(source.name().replaceAll("[<>]", "")) : source.home();
        writer.execute(() -> {
            String put = null;
            String failure = null;
            try {
                put = new String(change.apply(edited.getBytes(StandardCharsets.UTF_8), path, source.reach()), StandardCharsets.UTF_8);
            } catch (SceneFormatException e) {
                failure = "The text is not readable as a scene: " + e.getMessage().lines().findFirst().orElse("");
            } catch (IOException | RuntimeException | OutOfMemoryError e) {
                failure = e.toString();
            }
            String made = put;
            String why = failure;
            SwingUtilities.invokeLater(() -> {
                if (!window.frame().isDisplayable()) {                 // closed meanwhile
                    return;
                }
                if (why != null) {
                    tell(source.name() + '\n' + why);
                } else if (edited.equals(text.get())) {       // which may be rendered by now from a source of its own
                    before.run();
                    replacement.accept(made, done);
                } else {
                    window.say("The text was changed meanwhile: try again");
                }
            });
        });
    }

    /** Shows why something was not changed. */
    void tell(String reason) {
        JOptionPane.showMessageDialog(window.frame(), reason, title, JOptionPane.ERROR_MESSAGE);
    }
}
