package simpleray.scene;

import java.util.Set;
import java.util.function.Consumer;
import simpleray.text.Diagnostic;

/** A kind of thing in a file that a picture does not need: where the first one stands, and how many there are. <em>Mutable.</em> */
final class PassedOver {
    private final String wanted;
    private final String one;
    private final String many;
    private int count;
    private Diagnostic first;

    /**
     * Creates a kind of which there is none yet.
     *
     * @param wanted what was expected instead
     * @param one what is said of one after "found 1"
     * @param many what is said of more
     */
    PassedOver(String wanted, String one, String many) {
        this.wanted = wanted;
        this.one = one;
        this.many = many;
    }

    /** Adds one, on the line that is being read. */
    void add(LineReader lines) {
        if (count++ == 0) {
            first = lines.warning("");
        }
    }

    /** Adds one if the line that is being read is continued by one that begins with one of these words; there it is. */
    void addJoined(LineReader lines, Set<String> keywords) {
        Diagnostic place = lines.warningOfJoined(keywords);
        if (place != null && count++ == 0) {
            first = place;
        }
    }

    /** Warns if there is any. */
    void warn(Consumer<Diagnostic> warnings) {
        if (count > 0) {
            warnings.accept(new Diagnostic(first.file(), first.line(), first.column(), false,
                "expected " + wanted + ", found " + count + ' ' + (count == 1 ? one : many), first.source()));
        }
    }
}
