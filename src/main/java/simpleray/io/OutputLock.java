package simpleray.io;

import java.io.Closeable;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.channels.OverlappingFileLockException;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.HashSet;
import java.util.Set;

/**
 * The right to write a file, which one alone has at a time: a lock of the system on a small file beside it. The lock ends with its process,
 * however that ends; what a killed process left is used again. <em>Mutable.</em>
 *
 * <p>Who has the lock deletes the file in the end, and then marks it: another process may have opened it before, and would lock a file that
 * nobody finds any more. It sees the mark, and opens the file anew.
 *
 * <p>Not every disk locks files, and not every folder takes one: then there is a lock in name only, which says so.
 */
public final class OutputLock implements Closeable {
    /** The first byte of a file that was deleted. */
    static final byte DELETED = -1;
    private static final byte IN_USE = 0;
    /** Milliseconds between the lock and the first byte, at most. */
    private static final int PATIENCE = 200;
    /** Those of this process. Nobody opens such a file twice: closing it once would end the lock of the other, too. */
    private static final Set<Path> HELD = new HashSet<>();

    private final Path file;
    private final String refusal;
    private FileChannel channel;

    /**
     * Locks.
     *
     * @param file the file to lock; made, and deleted in the end
     * @param target what messages call the file that is to be written
     * @throws FileInUseException if it is locked already
     * @throws NoRoomException if the disk is full
     * @throws IOException if it cannot be locked
     */
    OutputLock(Path file, String target) throws IOException {
        this.file = file;
        refusal = null;
        synchronized (HELD) {
            if (isHeld(file)) {
                throw new FileInUseException(target);
            }
            HELD.add(file);
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

    /** A lock in name only. */
    private OutputLock(Path file, IOException refused) {
        this.file = file;
        refusal = "cannot be locked (" + OutputTarget.reason(refused) + "): another run that writes it at the same time is not noticed";
    }

    /** The first byte of a file cannot be written. */
    private static final class NoRoomException extends IOException {
        private static final long serialVersionUID = 1L;

        NoRoomException(IOException cause) {
            super(cause.getMessage(), cause);
        }
    }

    /**
     * Takes the right to write a file.
     *
     * @param path the file, which need not be there; its folder must
     * @return the lock
     * @throws FileInUseException if somebody has it already
     * @throws java.nio.file.FileSystemException if there can be no such file; the reason says why
     * @throws IOException if there is no room for a lock
     */
    public static OutputLock of(Path path) throws IOException {
        return of(OutputTarget.file(path), path);
    }

    /** Locks a file whose real name is known. */
    static OutputLock of(Path target, Path told) throws IOException {
        Path file = OutputTarget.beside(target, ".lock");
        try {
            return new OutputLock(file, told.toString());
        } catch (FileInUseException | NoRoomException e) {
            throw e;
        } catch (IOException e) {
            return new OutputLock(file, e);
        }
    }

    /** {@return whether this process has locked a file, by this name or by another that the disk takes for the same} */
    private static boolean isHeld(Path file) {
        for (Path held : HELD) {
            try {
                if (Files.isSameFile(held, file)) {
                    return true;
                }
            } catch (IOException e) {
                continue;                                     // one of them is not there
            }
        }
        return false;
    }

    /** Locks the file; returns false if it was deleted before it was locked. */
    private boolean lock(String target) throws IOException {
        channel = FileChannel.open(file, StandardOpenOption.CREATE, StandardOpenOption.READ, StandardOpenOption.WRITE,
            LinkOption.NOFOLLOW_LINKS);
        try {
            if (channel.tryLock() == null) {
                if (isMarked()) {
                    throw new FileInUseException(target);
                }
                throw new IOException("permission denied");   // by the disk, which says nothing else than who has the lock would
            }
        } catch (OverlappingFileLockException e) {            // this process has just made it under another name
            throw (IOException) new FileInUseException(target).initCause(e);
        } catch (FileInUseException e) {
            throw e;
        } catch (IOException e) {                             // no locks here
            delete(e);
            throw e;
        }
        ByteBuffer mark = ByteBuffer.allocate(1);
        if (channel.read(mark, 0) > 0 && mark.get(0) == DELETED) {
            channel.close();
            return false;
        }
        try {
            mark(IN_USE);
        } catch (IOException e) {                             // a full disk
            delete(e);
            throw new NoRoomException(e);
        }
        return true;
    }

    /** {@return whether somebody has locked the file: who has just done it is about to write into it} */
    private boolean isMarked() throws IOException {
        for (int i = 0; i < PATIENCE && channel.size() == 0; i++) {
            try {
                Thread.sleep(1);
            } catch (InterruptedException e) {
                Thread.currentThread().interrupt();
                return true;
            }
        }
        return channel.size() > 0;
    }

    private void mark(byte mark) throws IOException {
        channel.write(ByteBuffer.wrap(new byte[] {mark}), 0);
    }

    private void delete(IOException cause) {
        try {
            Files.deleteIfExists(file);
        } catch (IOException e) {
            cause.addSuppressed(e);
        }
    }

    /** {@return the file that is locked} */
    Path file() {
        return file;
    }

    /** {@return what is to be said if there is no lock; null if there is one} */
    public String refusal() {
        return refusal;
    }

    /**
     * Deletes the file and ends the lock.
     *
     * @throws IOException if the file stays
     */
    @Override
    public void close() throws IOException {
        if (channel == null || !channel.isOpen()) {
            return;
        }
        try {
            Files.deleteIfExists(file);
            mark(DELETED);
        } catch (IOException e) {
            if (Files.exists(file)) {
                throw e;
            }
        } finally {
            release();
        }
    }

    private void release() {
        try {
            if (channel != null) {
                channel.close();
            }
        } catch (IOException e) {
            return;                                           // it is closed all the same
        } finally {
            synchronized (HELD) {
                HELD.remove(file);
            }
        }
    }
}
