package simpleray;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** The tables of docs/thesis-map.md. <em>Constant.</em> */
final class ThesisMap {
    private static final Pattern HEADING = Pattern.compile("## (\\w+) \\(`(simpleray[\\w.]+)`\\)");
    private static final Pattern ROW =
        Pattern.compile("\\| ch\\. 5, Class (\\w+), (field|constructor|method) (\\d+) \\| `([^`]+)` \\| `([^`]+)` \\|");
    private static final List<String> TABLE_HEAD = List.of("| place | as printed | here |", "|---|---|---|");

    private final String text;
    private final Map<String, Class<?>> classes = new LinkedHashMap<>();
    private final List<Row> rows = new ArrayList<>();

    /** A constructor, method or field: the class it is listed under, its place in the tables, its wording there and here. */
    record Row(String section, String type, String kind, int number, String printed, String here) {
        @Override
        public String toString() {
            return type + ", " + kind + ' ' + number + ": " + here;
        }
    }

    private ThesisMap(String text) {
        this.text = text;
        String section = null;
        for (String line : text.lines().toList()) {
            Matcher heading = HEADING.matcher(line);
            Matcher row = ROW.matcher(line);
            if (heading.matches()) {
                section = heading.group(1);
                classes.put(section, load(heading.group(2) + '.' + section));
            } else if (row.matches()) {
                rows.add(new Row(section, row.group(1), row.group(2), Integer.parseInt(row.group(3)), row.group(4), row.group(5)));
            } else if (line.startsWith("## ") || line.startsWith("|") && !TABLE_HEAD.contains(line)) {
                throw new IllegalStateException("docs/thesis-map.md has a line that is neither heading nor row: " + line);
            }
        }
    }

    static ThesisMap read() {
        try {
            return new ThesisMap(Files.readString(Project.root().resolve("docs/thesis-map.md")));
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    /** {@return the whole page} */
    String text() {
        return text;
    }

    /** {@return the classes by their names, in the page's order} */
    Map<String, Class<?>> classes() {
        return classes;
    }

    List<Row> rows() {
        return rows;
    }

    /** {@return the class that a name means in the thesis's tables: one of the thesis's own, a primitive type, or one with its package} */
    Class<?> type(String name) {
        return switch (name) {
            case "void" -> void.class;
            case "boolean" -> boolean.class;
            case "char" -> char.class;
            case "int" -> int.class;
            case "long" -> long.class;
            case "float" -> float.class;
            case "double" -> double.class;
            default -> name.contains(".") ? load(name) : classes.get(name);
        };
    }

    private static Class<?> load(String name) {
        try {
            return Class.forName(name);
        } catch (ClassNotFoundException e) {
            throw new IllegalStateException("docs/thesis-map.md names a class that is not there: " + name, e);
        }
    }
}
