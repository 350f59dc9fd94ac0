package simpleray.render;

import simpleray.text.NumberParser;

/**
 * One of the bands of rows into which a picture is cut, so that several machines render it. The bands are as even as can be. <em>Constant.</em>
 *
 * @param number its number, 1 for the uppermost
 * @param count the number of bands, 1 or more
 */
public record Band(int number, int count) {
    /**
     * Checks the ranges.
     *
     * @param number its number, 1 to the number of bands
     * @param count the number of bands, 1 or more
     */
    public Band {
        if (number < 1 || number > count) {
            throw new IllegalArgumentException("bands are 1/N to N/N, such as 2/3, and this is " + text(number, count));
        }
    }

    /**
     * Reads a band.
     *
     * @param text such as {@code 2/3}
     * @return the band
     * @throws IllegalArgumentException if it is none; the message is for the user
     */
    public static Band parse(String text) {
        int slash = text.indexOf('/');
        Long number = slash < 0 ? null : NumberParser.parseInteger(text.substring(0, slash), Integer.MIN_VALUE, Integer.MAX_VALUE);
        Long count = slash < 0 ? null : NumberParser.parseInteger(text.substring(slash + 1), Integer.MIN_VALUE, Integer.MAX_VALUE);
        if (number == null || count == null) {
            throw new IllegalArgumentException("expected a band such as 2/3, found '" + text + "'");
        }
        return new Band(number.intValue(), count.intValue());
    }

    /**
     * Finds this band's rows.
     *
     * @param whole the rectangle that is cut into bands
     * @return the part of it that is this band
     * @throws IllegalArgumentException if there are more bands than rows; the message is for the user
     */
    public Region of(Region whole) {
        if (count > whole.height()) {
            throw new IllegalArgumentException("there are more bands, " + count + ", than rows, " + whole.height());
        }
        int first = (int) ((number - 1L) * whole.height() / count);
        int end = (int) ((long) number * whole.height() / count);
        return new Region(whole.x(), whole.y() + first, whole.width(), end - first);
    }

    /**
     * Names this band's rows.
     *
     * @param whole the rectangle that is cut into bands
     * @return such as {@code rows 81 to 160 of 240} or {@code row 1 of 3}, counted from 1
     */
    public String rows(Region whole) {
        Region rows = of(whole);
        return rows(rows.y() - whole.y() + 1, rows.bottom() - whole.y(), whole.height());
    }

    /**
     * Names rows.
     *
     * @param first the first row, counted from 1
     * @param last the last one
     * @param all the number of all rows
     * @return such as {@code rows 81 to 160 of 240} or {@code row 1 of 3}
     */
    public static String rows(int first, int last, int all) {
        return (first == last ? "row " + first : "rows " + first + " to " + last) + " of " + all;
    }

    /** {@return number and count as the command line has them} */
    @Override
    public String toString() {
        return text(number, count);
    }

    private static String text(int number, int count) {
        return number + "/" + count;
    }
}
