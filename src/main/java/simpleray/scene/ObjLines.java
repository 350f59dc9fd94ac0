package simpleray.scene;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.Reader;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import simpleray.text.Found;
import simpleray.text.Numbers;
import simpleray.text.Problem;
import simpleray.text.SceneFormatException;

/**
 * The lines of a Wavefront OBJ that say something of its polygons: vertices, normals and faces, all else passed over. <em>Mutable</em>,
 * for one thread.
 *
 * <p>Each line is checked and written anew before {@link de.javagl.obj.ObjReader} gets it, which takes {@code NaN} and {@code 1f} for
 * numbers, loses a character at each {@code \}, stumbles over tabs and comments behind values, and knows no line numbers.
 */
final class ObjLines extends BufferedReader {
    private static final char COMMENT = '#';
    private static final char CONTINUED = '\\';
    private static final char BYTE_ORDER_MARK = '\uFEFF';
    private static final int LEAST_CORNERS = 3;
    /** A line, with those it continues: far more than a polygon needs, far less than fills the memory. */
    private static final int MOST_CHARACTERS = 1 << 20;
    private static final int SHOWN = 512;
    private static final String END = "the end of the ";

    private final String file;
    private final List<Piece> pieces = new ArrayList<>();
    private final StringBuilder joined = new StringBuilder();
    private final StringBuilder physical = new StringBuilder();
    private final char[] buffer = new char[1 << 13];
    private int next;
    private int filled;
    private String line = "";
    private boolean afterReturn;      // the last line ended with CR: a LF belongs to it
    private int lineNumber;
    private int at;                   // behind the latest word of the line
    private int wordAt;
    private int vertices;
    private int normals;
    private int polygons;

    /** A line of the file, and where it begins in the line that is put together of it and of those it continues. */
    private record Piece(int start, int number, String source) {
    }

    /**
     * Creates the lines of a file.
     *
     * @param in the file's text
     * @param file what messages call it
     */
    ObjLines(Reader in, String file) {
        super(in);
        this.file = file;
    }

    /**
     * Finds the next line of interest.
     *
     * @return the line; null at the end of the file
     * @throws SceneFormatException if there is an error in it
     */
    @Override
    public String readLine() throws IOException {
        while (join()) {
            String keyword = word();
            switch (keyword == null ? "" : keyword.toLowerCase(Locale.ROOT)) {
                case "v":
                    return numbers("v", "vertex " + ++vertices);
                case "vn":
                    return numbers("vn", "normal " + ++normals);
                case "f":
                    polygons++;
                    return face();
                default:
                    break;
            }
        }
        return null;
    }

    /** {@return a warning at the beginning of the line just read} */
    Problem warning(String message) {
        return new Problem(file, pieces.get(0).number, 1, false, message, pieces.get(0).source);
    }

    /** {@return the error that something is missing at the end of the file} */
    SceneFormatException missing(String wanted) {
        if (pieces.isEmpty()) {
            pieces.add(new Piece(0, 1, ""));
        }
        Piece last = pieces.get(pieces.size() - 1);
        wordAt = last.start + last.source.length();
        return error(wanted, END + "file");
    }

    /** Puts the next line and those it continues together, without comments; returns false at the end of the file. */
    private boolean join() throws IOException {
        joined.setLength(0);
        String next = physicalLine();
        if (next == null) {
            return false;
        }
        pieces.clear();
        at = 0;
        if (lineNumber == 0 && !next.isEmpty() && next.charAt(0) == BYTE_ORDER_MARK) {
            next = next.substring(1);
        }
        boolean continued = append(next);
        while (continued) {
            next = physicalLine();
            continued = next != null && append(next);
        }
        line = joined.toString();
        return true;
    }

    /** Reads a line of the file as {@link BufferedReader#readLine} does, but none that is longer than makes sense. */
    private String physicalLine() throws IOException {
        physical.setLength(0);
        boolean some = false;
        while (next < filled || more()) {
            if (afterReturn && buffer[next] == '\n') {
                afterReturn = false;
                next++;
                continue;
            }
            afterReturn = false;
            some = true;
            int end = next;
            while (end < filled && buffer[end] != '\n' && buffer[end] != '\r') {
                end++;
            }
            physical.append(buffer, next, end - next);
            if (physical.length() + joined.length() > MOST_CHARACTERS) {
                throw tooLong();
            }
            next = end;
            if (end < filled) {
                afterReturn = buffer[next++] == '\r';
                return physical.toString();
            }
        }
        return some ? physical.toString() : null;
    }

    private boolean more() throws IOException {
        next = 0;
        filled = read(buffer, 0, buffer.length);
        return filled > 0;
    }

    private SceneFormatException tooLong() {
        String wanted = "expected a line of at most " + MOST_CHARACTERS + " characters, found a longer one";
        return new SceneFormatException(List.of(new Problem(file, lineNumber + 1, 1, true, wanted,
            physical.substring(0, Math.min(physical.length(), SHOWN)))), false);
    }

    /** Appends a line of the file; returns whether it continues on the next one. */
    private boolean append(String source) {
        pieces.add(new Piece(joined.length(), ++lineNumber, source));
        int comment = source.indexOf(COMMENT);
        String text = comment < 0 ? source : source.substring(0, comment);
        int end = text.length();
        while (end > 0 && isBlank(text.charAt(end - 1))) {
            end--;
        }
        boolean continued = end > 0 && text.charAt(end - 1) == CONTINUED;
        joined.append(text, 0, continued ? end - 1 : end).append(continued ? " " : "");
        return continued;
    }

    /** {@return the next word of the line; null if there is none} */
    private String word() {
        int length = line.length();
        while (at < length && isBlank(line.charAt(at))) {
            at++;
        }
        wordAt = at;
        while (at < length && !isBlank(line.charAt(at))) {
            at++;
        }
        return at == wordAt ? null : line.substring(wordAt, at);
    }

    private static boolean isBlank(char c) {
        return Character.isWhitespace(c) || Character.isSpaceChar(c);
    }

    /** Checks three numbers. What follows them, a weight or colours, is passed over. */
    private String numbers(String keyword, String owner) throws SceneFormatException {
        StringBuilder clean = new StringBuilder(keyword);
        for (char axis = 'x'; axis <= 'z'; axis++) {
            String word = word();
            if (word == null || Float.isNaN(Numbers.parseFloat(word))) {
                boolean large = word != null && !Double.isNaN(Numbers.parseDouble(word));
                throw error(owner + "'s " + axis, found(word) + (large ? " (beyond 3.4e38, the largest coordinate)" : ""));
            }
            clean.append(' ').append(word);
        }
        return clean.toString();
    }

    /** Checks a polygon: corners {@code v}, {@code v/vt}, {@code v//vn} or {@code v/vt/vn}, all with normals or none. */
    private String face() throws SceneFormatException {
        StringBuilder clean = new StringBuilder("f");
        boolean withNormals = false;
        int corners = 0;
        for (String word = word(); word != null || corners < LEAST_CORNERS; word = word()) {
            if (word == null) {
                throw error(owner() + "corner " + (corners + 1) + " of at least " + LEAST_CORNERS, found(null));
            }
            String[] indices = word.split("/", -1);
            boolean withNormal = indices.length > 2 && !indices[2].isEmpty();
            if (corners > 0 && withNormal != withNormals) {
                throw error(owner() + "corners all with normals or all without", found(word));
            }
            withNormals = withNormal;
            corners++;
            clean.append(' ').append(index(word, indices[0], vertices, "vertex"));
            if (indices.length > 1 && !indices[1].isEmpty()) {
                index(word, indices[1], Integer.MAX_VALUE, "texture");
            }
            if (withNormal) {
                clean.append("//").append(index(word, indices[2], normals, "normal"));
            }
            if (indices.length > LEAST_CORNERS) {
                throw error(owner() + "vertex/texture/normal", found(word));
            }
        }
        return clean.toString();
    }

    /** Checks an index: from 1, or from -1 backwards, of the things above this line. */
    private long index(String word, String index, int count, String what) throws SceneFormatException {
        Long value = Numbers.parseInteger(index, -count, count);
        if (value == null || value == 0) {
            boolean number = Numbers.parseInteger(index, Long.MIN_VALUE, Long.MAX_VALUE) != null;
            String range = number && count < Integer.MAX_VALUE ? " among the " + count + " so far" : "";
            throw error(owner() + what + " index" + range, found(word));
        }
        return value;
    }

    private String owner() {
        return "polygon " + polygons + "'s ";
    }

    private static String found(String word) {
        return word == null ? END + "line" : Found.word(word);
    }

    private SceneFormatException error(String wanted, String found) {
        Piece piece = pieces.get(0);
        for (Piece later : pieces) {
            if (later.start <= wordAt) {
                piece = later;
            }
        }
        int column = piece.source.codePointCount(0, Math.min(wordAt - piece.start, piece.source.length())) + 1;
        String message = "expected " + wanted + ", found " + found;
        return new SceneFormatException(List.of(new Problem(file, piece.number, column, true, message, piece.source)), false);
    }
}
