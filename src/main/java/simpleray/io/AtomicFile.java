package simpleray.io;

import java.io.BufferedOutputStream;
import java.io.Closeable;
import java.io.EOFException;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.channels.FileChannel;
import java.nio.file.AccessDeniedException;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.StandardOpenOption;
import java.nio.file.attribute.PosixFilePermission;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.Consumer;

/**
 * A file in the making. It is written beside its target and moved over it when it is whole, so that the target is at all
 * times the old file or the new one. A target that is there and is no file, such as a device, is written to as it is.
 *
 * <p>One target has one file in the making at a time. What a killed process left of its own is used again by the next.
 *
 * <p>Not every disk can do all of this. Where the folder takes no new file, or the target cannot be replaced, it is overwritten in place, once
 * the new file is whole elsewhere; where nothing can be locked, or permissions cannot be set, it is written without that. Then there is a note.
 */
public final class AtomicFile implements Closeable {
    /** Those to be removed should the program be told to stop before they are whole. */
    private static final Set<AtomicFile> BEGUN = ConcurrentHashMap.newKeySet();
    private static final Object BEGINNING = new Object();
    private static boolean ending;                            // then no more are begun

    private static final String PART = ".part";

    private final Path target;
    private final OutputLock lock;       // null where nothing is to be moved
    private final OutputStream out;
    private final Consumer<String> notes;
    private final List<String> noted = new ArrayList<>();
    private Path part;                   // null there
    private boolean elsewhere;           // the part is not in the target's folder
    private boolean whole;
    private boolean kept;                // the part is all that is left
    private boolean ended;

    static {
        Runtime.getRuntime().addShutdownHook(new Thread("simpleray-deleting") {
            @Override
            public void run() {
                synchronized (BEGINNING) {
                    ending = true;
                }
                removeBegun();
            }
        });
    }

    /**
     * Makes sure that the file can be created, and begins it.
     *
     * @param path the target
     * @param notes told, at the end, in what way it could not be written as files usually are; a line
     * @throws FileInUseException if somebody else is making it
     * @throws FileSystemException if it cannot be created; the reason says why
     * @throws IOException likewise
     */
    public AtomicFile(Path path, Consumer<String> notes) throws IOException {
        this.notes = notes;
        if (Files.isDirectory(path)) {
            throw new FileSystemException(path.toString(), null, InputFile.folderReason(path));
        }
        if (OutputTarget.isStream(path)) {
            target = path;
            lock = null;
            out = OutputTarget.open(path);
            return;
        }
        boolean there = Files.exists(path);
        if (there && !Files.isWritable(path)) {
            throw new FileSystemException(path.toString(), null, "is write-protected");
        }
        target = OutputTarget.file(path);
        synchronized (BEGINNING) {
            if (ending) {
                throw new IOException("the program is told to stop");
            }
            lock = OutputLock.of(target, path);
            BEGUN.add(this);
            try {
                out = new BufferedOutputStream(begin(there));
            } catch (IOException e) {
                remove();
                throw e;
            }
        }
    }

    /**
     * Makes sure that the file can be created, and begins it. Nobody is told how.
     *
     * @param path the target
     * @throws FileInUseException if somebody else is making it
     * @throws FileSystemException if it cannot be created; the reason says why
     * @throws IOException likewise
     */
    public AtomicFile(Path path) throws IOException {
        this(path, note -> { });
    }

    private OutputStream begin(boolean there) throws IOException {
        if (there) {
            Files.newByteChannel(target, StandardOpenOption.WRITE).close();   // it may have to be overwritten
        }
        IOException refused;
        try {
            OutputStream begun = beginBeside();
            if (there) {
                keepPermissions();
            }
            return begun;
        } catch (IOException e) {
            refused = e;
        }
        try {
            part = there ? Files.createTempFile("simpleray-", PART) : null;
        } catch (IOException e) {
            refused.addSuppressed(e);
        }
        if (part == null) {
            throw refused instanceof AccessDeniedException
                ? new FileSystemException(target.toString(), null, "its folder is write-protected") : refused;
        }
        elsewhere = true;
        noted.add("its folder takes no new file (" + OutputTarget.reason(refused) + "): the old file is overwritten in place");
        return Files.newOutputStream(part);
    }

    /** Begins the part beside the target, under a name that nobody else has if the usual one cannot be had. */
    private OutputStream beginBeside() throws IOException {
        if (lock.refusal() == null) {
            part = OutputTarget.beside(target, PART);
            deletePart();                                     // of a killed process
            try {
                return Files.newOutputStream(part, StandardOpenOption.CREATE, StandardOpenOption.TRUNCATE_EXISTING,
                    StandardOpenOption.WRITE, LinkOption.NOFOLLOW_LINKS);
            } catch (IOException e) {                         // as if another user's killed process has left one
                part = null;
            }
        }
        Path other = OutputTarget.beside(target, '-' + Long.toHexString(System.nanoTime()) + PART);
        OutputStream begun = Files.newOutputStream(other, StandardOpenOption.CREATE_NEW, StandardOpenOption.WRITE);
        part = other;
        if (lock.refusal() != null) {
            noted.add(lock.refusal());
        }
        return begun;
    }

    private void keepPermissions() {
        if (!part.getFileSystem().supportedFileAttributeViews().contains("posix")) {
            return;
        }
        try {
            Set<PosixFilePermission> old = Files.getPosixFilePermissions(target);
            if (!Files.getPosixFilePermissions(part).equals(old)) {
                Files.setPosixFilePermissions(part, old);
            }
        } catch (IOException e) {
            noted.add("the old file's permissions cannot be kept (" + OutputTarget.reason(e) + ')');
        }
    }

    /** {@return where to write; to be closed by {@link #commit} or {@link #close}} */
    public OutputStream out() {
        return out;
    }

    /** {@return the file that is being written, for another program to write it} If the target is no file, that itself. */
    public Path file() {
        return part == null ? target : part;
    }

    /**
     * Moves the file to its target: it is whole.
     *
     * @throws IOException if it cannot be written or moved; the target is then as it was, unless the reason says otherwise
     */
    public void commit() throws IOException {
        out.close();
        if (lock == null) {
            return;
        }
        synchronized (this) {
            if (ended) {                                      // and the part may be another's by now
                throw new IOException("the program is told to stop");
            }
            if (elsewhere) {
                overwrite();
            } else {
                try {
                    Files.move(part, target, StandardCopyOption.ATOMIC_MOVE, StandardCopyOption.REPLACE_EXISTING);
                } catch (IOException e) {
                    overwrite();
                    noted.add("cannot be replaced (" + OutputTarget.reason(e) + "): it was overwritten in place");
                }
            }
            whole = true;
        }
    }

    /** {@return whether it is whole in its place} If it is being moved there now, this waits for that. */
    public synchronized boolean isWhole() {
        return whole;
    }

    /**
     * Overwrites the target. Its length changes first, so that a disk that is too full or cannot cut a file off is noticed while the old
     * file is whole.
     */
    private void overwrite() throws IOException {
        boolean there = Files.exists(target);
        try (FileChannel from = FileChannel.open(part, StandardOpenOption.READ);
             FileChannel to = FileChannel.open(target, StandardOpenOption.WRITE,
                 there ? StandardOpenOption.WRITE : StandardOpenOption.CREATE_NEW)) {
            long old = to.size();
            try {
                copy(from, to, old, from.size());
            } catch (IOException e) {
                to.truncate(old);
                if (!there) {
                    Files.delete(target);
                }
                throw e;
            }
            if (old > from.size()) {
                to.truncate(from.size());
            }
            try {
                copy(from, to, 0, Math.min(old, from.size()));
            } catch (IOException e) {
                kept = true;
                throw new IOException(OutputTarget.reason(e) + " (the whole file is " + part + ')', e);
            }
        }
    }

    private static void copy(FileChannel from, FileChannel to, long begin, long end) throws IOException {
        to.position(begin);
        for (long at = begin; at < end;) {
            long count = from.transferTo(at, end - at, to);
            if (count <= 0) {
                throw new EOFException("the file in the making has been cut off");
            }
            at += count;
        }
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

    private synchronized void remove() {
        if (lock == null || ended) {
            return;
        }
        ended = true;
        if (!whole) {
            noted.clear();
        }
        if (part != null && !kept) {
            IOException failure = deletePart();
            if (failure != null) {
                noted.add(part + " cannot be deleted: " + OutputTarget.reason(failure));
            }
        }
        BEGUN.remove(this);
        try {
            lock.close();
        } catch (IOException e) {
            noted.add(lock.file() + " cannot be deleted: " + OutputTarget.reason(e));
        }
        if (!noted.isEmpty()) {
            notes.accept(String.join("; ", noted));
        }
    }

    /** {@return why the part cannot be deleted; null if it is gone} */
    private IOException deletePart() {
        try {
            Files.deleteIfExists(part);
            return null;
        } catch (IOException e) {
            return e;
        }
    }

    /** The streams stay open: who still writes finds no error, and is about to end. */
    static void removeBegun() {
        for (AtomicFile file : BEGUN) {
            file.remove();
        }
    }
}
