package simpleray.scene;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import simpleray.text.SceneReader;
import simpleray.text.SceneWriter;

/**
 * Maps the codes in a scene file to classes, and reads and writes whole lists by them. <em>Mutable</em> only while kinds are added.
 *
 * @param <T> the type of the listed things
 */
final class KindTable<T extends SceneElement> {
    /** The initial capacity of a list, and the factor by which it grows. */
    private static final int FIRST_ROOM = 1000;
    private static final int MORE_ROOM = 4;

    private final String what;
    private final List<Kind<T>> kinds = new ArrayList<>();

    /**
     * A kind: its code, its name for messages, its class, and a factory for an empty thing to be read into.
     *
     * @param <T> the type of the listed things
     */
    abstract static class Kind<T> {
        private final int code;
        private final String name;
        private final Class<? extends T> type;

        Kind(int code, String name, Class<? extends T> type) {
            this.code = code;
            this.name = name;
            this.type = type;
        }

        abstract T make();
    }

    /**
     * Creates an empty table.
     *
     * @param what the name of a listed thing, for messages: "object"
     */
    KindTable(String what) {
        this.what = what;
    }

    KindTable<T> add(Kind<T> kind) {
        kinds.add(kind);
        return this;
    }

    /** Reads n things, each by its code and then by itself, and notes their lines. The list grows as they come: n may be a lie. */
    List<T> readAll(SceneReader is, int n, LineTable places) throws IOException {
        ArrayList<T> all = new ArrayList<>();
        readAll(is, n, places, all);
        return all;
    }

    /** Reads n things into a list, which holds those before the first that cannot be read. */
    @SuppressWarnings("NonApiType")                            // no other list can be told how much room it will need
    void readAll(SceneReader is, int n, LineTable places, ArrayList<T> all) throws IOException {
        String type = "type (" + list() + "; " + counted(n) + " announced)";
        int room = 0;
        for (int i = 1; i <= n; i++) {
            if (i > room) {
                room = (int) Math.min(n, Math.max(FIRST_ROOM, (long) MORE_ROOM * room));
                all.ensureCapacity(room);
            }
            is.enter(what, i);
            T thing = create(is, type, n);
            places.add(is.line());
            thing.read(is);
            all.add(thing);
            is.leave();
        }
        places.trim();
    }

    /** {@return the codes and names of all kinds, for messages: "0 sphere, 1 plane"} */
    String list() {
        StringBuilder list = new StringBuilder();
        for (Kind<T> kind : kinds) {
            list.append(list.length() == 0 ? "" : ", ").append(kind.code).append(' ').append(kind.name);
        }
        return list.toString();
    }

    /** {@return a number of things, for messages} */
    String counted(int n) {
        return n + " " + what + (n == 1 ? "" : "s");
    }

    private T create(SceneReader is, String field, int count) throws IOException {
        int code = is.readInt(field, Integer.MIN_VALUE, Integer.MAX_VALUE);
        for (int i = 0; i < kinds.size(); i++) {
            if (kinds.get(i).code == code) {
                is.specify(count, kinds.get(i).name, field);
                return kinds.get(i).make();
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
        Kind<T> kind = kind(thing);
        if (kind == null) {
            throw new IllegalArgumentException("a scene file has no code for " + thing.getClass().getName());
        }
        return kind.code;
    }

    /** {@return the name of a thing's kind, for messages; its class's name if no scene file knows it} */
    String name(T thing) {
        Kind<T> kind = kind(thing);
        return kind == null ? thing.getClass().getSimpleName() : kind.name;
    }

    private Kind<T> kind(T thing) {
        for (Kind<T> kind : kinds) {
            if (kind.type == thing.getClass()) {
                return kind;
            }
        }
        return null;
    }
}
