package simpleray.cli;

import picocli.CommandLine.Option;
import simpleray.render.Stage;

/** The option that says which picture is made. */
final class StageOption {
    @Option(names = "--stage", paramLabel = "STAGE", defaultValue = "final",
        description = "${COMPLETION-CANDIDATES} (default: ${DEFAULT-VALUE}): before lighting; with lighting; with shadows and "
            + "reflections; one term of lighting alone; or what it shows of the things themselves.")
    private Stage stage = Stage.FINAL;

    /** Takes an option as picocli would. */
    boolean take(String name, String value) {
        if (!name.equals("--stage")) {
            return false;
        }
        stage = Values.constant(Stage.values(), value);
        return true;
    }

    Stage stage() {
        return stage;
    }
}
