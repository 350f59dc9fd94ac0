package simpleray.text;

import java.util.ArrayList;
import java.util.List;

/** What was found wrong with a scene file so far, and what the values being read belong to. <em>Mutable</em>, for one thread. */
final class Problems {
    /** No more warnings than these are kept: a book read by mistake has a heading in every line. */
    private static final int MOST_WARNINGS = 1000;

    private final String file;
    private final List<Problem> errors = new ArrayList<>();
    private final List<Problem> warnings = new ArrayList<>();
    private final List<String> owners = new ArrayList<>();
    private int mostErrors = 1;

    /** Begins without a problem; the file's name is for messages. */
    Problems(String file) {
        this.file = file;
    }

    void tolerate(int most) {
        mostErrors = most;
    }

    /** Says what the next values belong to: "object 3's". */
    void enter(String owner) {
        owners.add(owner);
    }

    void leave() {
        owners.remove(owners.size() - 1);
    }

    List<Problem> warnings() {
        return List.copyOf(warnings);
    }

    /** Notes an error; throws if that is one too many. */
    void note(Words.Place place, String wanted, String found) throws SceneFormatException {
        report(error(place, wanted, found));
    }

    /** Notes an error or warning; throws if that is one error too many. */
    void report(Problem problem) throws SceneFormatException {
        if (!problem.error()) {
            if (warnings.size() < MOST_WARNINGS) {
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
    SceneFormatException stop(Words.Place place, String wanted, String found) {
        errors.add(error(place, wanted, found));
        return new SceneFormatException(errors, false);
    }

    /** Throws if an error was noted. */
    void complete() throws SceneFormatException {
        if (!errors.isEmpty()) {
            throw new SceneFormatException(errors, false);
        }
    }

    /** Notes the warning that a heading was skipped. */
    void skipped(Words.Place place) {
        if (warnings.size() < MOST_WARNINGS) {
            String text = Problem.quoted(place.source().substring(place.at()).strip());
            warnings.add(problem(place, false, "expected a value or a comment, found the heading " + text + ", which is skipped"));
        }
    }

    private Problem error(Words.Place place, String wanted, String found) {
        String owner = owners.isEmpty() ? "" : String.join(" ", owners) + ' ';
        return problem(place, true, "expected " + owner + wanted + ", found " + found);
    }

    private Problem problem(Words.Place place, boolean error, String message) {
        return new Problem(file, place.line(), place.column(), error, message, place.source());
    }
}
