package simpleray.ui.picture;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;

/** The rows that could not be rendered, each with the reason. <em>Mutable</em>; any thread may call. */
final class FailedRows {
    private static final int MAX_LINES = 20;

    private final TreeMap<Integer, String> rows = new TreeMap<>();

    synchronized void add(int y, Throwable fault) {
        rows.put(y, fault.getMessage() == null ? fault.getClass().getSimpleName() : fault.toString());
    }

    synchronized boolean isEmpty() {
        return rows.isEmpty();
    }

    /** {@return a line for each run of rows with the same fault; empty for none} Rows are counted from 0 at the top, as everywhere. */
    synchronized String text() {
        List<String> lines = new ArrayList<>();
        int first = 0;
        int last = -1;
        String why = null;
        for (Map.Entry<Integer, String> row : rows.entrySet()) {
            if (why != null && row.getKey() == last + 1 && row.getValue().equals(why)) {
                last++;
                continue;
            }
            if (why != null) {
                lines.add(line(first, last, why));
            }
            first = row.getKey();
            last = first;
            why = row.getValue();
        }
        if (why != null) {
            lines.add(line(first, last, why));
        }
        if (lines.size() > MAX_LINES) {
            int more = lines.size() - MAX_LINES;
            lines.subList(MAX_LINES, lines.size()).clear();
            lines.add("and " + more + " more such pieces");
        }
        return String.join("\n", lines);
    }

    private static String line(int first, int last, String why) {
        return (first == last ? "row " + first + " was" : "rows " + first + " to " + last + " were") + " not rendered: " + why;
    }
}
