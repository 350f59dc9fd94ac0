package simpleray.ui.file;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.BasicFileAttributes;
import java.nio.file.attribute.FileTime;
import java.time.Duration;
import java.time.Instant;
import java.util.Objects;
import java.util.zip.CRC32;

/**
 * What shows that a file has changed: an editor that writes in place changes its time, one that renames a new file over it changes its
 * key. Some disks count whole seconds: while a file may be written again in the same one, its bytes count, too. <em>Constant.</em>
 *
 * @param there whether it can be read
 * @param size its size in bytes
 * @param time when it was changed last
 * @param key what the system knows it by; null where systems have no such thing
 * @param sum a check sum of its bytes if its time may not show a change; else 0
 */
record FileStamp(boolean there, long size, FileTime time, java.lang.Object key, long sum) {
    /** No file. */
    static final FileStamp NONE = new FileStamp(false, 0, FileTime.fromMillis(0), null, 0);

    private static final long MAX_SUMMED = 8L << 20;
    private static final Duration COARSE = Duration.ofSeconds(2);

    static FileStamp of(Path file) {
        return of(file, Instant.now());
    }

    static FileStamp of(Path file, Instant now) {
        try {
            BasicFileAttributes found = Files.readAttributes(file, BasicFileAttributes.class);
            return found.isDirectory() ? NONE
                : new FileStamp(true, found.size(), found.lastModifiedTime(), found.fileKey(), sum(file, found, now));
        } catch (IOException | SecurityException e) {
            return NONE;
        }
    }

    @SuppressWarnings("JavaInstantGetSecondsGetNano")         // whether the stamp is a whole second
    private static long sum(Path file, BasicFileAttributes found, Instant now) throws IOException {
        Instant time = found.lastModifiedTime().toInstant();
        if (!found.isRegularFile() || found.size() > MAX_SUMMED || time.getNano() != 0
            || Duration.between(time, now).abs().compareTo(COARSE) >= 0) {
            return 0;
        }
        CRC32 sum = new CRC32();
        sum.update(Files.readAllBytes(file));
        return sum.getValue();
    }

    /** {@return whether the file is the same, as far as both stamps tell} */
    boolean isSame(FileStamp other) {
        return there == other.there && size == other.size && time.equals(other.time) && Objects.equals(key, other.key)
            && (sum == other.sum || sum == 0 || other.sum == 0);
    }
}
