package simpleray.io;

import java.io.BufferedOutputStream;
import java.io.Closeable;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.StandardOpenOption;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;

/**
 * A file in the making. It is written beside its target and moved over it when it is whole, so that the target is at all
 * times the old file or the new one. A target that is there and is no file, such as a device, is written to as it is.
 *
 * <p>One target has one file in the making at a time. What a killed process left of its own is used again by the next.
 */
public final class AtomicFile implements Closeable {
    /** Those to be removed should the program be told to stop before they are whole. */
    private static final Set<AtomicFile> BEGUN = ConcurrentHashMap.newKeySet();

    static {
        Runtime.getRuntime().addShutdownHook(new Thread("simpleray-deleting") {
            @Override
            public void run() {
                removeBegun();
            }
        });
    }

    private final Path target;
    private final Path part;             // equal to the target where nothing is to be moved
    private final OutputLock lock;       // null there
    private final OutputStream out;
    private volatile boolean whole;
    private boolean ended;

    /**
     * Makes sure that the file can be created, and begins it.
     *
     * @param path the target
     * @throws FileInUseException if somebody else is making it
     * @throws FileSystemException if it cannot be created; the reason says why
     * @throws IOException likewise
     */
    public AtomicFile(Path path) throws IOException {
        if (Files.isDirectory(path)) {
            throw new FileSystemException(path.toString(), null, "is a folder");
        }
        boolean there = Files.exists(path);
        if (there && !Files.isWritable(path)) {
            throw new FileSystemException(path.toString(), null, "is write-protected");
        }
        target = OutputLock.target(path);
        if (there && !Files.isRegularFile(target)) {
            part = target;
            lock = null;
            out = new BufferedOutputStream(Files.newOutputStream(target));
            return;
        }
        part = OutputLock.beside(target, ".part");
        lock = OutputLock.of(target, path);
        BEGUN.add(this);
        try {
            out = new BufferedOutputStream(open(there));
        } catch (IOException e) {
            remove();
            throw e;
        }
    }

    private OutputStream open(boolean there) throws IOException {
        Files.deleteIfExists(part);                           // of a killed process
        OutputStream opened = Files.newOutputStream(part, StandardOpenOption.CREATE_NEW, StandardOpenOption.WRITE);
        if (there && part.getFileSystem().supportedFileAttributeViews().contains("posix")) {
            Files.setPosixFilePermissions(part, Files.getPosixFilePermissions(target));
        }
        return opened;
    }

    /** {@return where to write; to be closed by {@link #commit} or {@link #close}} */
    public OutputStream out() {
        return out;
    }

    /**
     * Moves the file to its target: it is whole.
     *
     * @throws IOException if it cannot be written or moved; the target is then as it was
     */
    public void commit() throws IOException {
        out.close();
        if (lock != null) {
            Files.move(part, target, StandardCopyOption.ATOMIC_MOVE, StandardCopyOption.REPLACE_EXISTING);
        }
        whole = true;
    }

    /** Removes what was begun if it was not committed. */
    @Override
    public void close() throws IOException {
        try {
            out.close();
        } finally {
            remove();
        }
    }

    private synchronized void remove() throws IOException {
        if (lock == null || ended) {
            return;
        }
        ended = true;
        try {
            if (!whole) {
                Files.deleteIfExists(part);
            }
        } finally {
            BEGUN.remove(this);
            lock.close();
        }
    }

    /** The streams stay open: who still writes finds no error, and is about to end. */
    static void removeBegun() {
        for (AtomicFile file : BEGUN) {
            try {
                file.remove();
            } catch (IOException e) {
                continue;                                     // nobody is left to be told
            }
        }
    }
}
