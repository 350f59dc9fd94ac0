package simpleray.scene;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Supplier;
import java.util.stream.Collectors;
import simpleray.text.SceneReader;
import simpleray.text.SceneWriter;

/**
 * Ties the codes in a scene file to classes, and reads and writes whole lists by them. <em>Mutable</em> only while its lines are added.
 *
 * @param <T> what is listed
 */
final class KindTable<T extends SceneElement> {
    private final String what;
    private final List<Line<T>> lines = new ArrayList<>();

    private record Line<T>(int code, String name, Class<? extends T> type, Supplier<? extends T> maker) {
    }

    /**
     * Creates an empty table.
     *
     * @param what what is listed, for messages: "object"
     */
    KindTable(String what) {
        this.what = what;
    }

    /** Adds a line: the code, its name for messages, the class, and how an empty one is made to be read into. */
    KindTable<T> add(int code, String name, Class<? extends T> type, Supplier<? extends T> maker) {
        lines.add(new Line<>(code, name, type, maker));
        return this;
    }

    /** Reads n things, each by its code and then by itself. The list grows as they come: n may be a lie. */
    List<T> readAll(SceneReader is, int n) throws IOException {
        String known = lines.stream().map(line -> line.code + " " + line.name).collect(Collectors.joining(", "));
        String field = "type (" + known + "; " + n + ' ' + what + "s announced)";
        List<T> all = new ArrayList<>();
        for (int i = 1; i <= n; i++) {
            is.enter(what, i);
            T thing = create(is, field);
            thing.read(is);
            all.add(thing);
            is.leave();
        }
        return all;
    }

    private T create(SceneReader is, String field) throws IOException {
        int code = is.readInt(field, 0, Integer.MAX_VALUE);
        for (Line<T> line : lines) {
            if (line.code == code) {
                return line.maker.get();
            }
        }
        throw is.stop(field);
    }

    /** Writes a list, a line for each thing. */
    void writeAll(SceneWriter os, List<T> all) throws IOException {
        for (T thing : all) {
            os.writeInt(code(thing));
            os.writeString("  ");
            thing.write(os);
            os.writeNewline();
        }
    }

    private int code(T thing) {
        return lines.stream().filter(line -> line.type == thing.getClass()).findFirst()
            .orElseThrow(() -> new IllegalArgumentException("a scene file has no code for " + thing.getClass().getName())).code;
    }
}
