package simpleray.io;

import java.io.IOException;
import java.nio.file.AccessDeniedException;
import java.nio.file.AccessMode;
import java.nio.file.Files;
import java.nio.file.Path;

/** A file that is to be read. */
public final class InputFile {
    private InputFile() {
    }

    /**
     * Finds out why a file cannot be opened. It is not asked before each file is opened, since that takes time.
     *
     * @param path the file
     * @return the reason, for people; null if there is none in sight
     */
    public static String refusal(Path path) {
        if (Files.isDirectory(path)) {
            return folderReason(path);
        }
        try {
            path.getFileSystem().provider().checkAccess(path, AccessMode.READ);
            return null;
        } catch (AccessDeniedException e) {                   // the file, or a folder on the way to it
            return "may not be read";
        } catch (IOException e) {
            return "no such file";
        }
    }

    /**
     * Tells why a folder is no file. The empty name is one, too: the working directory.
     *
     * @param path the folder
     * @return the reason, for people
     */
    public static String folderReason(Path path) {
        return path.toString().isEmpty() ? "the name is empty" : "is a folder";
    }
}
