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
    /** For so many things there is room at first, and then for so many times as many as there are. */
    private static final int FIRST_ROOM = 1000;
    private static final int MORE_ROOM = 4;

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

    /** Reads n things, each by its code and then by itself, and notes their lines. The list grows as they come: n may be a lie. */
    List<T> readAll(SceneReader is, int n, Lines places) throws IOException {
        ArrayList<T> all = new ArrayList<>();
        readAll(is, n, places, all);
        return all;
    }

    /** Reads n things into a list, which holds those before the first that cannot be read. */
    @SuppressWarnings("NonApiType")                            // no other list can be told how much room it will need
    void readAll(SceneReader is, int n, Lines places, ArrayList<T> all) throws IOException {
        String known = lines.stream().map(line -> line.code + " " + line.name).collect(Collectors.joining(", "));
        String field = "type (" + known + "; " + counted(n) + " announced)";
        int room = 0;
        for (int i = 1; i <= n; i++) {
            if (i > room) {
                room = (int) Math.min(n, Math.max(FIRST_ROOM, (long) MORE_ROOM * room));
                all.ensureCapacity(room);
            }
            is.enter(what, i);
            T thing = create(is, field);
            places.add(is.line());
            thing.read(is);
            all.add(thing);
            is.leave();
        }
        places.trim();
    }

    /** {@return a number of things, for messages} */
    String counted(int n) {
        return n + " " + what + (n == 1 ? "" : "s");
    }

    private T create(SceneReader is, String field) throws IOException {
        int code = is.readInt(field, Integer.MIN_VALUE, Integer.MAX_VALUE);
        for (int i = 0; i < lines.size(); i++) {
            Line<T> line = lines.get(i);
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

    /** {@return what kind of thing it is, as messages say it} One that no scene file knows is called by its class. */
    String name(T thing) {
        return lines.stream().filter(line -> line.type == thing.getClass()).map(Line::name).findFirst()
            .orElseGet(() -> thing.getClass().getSimpleName());
    }
}
