package simpleray.cli;

import java.util.List;
import java.util.stream.Collectors;
import simpleray.text.Diagnostic;

/** Writes problems as JSON (RFC 8259). */
final class Json {
    private Json() {
    }

    /** {@return an array of all problems, each on a line of its own} */
    static String array(List<Diagnostic> problems) {
        return problems.stream().map(Json::object).collect(Collectors.joining(",\n", "[", "]\n"));
    }

    private static String object(Diagnostic problem) {
        return "{\"file\":" + string(problem.file()) + ",\"line\":" + problem.line() + ",\"column\":" + problem.column()
            + ",\"severity\":" + (problem.error() ? "\"error\"" : "\"warning\"") + ",\"message\":" + string(problem.message()) + '}';
    }

    /** {@return a text as a string of JSON, in quotes} */
    static String string(String text) {
        StringBuilder json = new StringBuilder("\"");
        text.chars().forEach(c -> {
            if (c == '"' || c == '\\') {
                json.append('\\').append((char) c);
            } else if (c < ' ' || Character.isSurrogate((char) c)) {
                json.append(String.format("\\u%04x", c));    // one surrogate alone would be no UTF-8
            } else {
                json.append((char) c);
            }
        });
        return json.append('"').toString();
    }
}
