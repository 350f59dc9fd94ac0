package simpleray.image;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Collectors;

/**
 * Lays out pictures of one size side by side on white paper, each with a label below, as a figure of a thesis.
 * <em>Constant.</em>
 *
 * <p>Letters and margins grow with the pictures, so that a sheet looks the same at any size. A label that is wider than its picture
 * continues in the next line; a single word that is wider widens its column.
 */
public final class Sheet {
    private static final double PAPER = 1;
    private static final double INK = 0.1;
    /** Letters and margins are measured in dots; a dot has one pixel for so many pixels of a picture's shorter side, rounded. */
    private static final int PIXELS_A_DOT = 200;
    /** Dots around the sheet, and between two pictures. */
    private static final int MARGIN = 12;
    /** Dots between a picture and its label. */
    private static final int GAP = 7;
    /** Dots from the top of one line of a label to the top of the next. */
    private static final int LINE = PixelFont.HEIGHT + 2;

    private final int pictureWidth;
    private final int pictureHeight;
    private final List<List<String>> labels;                  // the lines of each
    private final int dot;                                    // the size of a dot; this and what follows is in pixels
    private final int cell;                                   // the width of a picture's column
    private final int width;
    private final int height;

    /**
     * Lays out a sheet.
     *
     * @param pictureWidth the width of each picture
     * @param pictureHeight the height of each picture
     * @param labels the label of each picture, from the left, one or more; printable ASCII
     * @throws IllegalArgumentException if a side of the sheet is longer than {@link Picture#LONGEST_SIDE}
     */
    public Sheet(int pictureWidth, int pictureHeight, List<String> labels) {
        this.pictureWidth = pictureWidth;
        this.pictureHeight = pictureHeight;
        dot = Math.max(1, (Math.min(pictureWidth, pictureHeight) + PIXELS_A_DOT / 2) / PIXELS_A_DOT);
        int longestWord = labels.stream().flatMap(label -> words(label).stream()).mapToInt(String::length).max().orElseThrow();
        cell = Math.max(pictureWidth, dot * PixelFont.width(longestWord));
        this.labels = labels.stream().map(label -> lines(label, cell / dot)).collect(Collectors.toUnmodifiableList());
        int mostLines = this.labels.stream().mapToInt(List::size).max().orElseThrow();
        long wide = (long) dot * MARGIN + labels.size() * (cell + (long) dot * MARGIN);
        long high = (long) pictureHeight + (long) dot * (MARGIN + GAP + mostLines * LINE - LINE + PixelFont.HEIGHT + MARGIN);
        if (Math.max(wide, high) > Picture.LONGEST_SIDE) {
            throw new IllegalArgumentException("a sheet of " + labels.size() + (labels.size() == 1 ? " picture" : " pictures") + " of "
                + pictureWidth + 'x' + pictureHeight + " would have " + wide + 'x' + high
                + " pixels, and a side has at most " + Picture.LONGEST_SIDE);
        }
        width = (int) wide;
        height = (int) high;
    }

    /** {@return the width of the sheet in pixels} */
    public int width() {
        return width;
    }

    /** {@return the height of the sheet in pixels} */
    public int height() {
        return height;
    }

    /**
     * Fills the sheet.
     *
     * @param pictures as many as there are labels, complete and of the size given before
     * @return a new picture, with copies of their linear light; the paper is seen where they are transparent
     */
    public Picture with(List<Picture> pictures) {
        if (pictures.size() != labels.size()
            || pictures.stream().anyMatch(picture -> picture.width() != pictureWidth || picture.height() != pictureHeight)) {
            throw new IllegalArgumentException("the sheet is laid out for " + labels.size() + " pictures of "
                + pictureWidth + 'x' + pictureHeight);
        }
        Picture sheet = new Picture(width, height);
        int top = dot * MARGIN;
        for (int y = 0; y < height; y++) {
            double[] row = new double[3 * width];
            Arrays.fill(row, PAPER);
            if (y >= top && y < top + pictureHeight) {
                for (int i = 0; i < pictures.size(); i++) {
                    int x = left(i) + (cell - pictureWidth) / 2;
                    System.arraycopy(pictures.get(i).over(y - top, PAPER), 0, row, 3 * x, 3 * pictureWidth);
                }
            } else {
                write(row, Math.floorDiv(y - top - pictureHeight, dot) - GAP);
            }
            sheet.setRow(y, row);
        }
        return sheet;
    }

    /** Writes the dots of all labels that are in a row of pixels, so many dots below their top. */
    private void write(double[] row, int y) {
        int line = Math.floorDiv(y, LINE);
        int glyphRow = Math.floorMod(y, LINE);
        if (line < 0 || glyphRow >= PixelFont.HEIGHT) {
            return;
        }
        for (int i = 0; i < labels.size(); i++) {
            String text = line < labels.get(i).size() ? labels.get(i).get(line) : "";
            int textWidth = dot * PixelFont.width(text.length());
            int start = left(i) + (cell - textWidth) / 2;
            for (int x = 0; x < textWidth; x++) {
                if (PixelFont.isDark(text, x / dot, glyphRow)) {
                    Arrays.fill(row, 3 * (start + x), 3 * (start + x + 1), INK);
                }
            }
        }
    }

    private int left(int i) {
        return dot * MARGIN + i * (cell + dot * MARGIN);
    }

    /** {@return the label in lines of at most so many dots, except where one word is longer} */
    private static List<String> lines(String label, int dots) {
        List<String> lines = new ArrayList<>();
        String line = "";
        for (String word : words(label)) {
            String longer = line.isEmpty() ? word : line + ' ' + word;
            if (PixelFont.width(longer.length()) > dots && !line.isEmpty()) {
                lines.add(line);
                longer = word;
            }
            line = longer;
        }
        lines.add(line);
        return lines;
    }

    private static List<String> words(String label) {
        return List.of(label.split(" "));
    }
}
