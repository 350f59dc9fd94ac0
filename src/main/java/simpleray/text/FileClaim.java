package simpleray.text;

import java.io.Closeable;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.channels.FileLock;
import java.nio.file.AccessDeniedException;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.nio.file.attribute.BasicFileAttributes;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.ThreadLocalRandom;

/**
 * The right to write a file, which one alone has at a time: a lock on an empty file beside it. The lock ends with its process, however
 * that ends; an empty file that a killed process left is used again. <em>Mutable.</em>
 */
public final class FileClaim implements Closeable {
    /** Those of this process. Nobody opens such a file twice: closing it once would end the lock of the other, too. */
    private static final Set<Path> HELD = ConcurrentHashMap.newKeySet();
    private static final int SIZES = 1 << 12;
    /** Two files have the same size so many times by chance less than once in 1e14. */
    private static final int TIMES = 4;
    private static final String BEGINNING = ".simpleray-";
    private static final long FNV_BASE = 0xcbf29ce484222325L;
    private static final long FNV_PRIME = 0x100000001b3L;

    private final Path file;
    private FileChannel channel;

    /**
     * Claims.
     *
     * @param file the file to lock; made, and deleted in the end
     * @param target what messages call the file that is to be written
     * @throws FileInUseException if it is claimed already
     * @throws IOException if it cannot be locked
     */
    FileClaim(Path file, String target) throws IOException {
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
     * Claims the right to write a file.
     *
     * @param path the file, which need not be there; its folder must
     * @return the claim
     * @throws FileInUseException if it is claimed already
     * @throws FileSystemException if it cannot be claimed; the reason says why
     * @throws IOException likewise
     */
    public static FileClaim of(Path path) throws IOException {
        return of(target(path), path);
    }

    /** Claims a file whose real name is known. */
    static FileClaim of(Path target, Path told) throws IOException {
        try {
            return new FileClaim(beside(target, ".lock"), told.toString());
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

    /** {@return the name of a file that lies beside another only while that is written} It ends as is asked for. */
    static Path beside(Path target, String ending) throws IOException {
        return target.resolveSibling(".").toRealPath().resolve(BEGINNING + number(String.valueOf(target.getFileName())) + ending);
    }

    /** {@return a number for a name} A name may be as long as names may be, and then nothing can be added (FNV-1a, 64 bits). */
    private static String number(String name) {
        long hash = FNV_BASE;
        for (int i = 0; i < name.length(); i++) {
            hash = (hash ^ name.charAt(i)) * FNV_PRIME;
        }
        return Long.toHexString(hash);
    }

    /**
     * Locks the file. Whoever had it may have deleted it meanwhile, and a third may have made a new one: then ours is locked, but is
     * nobody's any more. Its size is changed a few times, and looked at by its name, to see whether it is the same; opening it once more
     * would end the lock.
     *
     * @return whether it is
     */
    private boolean lock(String target) throws IOException {
        channel = FileChannel.open(file, StandardOpenOption.CREATE, StandardOpenOption.WRITE,
            LinkOption.NOFOLLOW_LINKS);
        FileLock lock = channel.tryLock();
        if (lock == null) {
            throw new FileInUseException(target);
        }
        try {
            boolean same = true;
            for (int i = 0; i < TIMES && same; i++) {
                same = takesSize(1 + ThreadLocalRandom.current().nextInt(SIZES));
            }
            if (same) {
                return true;
            }
        } catch (NoSuchFileException e) {
            channel.close();                                  // deleted: once more
            return false;
        } catch (IOException e) {                             // a full disk
            if (Files.exists(file) && Files.size(file) == 0) {
                Files.delete(file);                           // as whoever has it gave it a size, it is ours
            }
            throw e;
        }
        channel.close();
        return false;
    }

    private boolean takesSize(int size) throws IOException {
        channel.truncate(0);
        channel.write(ByteBuffer.allocate(1), size - 1);
        return Files.size(file) == size;
    }

    /** {@return the file that is locked} */
    Path file() {
        return file;
    }

    /** Deletes the file and then ends the lock, so that nobody gets the lock of a file that is to be deleted and believes in it. */
    @Override
    public void close() throws IOException {
        try {
            Files.deleteIfExists(file);
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
