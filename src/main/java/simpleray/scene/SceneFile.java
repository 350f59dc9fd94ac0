package simpleray.scene;

import java.io.FileNotFoundException;
import java.io.IOException;
import java.io.InputStream;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import simpleray.text.Problem;
import simpleray.text.SceneReader;

/**
 * A scene as it was read from a file, with what was odd about the file. <em>Constant.</em>
 *
 * @param scene the scene
 * @param warnings the warnings, in the order of the file
 */
public record SceneFile(Scene scene, List<Problem> warnings) {
    /**
     * Reads a scene file.
     *
     * @param path the file; its path as given stands in messages
     * @return the scene
     * @throws simpleray.text.SceneFormatException if it is no scene
     * @throws FileSystemException if it cannot be opened, with a reason that people understand
     * @throws IOException if it cannot be read
     */
    public static SceneFile read(Path path) throws IOException {
        if (Files.isDirectory(path)) {
            throw new FileSystemException(path.toString(), null, "is a folder");
        }
        try (SceneReader reader = new SceneReader(path.toFile())) {
            return read(reader);
        } catch (FileNotFoundException e) {
            String reason = Files.exists(path) ? "may not be read" : "no such file";
            throw (IOException) new FileSystemException(path.toString(), null, reason).initCause(e);
        }
    }

    /**
     * Reads a scene from standard input.
     *
     * @param in the stream, read to its end and left open
     * @return the scene
     * @throws simpleray.text.SceneFormatException if it is no scene
     * @throws IOException if it cannot be read
     */
    public static SceneFile read(InputStream in) throws IOException {
        return read(new SceneReader(in));
    }

    private static SceneFile read(SceneReader reader) throws IOException {
        Scene scene = new Scene();
        scene.read(reader);
        return new SceneFile(scene, reader.warnings());
    }
}
