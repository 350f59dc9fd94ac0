package simpleray.image.png;

import java.io.Closeable;
import java.io.IOException;
import java.nio.file.Path;
import java.util.function.Consumer;
import simpleray.image.Picture;
import simpleray.io.AtomicFile;

/** A picture file in the making: an {@link AtomicFile} in PNG. */
public final class PictureFile implements Closeable {
    private final AtomicFile file;

    /**
     * Makes sure that the file can be created, and begins it.
     *
     * @param path the target
     * @param notes told, at the end, in what way it could not be written as files usually are; a line
     * @throws java.nio.file.FileSystemException if it cannot be created; the reason says why
     * @throws IOException likewise
     */
    public PictureFile(Path path, Consumer<String> notes) throws IOException {
        file = new AtomicFile(path, notes);
    }

    /**
     * Makes sure that the file can be created, and begins it. Nobody is told how.
     *
     * @param path the target
     * @throws java.nio.file.FileSystemException if it cannot be created; the reason says why
     * @throws IOException likewise
     */
    public PictureFile(Path path) throws IOException {
        this(path, note -> { });
    }

    /**
     * Writes the picture and moves the file to its target.
     *
     * @param picture the picture, all its rows set
     * @throws IOException if it cannot be written; the target is then as it was
     */
    public void write(Picture picture) throws IOException {
        PngWriter.write(picture, file.out());
        file.commit();
    }

    /** Removes an unfinished file. */
    @Override
    public void close() throws IOException {
        file.close();
    }
}
