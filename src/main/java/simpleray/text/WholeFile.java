package simpleray.text;

import java.io.BufferedOutputStream;
import java.io.Closeable;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.AccessDeniedException;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.StandardOpenOption;
import java.util.concurrent.atomic.AtomicInteger;

/**
 * A file in the making. It is written beside its target and moved over it when it is whole, so that the target is at all
 * times the old file or the new one. A target that is there and is no file, such as a device, is written to as it is.
 */
public final class WholeFile implements Closeable {
    private static final AtomicInteger COUNT = new AtomicInteger();

    private final Path target;
    private final Path part;             // equal to the target where nothing is to be moved
    private final OutputStream out;
    private boolean whole;

    /**
     * Makes sure that the file can be created, and begins it.
     *
     * @param path the target
     * @throws FileSystemException if it cannot be created; the reason says why
     * @throws IOException likewise
     */
    public WholeFile(Path path) throws IOException {
        if (Files.isDirectory(path)) {
            throw new FileSystemException(path.toString(), null, "is a folder");
        }
        boolean there = Files.exists(path);
        if (there && !Files.isWritable(path)) {
            throw new FileSystemException(path.toString(), null, "is write-protected");
        }
        target = there ? path.toRealPath() : followed(path.toAbsolutePath());
        Path folder = target.getParent();
        if (folder == null || !Files.isDirectory(folder)) {
            throw new FileSystemException(path.toString(), null, "there is no folder " + folder);
        }
        part = there && !Files.isRegularFile(target) ? target
            : folder.resolve(".simpleray-" + ProcessHandle.current().pid() + '-' + COUNT.incrementAndGet() + ".part");
        out = new BufferedOutputStream(open(path));
    }

    /** {@return where a link leads that leads to no file yet; the path itself if it is no link} */
    private static Path followed(Path path) throws IOException {
        return Files.isSymbolicLink(path) ? path.resolveSibling(Files.readSymbolicLink(path)).toAbsolutePath() : path;
    }

    private OutputStream open(Path path) throws IOException {
        if (part.equals(target)) {
            return Files.newOutputStream(target);
        }
        try {
            OutputStream opened = Files.newOutputStream(part, StandardOpenOption.CREATE_NEW, StandardOpenOption.WRITE);
            part.toFile().deleteOnExit();                     // should the program be told to stop before close
            if (Files.exists(target) && part.getFileSystem().supportedFileAttributeViews().contains("posix")) {
                Files.setPosixFilePermissions(part, Files.getPosixFilePermissions(target));
            }
            return opened;
        } catch (AccessDeniedException e) {
            throw (IOException) new FileSystemException(path.toString(), null, "its folder is write-protected").initCause(e);
        }
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
        if (!part.equals(target)) {
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
            if (!whole && !part.equals(target)) {
                Files.deleteIfExists(part);
            }
        }
    }
}
