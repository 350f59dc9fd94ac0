package simpleray.ui.editor;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.concurrent.Executor;
import java.util.function.Consumer;
import java.util.function.Function;
import java.util.function.Supplier;
import javax.swing.SwingUtilities;
import javax.swing.Timer;
import simpleray.scene.SceneFile;
import simpleray.text.SourceValues;
import simpleray.ui.file.SceneSource;

/** Reads the text as it is typed, on a thread of the window's: after a pause, and at least a few times a second. For the event thread. */
final class TextChecker {
    /** Milliseconds without a change after which the text is read. */
    private static final int PAUSE = 200;
    /** The longest that a change waits, in milliseconds. */
    private static final int MAX_WAIT = 350;
    private static final long MILLI = 1_000_000;

    private final Executor worker;
    private final Supplier<String> text;
    private final Function<byte[], SceneSource> source;
    private final Consumer<Check> then;
    private final Timer timer = new Timer(PAUSE, e -> now());
    private long since;
    private boolean busy;
    private boolean again;

    /**
     * What was found. <em>Constant.</em>
     *
     * @param text the text
     * @param source the scene of that text
     * @param values its values, as far as they could be read
     * @param file the scene; null if it has errors
     * @param failure its errors; null if there are none
     */
    record Check(String text, SceneSource source, SourceValues values, SceneFile file, IOException failure) {
    }

    /**
     * Creates a checker.
     *
     * @param worker the thread
     * @param text supplies the text; null for none
     * @param source makes a scene of a text
     * @param then called with what was found
     */
    TextChecker(Executor worker, Supplier<String> text, Function<byte[], SceneSource> source, Consumer<Check> then) {
        this.worker = worker;
        this.text = text;
        this.source = source;
        this.then = then;
        timer.setRepeats(false);
    }

    /** Reads the text soon. */
    void changed() {
        long now = System.nanoTime();
        if (!timer.isRunning()) {
            since = now;
        }
        timer.setInitialDelay((int) Math.max(0, Math.min(PAUSE, MAX_WAIT - (now - since) / MILLI)));
        timer.restart();
    }

    /** Reads the text at once, or as soon as what is being read has been. */
    void now() {
        timer.stop();
        String asked = text.get();
        again = busy;
        if (busy || asked == null) {
            return;
        }
        busy = true;
        SceneSource scene = source.apply(asked.getBytes(StandardCharsets.UTF_8));
        worker.execute(() -> {
            SourceValues values = new SourceValues();
            SceneFile file = null;
            IOException failure = null;
            try {
                file = scene.check(values);
            } catch (IOException e) {
                failure = e;
            } catch (RuntimeException | Error e) {            // the rendering will say so
                values = new SourceValues();
            }
            Check found = new Check(asked, scene, values, file, failure);
            SwingUtilities.invokeLater(() -> {
                busy = false;
                then.accept(found);
                if (again) {
                    now();
                }
            });
        });
    }
}
