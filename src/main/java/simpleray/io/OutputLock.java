package simpleray.io;

import java.io.Closeable;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.charset.StandardCharsets;
import java.nio.file.AccessDeniedException;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.nio.file.attribute.BasicFileAttributes;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.zip.CRC32;

/**
 * The right to write a file, which one alone has at a time: a lock of the system on a small file beside it. The lock ends with its process,
 * however that ends; what a killed process left is used again. <em>Mutable.</em>
 *
 * <p>Who has the lock deletes the file in the end, and then marks it: another process may have opened it before, and would lock a file that
 * nobody finds any more. It sees the mark, and opens the file anew.
 */
public final class OutputLock implements Closeable {
    /** The first byte of a file that was deleted. */
    static final byte DELETED = -1;
    private static final byte IN_USE = 0;
    /** Those of this process. Nobody opens such a file twice: closing it once would end the lock of the other, too. */
    private static final Set<Path> HELD = ConcurrentHashMap.newKeySet();

    private final Path file;
    private FileChannel channel;

    /**
     * Locks.
     *
     * @param file the file to lock; made, and deleted in the end
     * @param target what messages call the file that is to be written
     * @throws FileInUseException if it is locked already
     * @throws IOException if it cannot be locked
     */
    OutputLock(Path file, String target) throws IOException {
        this.file = file;
        if (!HELD.add(file)) {
            throw new FileInUseException(target);
        }
        boolean held = false;
        try {
            do {
                held = lock(target);
            } while (!held);
        } finally {
            if (!held) {
                release();
            }
        }
    }

    /**
     * Takes the right to write a file.
     *
     * @param path the file, which need not be there; its folder must
     * @return the lock
     * @throws FileInUseException if somebody has it already
     * @throws FileSystemException if it cannot be locked; the reason says why
     * @throws IOException likewise
     */
    public static OutputLock of(Path path) throws IOException {
        return of(target(path), path);
    }

    /** Locks a file whose real name is known. */
    static OutputLock of(Path target, Path told) throws IOException {
        try {
            return new OutputLock(beside(target, ".lock"), told.toString());
        } catch (AccessDeniedException e) {
            throw (IOException) new FileSystemException(told.toString(), null, "its folder is write-protected").initCause(e);
        }
    }

    /**
     * Finds the file that a name stands for, which need not be there.
     *
     * @throws FileSystemException if there can be no such file; the reason says why
     */
    static Path target(Path path) throws IOException {
        Path target;
        try {
            target = path.toRealPath();
        } catch (IOException e) {                             // mostly because it is not there yet
            target = followed(path.toAbsolutePath());
        }
        Path folder = target.getParent();
        if (folder == null || !Files.isDirectory(folder)) {
            throw new FileSystemException(path.toString(), null, "there is no folder " + folder);
        }
        try {
            Files.readAttributes(target, BasicFileAttributes.class);
        } catch (FileSystemException e) {
            if (e.getReason() != null) {                      // not because there is none yet, but because it cannot be, as a name too long
                throw new FileSystemException(path.toString(), null, e.getReason());
            }
        }
        return target;
    }

    /** {@return where a link leads that leads to no file yet; the path itself if it is no link} */
    private static Path followed(Path path) throws IOException {
        return Files.isSymbolicLink(path) ? path.resolveSibling(Files.readSymbolicLink(path)).toAbsolutePath() : path;
    }

    /**
     * {@return the name of a file that lies beside another only while that is written} It ends as is asked for. A name may be as long as
     * names may be, and then nothing can be added: its checksum stands for it.
     */
    static Path beside(Path target, String ending) throws IOException {
        CRC32 name = new CRC32();
        name.update(String.valueOf(target.getFileName()).getBytes(StandardCharsets.UTF_8));
        return target.resolveSibling(".").toRealPath().resolve(".simpleray-" + Long.toHexString(name.getValue()) + ending);
    }

    /** Locks the file; returns false if it was deleted before it was locked. */
    private boolean lock(String target) throws IOException {
        channel = FileChannel.open(file, StandardOpenOption.CREATE, StandardOpenOption.READ, StandardOpenOption.WRITE,
            LinkOption.NOFOLLOW_LINKS);
        if (channel.tryLock() == null) {
            throw new FileInUseException(target);
        }
        ByteBuffer mark = ByteBuffer.allocate(1);
        if (channel.read(mark, 0) > 0 && mark.get(0) == DELETED) {
            channel.close();
            return false;
        }
        try {
            mark(IN_USE);
        } catch (IOException e) {                             // a full disk
            Files.delete(file);
            throw e;
        }
        return true;
    }

    private void mark(byte mark) throws IOException {
        channel.write(ByteBuffer.wrap(new byte[] {mark}), 0);
    }

    /** {@return the file that is locked} */
    Path file() {
        return file;
    }

    /** Deletes the file and ends the lock. */
    @Override
    public void close() throws IOException {
        if (!channel.isOpen()) {
            return;
        }
        try {
            Files.deleteIfExists(file);
            mark(DELETED);
        } finally {
            release();
        }
    }

    private void release() throws IOException {
        try {
            if (channel != null) {
                channel.close();
            }
        } finally {
            HELD.remove(file);
        }
    }
}
