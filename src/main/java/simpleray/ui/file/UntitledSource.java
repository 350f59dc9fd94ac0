package simpleray.ui.file;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.file.Path;
import simpleray.scene.Reach;
import simpleray.scene.SceneFile;

/** A scene that is in no file of the user's yet, but has a name, and meshes beside that. Any thread may call. */
final class UntitledSource implements SceneSource {
    private final Path home;
    private final Maker text;

    /** Makes a scene's text, UTF-8. */
    interface Maker {
        byte[] make() throws IOException;
    }

    UntitledSource(Path home, Maker text) {
        this.home = home;
        this.text = text;
    }

    @Override
    public String name() {
        return home.toString();
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
        return SceneFile.read(new ByteArrayInputStream(text.make()), home, Reach.FOLDER);
    }

    @Override
    public SceneSource edited(byte[] other) {
        return new UntitledSource(home, other::clone);
    }
}
