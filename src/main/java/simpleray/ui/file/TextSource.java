package simpleray.ui.file;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.file.Path;
import java.util.concurrent.atomic.AtomicReference;
import simpleray.scene.Reach;
import simpleray.scene.SceneFile;
import simpleray.text.SourceValues;

/** A scene's text in memory: from standard input, or not, or not yet, in the scene's file. Any thread may call. */
final class TextSource implements SceneSource {
    private final Path path;                                  // null for standard input
    private final byte[] text;
    private final Reach reach;
    private final AtomicReference<SceneFile> checked = new AtomicReference<>();      // for the next reading

    TextSource(Path path, byte[] text, Reach reach) {
        this.path = path;
        this.text = text;
        this.reach = reach;
    }

    @Override
    public String name() {
        return path == null ? "<stdin>" : path.toString();
    }

    @Override
    public Path path() {
        return path;
    }

    @Override
    public Reach reach() {
        return reach;
    }

    @Override
    public byte[] text() {
        return text.clone();
    }

    @Override
    public SceneFile read() throws IOException {
        SceneFile known = checked.getAndSet(null);
        return known != null ? known : read(null);
    }

    @Override
    public SceneFile check(SourceValues values) throws IOException {
        SceneFile file = read(values);
        checked.set(file);
        return file;
    }

    private SceneFile read(SourceValues values) throws IOException {
        return SceneFile.read(new ByteArrayInputStream(text), path, reach, values);
    }
}
