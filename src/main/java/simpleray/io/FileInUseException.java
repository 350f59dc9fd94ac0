package simpleray.io;

import java.nio.file.FileSystemException;

/** A file that another process, or another thread of this one, is writing at this moment. */
public final class FileInUseException extends FileSystemException {
    private static final long serialVersionUID = 1L;

    /**
     * Creates the exception.
     *
     * @param file the file as the user named it
     */
    public FileInUseException(String file) {
        super(file, null, "is being written by another run of SimpleRay: wait until it has ended, or choose another name");
    }
}
