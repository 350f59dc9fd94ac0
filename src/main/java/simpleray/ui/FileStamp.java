package simpleray.ui;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.BasicFileAttributes;
import java.nio.file.attribute.FileTime;
import java.time.Duration;
import java.time.Instant;

/**
 * What tells that a file is another than it was: an editor that writes in place changes its time, one that renames a new file over it
 * changes its key. <em>Constant.</em>
 *
 * @param there whether it can be read
 * @param size its size in bytes
 * @param time when it was changed last
 * @param key what the system knows it by; null where systems have no such thing
 */
record FileStamp(boolean there, long size, FileTime time, java.lang.Object key) {
    /** No file. */
    static final FileStamp NONE = new FileStamp(false, 0, FileTime.fromMillis(0), null);

    static FileStamp of(Path file) {
        try {
            BasicFileAttributes found = Files.readAttributes(file, BasicFileAttributes.class);
            return found.isDirectory() ? NONE : new FileStamp(true, found.size(), found.lastModifiedTime(), found.fileKey());
        } catch (IOException | SecurityException e) {
            return NONE;
        }
    }

    /**
     * {@return whether the file may have been changed without its stamp telling} Some disks count whole seconds: what is written
     * twice in one looks the same.
     */
    @SuppressWarnings("JavaInstantGetSecondsGetNano")         // whether the stamp is a whole second
    boolean isVague() {
        Instant instant = time.toInstant();
        return there && instant.getNano() == 0 && Duration.between(instant, Instant.now()).abs().toSeconds() < 2;
    }
}
