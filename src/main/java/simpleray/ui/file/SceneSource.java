package simpleray.ui.file;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import simpleray.scene.Reach;
import simpleray.scene.Scene;
import simpleray.scene.SceneFile;
import simpleray.text.SourceValues;

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
     * Reads the scene's text, and lists its values. The next {@link #read} of the same text may return what this has read.
     *
     * @param values gets the values; up to the first error after which the rest cannot be read
     * @return the scene
     * @throws simpleray.text.SceneFormatException if it is no scene
     * @throws IOException if it cannot be read
     */
    default SceneFile check(SourceValues values) throws IOException {
        return SceneFile.read(new ByteArrayInputStream(text()), home(), reach(), values);
    }

    /** {@return the scene's file; null if it is none that could be watched or written} */
    default Path path() {
        return null;
    }

    /** {@return the path by which messages know the scene, beside which its meshes lie; null for the working directory} */
    default Path home() {
        return path();
    }

    /**
     * Reads the scene's text as it is now.
     *
     * @return its bytes; null if there is no text to show
     * @throws IOException if it cannot be read
     */
    default byte[] text() throws IOException {
        return path() == null ? null : Files.readAllBytes(path());
    }

    /** {@return which OBJ files the scene may name} */
    default Reach reach() {
        return Reach.FOLDER;
    }

    /**
     * Makes a source of a text that is not, or not yet, in this source's file.
     *
     * @param text the scene's text, UTF-8
     * @return the source, which may name the same OBJ files
     */
    default SceneSource edited(byte[] text) {
        return new TextSource(path(), text, reach());
    }

    /**
     * Makes a source of a file, which may name OBJ files in its own folder.
     *
     * @param path the file; if it is an OBJ, the source is of a scene made for it
     * @return the source
     */
    static SceneSource file(Path path) {
        return file(path, Reach.FOLDER);
    }

    /**
     * Makes a source of a file.
     *
     * @param path the file; if it is an OBJ, the source is of a scene made for it
     * @param reach which OBJ files it may name
     * @return the source
     */
    static SceneSource file(Path path, Reach reach) {
        return ModelScene.isModel(path) ? ModelScene.of(path) : new FileSource(path, reach);
    }

    /**
     * Makes a source of text that came by standard input, and may name OBJ files in the working directory.
     *
     * @param text the scene's text, UTF-8
     * @return the source
     */
    static SceneSource text(byte[] text) {
        return text(text, Reach.FOLDER);
    }

    /**
     * Makes a source of text that came by standard input.
     *
     * @param text the scene's text, UTF-8
     * @param reach which OBJ files it may name
     * @return the source
     */
    static SceneSource text(byte[] text, Reach reach) {
        return new TextSource(null, text, reach);
    }
}
