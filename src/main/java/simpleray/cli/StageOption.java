package simpleray.cli;

import picocli.CommandLine.Option;
import simpleray.render.Stage;

/** The option that says which of the thesis's pictures is made. */
final class StageOption {
    @Option(names = "--stage", paramLabel = "STAGE", defaultValue = "final",
        description = "${COMPLETION-CANDIDATES} (default: ${DEFAULT-VALUE}): before lighting; with lighting; with shadows and "
            + "reflections; one term of lighting alone.")
    private Stage stage;

    Stage stage() {
        return stage;
    }
}
