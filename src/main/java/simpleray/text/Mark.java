package simpleray.text;

/**
 * Remembers where a word is, at little cost for each: by offsets in the file while it is in the {@link InputBuffer}, by its {@link Place}
 * from then on. <em>Mutable.</em>
 */
final class Mark {
    /** The line, from 1; 0 while nothing is marked. */
    int line;
    /** The offset of the first byte of the line that is in the window. */
    long lineStart;
    /** That byte's column. */
    int lineColumn;
    /** The offset of the word's first byte. */
    long start;
    /** The offset behind its last byte. */
    long end;
    /** The place, once the window has moved on. */
    Place place;

    void copy(Mark m) {
        line = m.line;
        lineStart = m.lineStart;
        lineColumn = m.lineColumn;
        start = m.start;
        end = m.end;
        place = m.place;
    }
}
