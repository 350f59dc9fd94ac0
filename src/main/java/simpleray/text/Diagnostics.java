package simpleray.text;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Set;

/** The errors and warnings of a scene file so far, and the thing that the next values belong to. <em>Mutable</em>, for one thread. */
final class Diagnostics {
    /** The most warnings that are kept: a book read by mistake has a heading in every line. */
    private static final int MAX_WARNINGS = 1000;

    private static final int DEEP = 8;

    private final String file;
    private final List<Diagnostic> errors = new ArrayList<>();
    private final List<Diagnostic> warnings = new ArrayList<>();
    private final List<String> owners = new ArrayList<>();
    private int[] numbers = new int[DEEP];                    // the owners' numbers, 0 for none
    private int maxErrors = 1;
    private int headings;

    /** Creates an empty list; the file's name is for messages. */
    Diagnostics(String file) {
        this.file = file;
    }

    void tolerate(int max) {
        maxErrors = max;
    }

    /** Names the thing that the next values belong to: "object" and 3 for "object 3's", the name and 0 for the name alone. */
    void enter(String name, int number) {
        if (owners.size() == numbers.length) {
            numbers = Arrays.copyOf(numbers, 2 * numbers.length);
        }
        numbers[owners.size()] = number;
        owners.add(name);
    }

    void leave() {
        owners.remove(owners.size() - 1);
    }

    List<Diagnostic> warnings() {
        return List.copyOf(warnings);
    }

    /** Notes an error; throws if there are too many. */
    void note(SourceLocation location, String wanted, String found) throws SceneFormatException {
        report(problem(location, true, expected(wanted, found)));
    }

    /** Notes an error or warning; throws if there are too many errors. */
    void report(Diagnostic problem) throws SceneFormatException {
        if (!problem.error()) {
            if (hasRoom()) {
                warnings.add(problem);
            }
            return;
        }
        errors.add(problem);
        if (errors.stream().filter(Diagnostic::error).count() >= maxErrors) {
            throw new SceneFormatException(errors, maxErrors > 1);
        }
    }

    /** Notes an error in another file, and the warnings that are told with it; throws if there are too many errors. */
    void report(List<Diagnostic> error) throws SceneFormatException {
        for (Diagnostic problem : error) {
            if (problem.error()) {
                report(problem);
            } else {
                errors.add(problem);
            }
        }
    }

    /** Notes an error after which the rest cannot be read. {@return the exception to throw} */
    SceneFormatException stop(SourceLocation location, String wanted, String found) {
        return stop(location, expected(wanted, found));
    }

    /** Notes an error likewise, with a message that does not name the thing being read. */
    SceneFormatException stop(SourceLocation location, String message) {
        errors.add(problem(location, true, message));
        return new SceneFormatException(errors, false);
    }

    /** Throws if an error was noted. */
    void complete() throws SceneFormatException {
        if (!errors.isEmpty()) {
            throw new SceneFormatException(errors, false);
        }
    }

    /** {@return whether another warning will be kept} */
    boolean hasRoom() {
        return warnings.size() < MAX_WARNINGS;
    }

    /** {@return what was found at the end of the file} Skipped headings are counted, since values may be in them by mistake. */
    String end() {
        return "the end of the file" + (headings == 0 ? "" : headings == 1 ? " (1 line was skipped as a heading)"
            : " (" + headings + " lines were skipped as headings)");
    }

    /** Warns that a heading is skipped, or a line that begins nearly as one of the keywords. */
    void skipped(SourceLocation location, String heading, Set<String> keywords) {
        headings++;
        String word = heading.split("\\s", 2)[0];
        String meant = Misspelling.meant(word, keywords);
        warnings.add(problem(location, false, meant == null
            ? "expected a value or a comment, found the heading " + Diagnostic.quoted(heading) + ", which is skipped"
            : "unknown setting " + Diagnostic.quoted(word) + ": did you mean " + meant + "? The line is skipped"));
    }

    /** Warns about a value that is being read. */
    void warn(SourceLocation location, String message) {
        if (hasRoom()) {
            warnings.add(problem(location, false, owner() + message));
        }
    }

    private String expected(String wanted, String found) {
        return "expected " + owner() + wanted + ", found " + found;
    }

    /** {@return whether the next values belong to no thing} */
    boolean isOutside() {
        return owners.isEmpty();
    }

    /** {@return the outermost thing that the next values belong to} */
    SourceValue.Thing thing(int count, String kind) {
        return new SourceValue.Thing(owners.get(0), numbers[0], count, kind);
    }

    private String owner() {
        return owner(0);
    }

    /** {@return what the next values belong to, without the outermost of these things; a blank is its end} */
    String owner(int outer) {
        StringBuilder owner = new StringBuilder();
        for (int i = outer; i < owners.size(); i++) {
            owner.append(owners.get(i)).append(numbers[i] == 0 ? " " : " " + numbers[i] + "'s ");
        }
        return owner.toString();
    }

    private Diagnostic problem(SourceLocation location, boolean error, String message) {
        return new Diagnostic(file, location.line(), location.column(), error, message, location.source(), location.begins());
    }
}
