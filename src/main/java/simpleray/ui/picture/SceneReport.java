package simpleray.ui.picture;

import java.io.IOException;
import java.nio.file.FileSystemException;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import simpleray.render.SceneLint;
import simpleray.scene.SceneFile;
import simpleray.text.Diagnostic;
import simpleray.text.SceneFormatException;

/**
 * The problems of a scene. <em>Constant.</em>
 *
 * @param text the whole report; empty for nothing
 * @param places the problems with a place; each is part of the text
 */
public record SceneReport(String text, List<Diagnostic> places) {
    /** Nothing is wrong. */
    static final SceneReport NONE = new SceneReport("", List.of());

    /**
     * {@return warnings, or errors}
     *
     * @param problems the problems
     */
    public static SceneReport of(List<Diagnostic> problems) {
        return new SceneReport(problems.stream().map(Diagnostic::toString).collect(Collectors.joining("\n")), problems);
    }

    /** {@return the warnings about a scene and about its picture} Follows rays: not for the event thread. */
    static SceneReport ofWhole(SceneFile scene, String name) {
        return of(Stream.concat(scene.warnings().stream(), SceneLint.striking(scene, name).stream()).toList());
    }

    /**
     * {@return why a scene could not be read}
     *
     * @param failure what reading it threw
     * @param name the scene's name
     */
    public static SceneReport of(IOException failure, String name) {
        if (failure instanceof SceneFormatException bad) {    // its message is the whole report
            return new SceneReport(bad.getMessage(), bad.problems());
        }
        boolean named = failure instanceof FileSystemException;
        return new SceneReport(named ? name + ": " + ((FileSystemException) failure).getReason() : failure.getMessage(), List.of());
    }

    boolean isEmpty() {
        return text.isEmpty();
    }
}
