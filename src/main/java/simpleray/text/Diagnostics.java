package simpleray.text;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/** What was found wrong with a scene file so far, and what the values being read belong to. <em>Mutable</em>, for one thread. */
final class Diagnostics {
    /** No more warnings than these are kept: a book read by mistake has a heading in every line. */
    private static final int MAX_WARNINGS = 1000;

    private static final int DEEP = 8;

    private final String file;
    private final List<Diagnostic> errors = new ArrayList<>();
    private final List<Diagnostic> warnings = new ArrayList<>();
    private final List<String> owners = new ArrayList<>();
    private int[] numbers = new int[DEEP];                    // the owners' numbers, 0 for none
    private int mostErrors = 1;
    private int headings;

    /** Begins without a problem; the file's name is for messages. */
    Diagnostics(String file) {
        this.file = file;
    }

    void tolerate(int most) {
        mostErrors = most;
    }

    /** Says what the next values belong to: "object" and 3 for "object 3's", the name and 0 for the name alone. */
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

    /** Notes an error; throws if that is one too many. */
    void note(SourceLocation location, String wanted, String found) throws SceneFormatException {
        report(problem(location, true, expected(wanted, found)));
    }

    /** Notes an error or warning; throws if that is one error too many. */
    void report(Diagnostic problem) throws SceneFormatException {
        if (!problem.error()) {
            if (hasRoom()) {
                warnings.add(problem);
            }
            return;
        }
        errors.add(problem);
        if (errors.size() >= mostErrors) {
            throw new SceneFormatException(errors, mostErrors > 1);
        }
    }

    /** Notes an error after which there is no going on, and returns the exception to throw. */
    SceneFormatException stop(SourceLocation location, String wanted, String found) {
        return stop(location, expected(wanted, found));
    }

    /** Notes an error likewise; the message names nothing of what is being read. */
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

    /** {@return what is found at the end of the file} Whose values are all in lines that begin with a letter, sees none of them. */
    String end() {
        return "the end of the file" + (headings == 0 ? "" : headings == 1 ? " (1 line was skipped as a heading)"
            : " (" + headings + " lines were skipped as headings)");
    }

    /** Notes the warning that a heading was skipped. */
    void skipped(SourceLocation location, String heading) {
        headings++;
        warnings.add(problem(location, false,
            "expected a value or a comment, found the heading " + Diagnostic.quoted(heading) + ", which is skipped"));
    }

    /** Notes a warning about something of what is being read. */
    void warn(SourceLocation location, String message) {
        if (hasRoom()) {
            warnings.add(problem(location, false, owner() + message));
        }
    }

    private String expected(String wanted, String found) {
        return "expected " + owner() + wanted + ", found " + found;
    }

    private String owner() {
        StringBuilder owner = new StringBuilder();
        for (int i = 0; i < owners.size(); i++) {
            owner.append(owners.get(i)).append(numbers[i] == 0 ? " " : " " + numbers[i] + "'s ");
        }
        return owner.toString();
    }

    private Diagnostic problem(SourceLocation location, boolean error, String message) {
        return new Diagnostic(file, location.line(), location.column(), error, message, location.source(), location.begins());
    }
}
