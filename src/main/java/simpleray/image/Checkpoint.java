package simpleray.image;

import java.io.Closeable;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.charset.StandardCharsets;
import java.nio.file.AccessDeniedException;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.zip.CRC32;
import simpleray.io.FileInUseException;
import simpleray.io.OutputLock;

/**
 * A file of the finished rows of a picture, from which an interrupted rendering resumes. <em>Mutable</em>; any thread may call.
 * An {@link OutputLock} beside it keeps other renderings out.
 *
 * <p>It begins with {@link #MAGIC}, the length of a text, that text, and the CRC-32 of all these. The text names all that the picture
 * depends on, a line {@code name: value} each. Records of one size follow, in the order in which rows were finished: the row's
 * number, its levels, and the CRC-32 of both. Numbers have four bytes, the highest first. A record with a wrong sum is ignored.
 *
 * <p>Each record is written by one system call, and then survives any end of this program. Nothing waits for the disk:
 * the sums find rows that a loss of power left half written.
 */
public final class Checkpoint implements Closeable {
    private static final byte[] MAGIC = "SimpleRay checkpoint 1\n".getBytes(StandardCharsets.US_ASCII);
    private static final int HEAD = MAGIC.length + Integer.BYTES;
    /** No text is longer, in bytes. */
    private static final int LONGEST_TEXT = 1 << 16;
    private static final int NONE = -1;

    private final Path path;
    private final OutputLock lock;                            // nobody else reads or writes the file
    private final FileChannel file;
    private final int height;
    private final int rowBytes;
    private final int recordBytes;
    private final int begin;                                  // of the first record
    private final int[] records;                              // of each row, NONE if it has none
    private final ByteBuffer record;                          // used by one thread at a time
    private int written;                                      // records
    private int count;                                        // rows

    private Checkpoint(Path path, OutputLock lock, FileChannel file, int rowBytes, int height, int begin) {
        this.path = path;
        this.lock = lock;
        this.file = file;
        this.height = height;
        this.begin = begin;
        this.rowBytes = rowBytes;
        recordBytes = Integer.BYTES + rowBytes + Integer.BYTES;
        record = ByteBuffer.allocate(recordBytes);
        records = new int[height];
        Arrays.fill(records, NONE);
    }

    /**
     * Begins a checkpoint without rows.
     *
     * @param path the file, which is not there
     * @param identity all that the picture depends on
     * @param rowBytes the number of a row's levels
     * @param height the picture's height in pixels
     * @return the checkpoint
     * @throws FileInUseException if another rendering has it, or has made it
     * @throws FileSystemException if it cannot be created
     * @throws IOException if it cannot be written
     */
    public static Checkpoint create(Path path, Map<String, String> identity, int rowBytes, int height) throws IOException {
        byte[] head = head(identity);
        return locked(path, lock -> {
            if (Files.exists(path)) {                         // since somebody looked
                throw new FileInUseException(path.toString());
            }
            FileChannel file = begin(path);
            Checkpoint checkpoint = new Checkpoint(path, lock, file, rowBytes, height, head.length);
            try {
                writeAll(file, ByteBuffer.wrap(head), 0);
                return checkpoint;
            } catch (IOException e) {
                file.close();
                Files.delete(path);
                throw e;
            }
        });
    }

    /**
     * Opens a checkpoint to go on with it. A record that was not written whole is cut off.
     *
     * @param path the file
     * @param identity the text that {@link #identity} returned
     * @param rowBytes the number of a row's levels
     * @param height the picture's height in pixels
     * @return the checkpoint
     * @throws FileInUseException if another rendering has it, or has removed or changed it since
     * @throws IOException if it cannot be read
     */
    public static Checkpoint open(Path path, Map<String, String> identity, int rowBytes, int height) throws IOException {
        return locked(path, lock -> {
            if (!Files.exists(path) || !identity.equals(identity(path))) {
                throw new FileInUseException(path.toString());
            }
            FileChannel file = FileChannel.open(path, StandardOpenOption.READ, StandardOpenOption.WRITE);
            try {
                Checkpoint checkpoint = new Checkpoint(path, lock, file, rowBytes, height, head(identity).length);
                checkpoint.load();
                return checkpoint;
            } catch (IOException e) {
                file.close();
                throw e;
            }
        });
    }

    private static FileChannel begin(Path path) throws IOException {
        try {
            return FileChannel.open(path, StandardOpenOption.CREATE_NEW, StandardOpenOption.READ, StandardOpenOption.WRITE);
        } catch (FileAlreadyExistsException e) {              // another has made it where nothing can be locked
            throw (IOException) new FileInUseException(path.toString()).initCause(e);
        } catch (AccessDeniedException e) {
            throw (IOException) new FileSystemException(path.toString(), null, "its folder is write-protected").initCause(e);
        }
    }

    /** An action on a file that nobody else reads or writes. */
    private interface Use {
        Checkpoint of(OutputLock lock) throws IOException;
    }

    /** Locks a file, and keeps the lock only for a checkpoint. */
    private static Checkpoint locked(Path path, Use use) throws IOException {
        OutputLock lock = OutputLock.of(path);
        Checkpoint checkpoint = null;
        try {
            checkpoint = use.of(lock);
            return checkpoint;
        } finally {
            if (checkpoint == null) {
                lock.close();
            }
        }
    }

    /**
     * Reads the identity of a checkpoint's picture.
     *
     * @param path the file
     * @return names and values; null if the file was not begun whole, and so has no row
     * @throws FileSystemException if it is no checkpoint; the reason says so
     * @throws IOException if it cannot be read
     */
    public static Map<String, String> identity(Path path) throws IOException {
        if (Files.isDirectory(path)) {
            throw new FileSystemException(path.toString(), null, "is a folder");
        }
        try (FileChannel file = FileChannel.open(path, StandardOpenOption.READ)) {
            ByteBuffer head = ByteBuffer.allocate(HEAD);
            int got = readAll(file, head, 0);
            int magic = Math.min(got, MAGIC.length);
            if (!Arrays.equals(head.array(), 0, magic, MAGIC, 0, magic)) {
                throw new FileSystemException(path.toString(), null, "is no checkpoint");
            }
            int length = got < HEAD ? NONE : head.getInt(MAGIC.length);
            if (length < 0 || length > LONGEST_TEXT) {
                return null;
            }
            ByteBuffer all = ByteBuffer.allocate(HEAD + length + Integer.BYTES);
            boolean whole = readAll(file, all, 0) == all.capacity() && all.getInt(HEAD + length) == sum(all.array(), HEAD + length);
            return whole ? lines(new String(all.array(), HEAD, length, StandardCharsets.UTF_8)) : null;
        }
    }

    /**
     * Removes a checkpoint.
     *
     * @param path the file
     * @throws FileSystemException if it is no checkpoint
     * @throws FileInUseException if another rendering has it
     * @throws IOException if it cannot be removed
     */
    public static void delete(Path path) throws IOException {
        locked(path, lock -> {
            if (Files.exists(path)) {                         // else who had it has removed it
                identity(path);
                Files.delete(path);
            }
            return null;
        });
    }

    private static byte[] head(Map<String, String> identity) {
        StringBuilder text = new StringBuilder();
        identity.forEach((name, value) -> text.append(name).append(": ").append(value).append('\n'));
        byte[] bytes = text.toString().getBytes(StandardCharsets.UTF_8);
        ByteBuffer head = ByteBuffer.allocate(HEAD + bytes.length + Integer.BYTES).put(MAGIC).putInt(bytes.length).put(bytes);
        return head.putInt(sum(head.array(), head.position())).array();
    }

    private static Map<String, String> lines(String text) {
        Map<String, String> identity = new LinkedHashMap<>();
        text.lines().forEach(line -> identity.put(line.substring(0, line.indexOf(": ")), line.substring(line.indexOf(": ") + 2)));
        return identity;
    }

    private synchronized void load() throws IOException {
        written = (int) Math.min(Integer.MAX_VALUE, Math.max(0, file.size() - begin) / recordBytes);
        try {
            file.truncate(position(written));
        } catch (IOException e) {
            // then the next record is written over it
        }
        for (int i = 0; i < written; i++) {
            int y = read(i);
            if (y != NONE && records[y] == NONE) {
                records[y] = i;
                count++;
            }
        }
    }

    /** Reads a record; returns the number of its row, NONE if it is not whole. */
    private int read(int i) throws IOException {
        record.clear();
        if (readAll(file, record, position(i)) < recordBytes || record.getInt(Integer.BYTES + rowBytes) != recordSum()) {
            return NONE;
        }
        int y = record.getInt(0);
        return y >= 0 && y < height ? y : NONE;
    }

    private long position(int i) {
        return begin + (long) i * recordBytes;
    }

    private int recordSum() {
        return sum(record.array(), Integer.BYTES + rowBytes);
    }

    private static int sum(byte[] bytes, int length) {
        CRC32 crc = new CRC32();
        crc.update(bytes, 0, length);
        return (int) crc.getValue();
    }

    /**
     * Keeps a row. One that is kept already stays as it is.
     *
     * @param y its number, 0 at the top
     * @param levels holds red, green and blue of each pixel from the left, and its alpha if there is any
     * @param from where in it they begin
     * @throws IOException if it cannot be written
     */
    public synchronized void put(int y, byte[] levels, int from) throws IOException {
        if (records[y] != NONE) {
            return;
        }
        record.clear().putInt(y).put(levels, from, rowBytes);
        record.putInt(recordSum()).flip();
        writeAll(file, record, position(written));
        records[y] = written++;
        count++;
    }

    /**
     * Finds a row.
     *
     * @param y its number, 0 at the top
     * @return red, green and blue of each pixel from the left, and its alpha if there is any, 0 to 255 each, a new array; null if it is not
     *     kept
     * @throws IOException if it cannot be read
     */
    public synchronized byte[] levels(int y) throws IOException {
        if (records[y] == NONE) {
            return null;
        }
        if (read(records[y]) != y) {                          // somebody wrote into the file
            records[y] = NONE;
            count--;
            return null;
        }
        return Arrays.copyOfRange(record.array(), Integer.BYTES, Integer.BYTES + rowBytes);
    }

    /** {@return what is to be said if the file is not locked; null if it is} */
    public String lockRefusal() {
        return lock.refusal();
    }

    /** {@return how many rows are kept} */
    public synchronized int count() {
        return count;
    }

    /** Ends the writing; the file stays. */
    @Override
    public synchronized void close() throws IOException {
        try {
            file.close();
        } finally {
            lock.close();
        }
    }

    /**
     * Ends the writing and removes the file, before anybody else can have it.
     *
     * @throws IOException if it cannot be removed
     */
    public synchronized void remove() throws IOException {
        try {
            file.close();
            Files.deleteIfExists(path);
        } finally {
            lock.close();
        }
    }

    private static int readAll(FileChannel file, ByteBuffer buffer, long position) throws IOException {
        int got = 0;
        while (buffer.hasRemaining()) {
            int some = file.read(buffer, position + got);
            if (some < 0) {
                break;
            }
            got += some;
        }
        return got;
    }

    private static void writeAll(FileChannel file, ByteBuffer buffer, long position) throws IOException {
        long at = position;
        while (buffer.hasRemaining()) {
            at += file.write(buffer, at);
        }
    }
}
