package simpleray.cli;

import simpleray.render.Stage;

/** The option that says which picture is made. */
final class StageOption extends OptionGroup {
    private final CommandOption<Stage> stage = add(CommandOption.choice(Stage.values(), Stage.FINAL, "STAGE",
        "${COMPLETION-CANDIDATES} (default: ${DEFAULT-VALUE}): before lighting; with lighting; with shadows and "
            + "reflections; one term of lighting alone; or what it shows of the things themselves.", "--stage"));

    Stage stage() {
        return stage.value();
    }
}
