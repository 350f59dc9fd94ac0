package simpleray.scene;

import java.io.IOException;
import java.util.Arrays;
import java.util.Locale;
import java.util.stream.Collectors;
import simpleray.text.SceneReader;
import simpleray.text.SceneWriter;

/**
 * One line of the table that ties a code in a scene file to a class.
 *
 * @param <T> what the table lists
 */
interface Kind<T> {
    /** {@return the number that stands for it in a scene file} */
    int code();

    /** {@return the class} */
    Class<? extends T> type();

    /** {@return a new one, to be read into} */
    T create();

    /** {@return the name, as the constants are called} */
    String name();

    /**
     * Words what a code is expected to be: "type (0 sphere, 1 plane; 9 objects announced)".
     *
     * @param announced what the file announced, "9 objects"
     */
    static String field(Kind<?>[] kinds, String announced) {
        String known = Arrays.stream(kinds).map(k -> k.code() + " " + k.name().toLowerCase(Locale.ROOT).replace('_', ' '))
            .collect(Collectors.joining(", "));
        return "type (" + known + "; " + announced + " announced)";
    }

    /**
     * Reads a code.
     *
     * @param field what {@link #field} said, for the message
     * @return a new thing of that kind, not read yet
     */
    static <T> T read(SceneReader is, Kind<T>[] kinds, String field) throws IOException {
        int code = is.readInt(field, 0);
        for (Kind<T> kind : kinds) {
            if (kind.code() == code) {
                return kind.create();
            }
        }
        throw is.stop(field);
    }

    /** Writes the code of a thing's kind. */
    static <T> void write(SceneWriter os, Kind<T>[] kinds, T thing) throws IOException {
        for (Kind<T> kind : kinds) {
            if (kind.type() == thing.getClass()) {
                os.writeInt(kind.code());
                return;
            }
        }
        throw new IllegalArgumentException("a scene file has no code for " + thing.getClass().getName());
    }
}
