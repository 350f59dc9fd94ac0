package simpleray.image.png;

import java.io.IOException;
import java.util.Arrays;
import java.util.HashMap;
import java.util.Map;
import simpleray.image.Picture;

/**
 * Compares a picture with that of a file while its rows are being finished, in any order and by any threads. Only rows that wait for one
 * above them are in memory. <em>Mutable</em>; any thread may call.
 */
public final class RowsCheck {
    private final Picture picture;
    private final PngReader file;
    private final Map<Integer, byte[]> waiting = new HashMap<>();
    private int next;
    private long different;
    private Pixel first;

    /**
     * A pixel that differs. <em>Constant.</em>
     *
     * @param x its column, 0 at the left
     * @param y its row, 0 at the top
     * @param inFile red, green and blue in the file, and alpha if the picture has any
     * @param here red, green and blue in the picture, likewise
     */
    public record Pixel(int x, int y, String inFile, String here) {
    }

    /**
     * Begins a comparison.
     *
     * @param picture the picture, whose rows may still be missing
     * @param file a picture of the same size, with alpha if the other has it, or without
     */
    public RowsCheck(Picture picture, PngReader file) {
        this.picture = picture;
        this.file = file;
    }

    /**
     * Adds a row of the picture, which may then release it.
     *
     * @param y the row, 0 at the top; each once
     * @throws IOException if the file cannot be read
     */
    public void row(int y) throws IOException {
        byte[] levels = picture.levels(y);
        synchronized (this) {
            waiting.put(y, levels);
            for (byte[] here = waiting.remove(next); here != null; here = waiting.remove(next)) {
                compare(file.next(), here);
                next++;
            }
        }
    }

    private void compare(byte[] inFile, byte[] here) {
        if (Arrays.equals(inFile, here)) {
            return;
        }
        int pixel = picture.channels();
        for (int at = 0; at < here.length; at += pixel) {
            if (!Arrays.equals(inFile, at, at + pixel, here, at, at + pixel)) {
                different++;
                if (first == null) {
                    first = new Pixel(at / pixel, next, levels(inFile, at), levels(here, at));
                }
            }
        }
    }

    private String levels(byte[] row, int at) {
        StringBuilder levels = new StringBuilder();
        for (int i = at; i < at + picture.channels(); i++) {
            levels.append(i == at ? "" : ",").append(row[i] & 0xFF);
        }
        return levels.toString();
    }

    /** {@return the number of pixels that differ in the rows that were added} */
    public synchronized long different() {
        return different;
    }

    /** {@return the first pixel that differs, in the order of rows; null if none does} */
    public synchronized Pixel first() {
        return first;
    }
}
