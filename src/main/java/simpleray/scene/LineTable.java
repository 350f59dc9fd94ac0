package simpleray.scene;

import java.util.Arrays;

/** The lines of a scene's file on which the things of a list begin, four bytes for each. <em>Mutable.</em> */
final class LineTable {
    private static final int ROOM = 16;

    private int[] lines = {};
    private int count;

    /** Notes the line of the next thing. */
    void add(int line) {
        if (count == lines.length) {
            lines = Arrays.copyOf(lines, Math.max(ROOM, count + (count >> 1)));
        }
        lines[count++] = line;
    }

    /** Lets go of the room for more. */
    void trim() {
        lines = Arrays.copyOf(lines, count);
    }

    /** Forgets the line of a thing, which is no longer the one in the file. */
    void forget(int i) {
        if (i < count) {
            lines[i] = 0;
        }
    }

    /** {@return the line of a thing, from 1; 0 if it is not known} */
    int get(int i) {
        return i < count ? lines[i] : 0;
    }
}
