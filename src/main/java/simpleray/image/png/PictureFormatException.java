package simpleray.image.png;

import java.io.IOException;

/** A picture file is damaged, or does not contain what is wanted. */
public final class PictureFormatException extends IOException {
    private static final long serialVersionUID = 1L;

    /** The fault of the file. */
    private final String fault;

    /**
     * Creates the exception.
     *
     * @param file the file as the user named it
     * @param fault the fault
     */
    public PictureFormatException(String file, String fault) {
        super(file + ": " + fault);
        this.fault = fault;
    }

    /** {@return the fault, without the file's name} */
    public String fault() {
        return fault;
    }
}
