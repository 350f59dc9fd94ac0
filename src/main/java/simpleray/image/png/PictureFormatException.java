package simpleray.image.png;

import java.io.IOException;

/** A picture file that is damaged, or does not hold what is looked for in it. */
public final class PictureFormatException extends IOException {
    private static final long serialVersionUID = 1L;

    /** What is wrong with the file. */
    private final String fault;

    /**
     * Creates the exception.
     *
     * @param file the file as the user named it
     * @param fault what is wrong with it
     */
    public PictureFormatException(String file, String fault) {
        super(file + ": " + fault);
        this.fault = fault;
    }

    /** {@return what is wrong with the file, without its name} */
    public String fault() {
        return fault;
    }
}
