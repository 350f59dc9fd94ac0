package simpleray.ui.file;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.file.Path;
import simpleray.scene.Reach;
import simpleray.scene.SceneFile;
import simpleray.text.SourceValues;

/** A scene that is in no file of the user's yet, but has a name, and meshes beside that. Any thread may call. */
final class UntitledSource implements SceneSource {
    private final String name;
    private final Path home;
    private final Maker text;

    /** Makes a scene's text, UTF-8. */
    interface Maker {
        byte[] make() throws IOException;
    }

    /**
     * Creates a source.
     *
     * @param name the scene's name for people
     * @param home the path beside which its meshes lie
     * @param text makes its text
     */
    UntitledSource(String name, Path home, Maker text) {
        this.name = name;
        this.home = home;
        this.text = text;
    }

    @Override
    public String name() {
        return name;
    }

    @Override
    public Path home() {
        return home;
    }

    @Override
    public byte[] text() throws IOException {
        return text.make();
    }

    @Override
    public SceneFile read() throws IOException {
        return check(null);
    }

    @Override
    public SceneFile check(SourceValues values) throws IOException {
        return SceneFile.read(new ByteArrayInputStream(text.make()), name, home.resolveSibling(""), Reach.FOLDER, values);
    }

    @Override
    public SceneSource edited(byte[] other) {
        return new UntitledSource(name, home, other::clone);
    }
}
