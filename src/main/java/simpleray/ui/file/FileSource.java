package simpleray.ui.file;

import java.io.IOException;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import simpleray.io.AtomicFile;
import simpleray.scene.Reach;
import simpleray.scene.SceneFile;
import simpleray.scene.ViewLines;
import simpleray.text.SceneFormatException;

/** A scene in a file; remembers the stamp of the file when it was read. Any thread may call. */
public final class FileSource implements SceneSource {
    private final Path path;
    private final Reach reach;
    private volatile FileStamp read;                          // null until then
    private volatile String note = "";

    /**
     * Creates a source that reads nothing yet.
     *
     * @param path the file
     * @param reach which OBJ files it may name
     */
    public FileSource(Path path, Reach reach) {
        this.path = path;
        this.reach = reach;
    }

    @Override
    public String name() {
        return path.toString();
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
    public SceneFile read() throws IOException {
        read = Files.isRegularFile(path) ? FileStamp.of(path) : null;   // first: should it change meanwhile, it differs from this
        return SceneFile.read(path, reach);
    }

    /**
     * Changes the file, unless it has changed since it was read.
     *
     * @param change the change
     * @throws FileSystemException if the file has changed since it was read, is no scene, or cannot be written; the reason says which
     * @throws IOException if it cannot be read or written
     */
    public synchronized void save(ViewLines.Change change) throws IOException {
        requireUnchanged();
        byte[] bytes = Files.readAllBytes(path);
        byte[] changed;
        try {
            changed = change.apply(bytes, path, reach);
        } catch (SceneFormatException e) {
            throw refusal("It is not readable as a scene: " + e.getMessage().lines().findFirst().orElse(""), e);
        }
        requireUnchanged();                                   // else the bytes might be of the other file
        note = "";
        try (AtomicFile file = new AtomicFile(path, line -> note = ": " + line)) {
            file.out().write(changed);
            file.commit();
        }
        FileStamp after = FileStamp.of(path);
        if (Arrays.equals(Files.readAllBytes(path), changed)) {
            read = after;                                     // as read, with the change made here
        }
    }

    /** {@return in what way the file was not saved as files usually are, to be added to a message; mostly empty} */
    public String note() {
        return note;
    }

    private void requireUnchanged() throws IOException {
        FileStamp now = FileStamp.of(path);
        if (!now.there()) {
            throw refusal("It is no longer there", null);
        }
        if (read == null || !now.isSame(read)) {
            throw refusal("It was changed on the disk since it was read: read it again first (F5)", null);
        }
    }

    private IOException refusal(String reason, Throwable cause) {
        return (IOException) new FileSystemException(path.toString(), null, reason).initCause(cause);
    }
}
