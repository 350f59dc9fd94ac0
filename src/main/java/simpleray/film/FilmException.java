package simpleray.film;

import java.io.IOException;
import simpleray.io.FileInUseException;
import simpleray.io.OutputTarget;

/** Why a film was not made. The message says it to the user, with the name of the file. */
public final class FilmException extends IOException {
    private static final long serialVersionUID = 1L;

    private final Kind kind;

    /** What went wrong. */
    public enum Kind {
        /** A file cannot be created. */
        NOT_CREATED,
        /** Frames of an earlier run are there. */
        LEFT,
        /** Another run is writing the same file. */
        BUSY,
        /** A frame that was to be kept is none of this film. */
        FOREIGN,
        /** Ffmpeg is not there. */
        NO_FFMPEG,
        /** A file cannot be written. */
        NOT_WRITTEN
    }

    FilmException(Kind kind, String message) {
        super(message);
        this.kind = kind;
    }

    static FilmException notCreated(String name, IOException e) {
        return e instanceof FileInUseException busy ? new FilmException(Kind.BUSY, name + ": " + busy.getReason())
            : new FilmException(Kind.NOT_CREATED, name + ": cannot be created: " + OutputTarget.reason(e));
    }

    /** {@return what went wrong} */
    public Kind kind() {
        return kind;
    }
}
