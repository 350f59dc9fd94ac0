package simpleray.ui;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import simpleray.scene.Scene;
import simpleray.scene.SceneFile;

/** Where a window's scene comes from; it can be read again and again. Any thread may call. */
public interface SceneSource {
    /** No scene: an empty window. */
    SceneSource NONE = new SceneSource() {
        @Override
        public String name() {
            return "";
        }

        @Override
        public SceneFile read() {
            return new SceneFile(new Scene(), List.of());
        }
    };

    /** {@return the scene's name for the title and for messages; empty for no scene} */
    String name();

    /**
     * Reads the scene as it is now.
     *
     * @return the scene
     * @throws simpleray.text.SceneFormatException if it is no scene
     * @throws IOException if it cannot be read
     */
    SceneFile read() throws IOException;

    /**
     * Makes a source of a file.
     *
     * @param path the file
     * @return the source
     */
    static SceneSource file(Path path) {
        return new SceneSource() {
            @Override
            public String name() {
                return path.toString();
            }

            @Override
            public SceneFile read() throws IOException {
                return SceneFile.read(path);
            }
        };
    }

    /**
     * Makes a source of text that came by standard input.
     *
     * @param text the scene's text, UTF-8
     * @return the source
     */
    static SceneSource text(byte[] text) {
        return new SceneSource() {
            @Override
            public String name() {
                return "<stdin>";
            }

            @Override
            public SceneFile read() throws IOException {
                return SceneFile.read(new ByteArrayInputStream(text));
            }
        };
    }
}
