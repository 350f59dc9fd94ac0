package simpleray.ui.file;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Path;
import simpleray.scene.Reach;
import simpleray.scene.SceneFile;

/** A scene's text in memory: from standard input, or not, or not yet, in the scene's file. Any thread may call. */
final class TextSource implements SceneSource {
    private final Path path;                                  // null for standard input
    private final byte[] text;
    private final Reach reach;

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
        InputStream in = new ByteArrayInputStream(text);
        return path == null ? SceneFile.read(in, reach) : SceneFile.read(in, path, reach);
    }
}
