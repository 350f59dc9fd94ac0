package simpleray.cli;

import simpleray.scene.Reach;

/** The option that lets a scene name files anywhere. */
final class OutsideOption extends OptionGroup {
    /** Its name. */
    static final String NAME = "--allow-outside";

    private final CommandOption<Boolean> outside = add(CommandOption.flag(
        "The scene may also name OBJ files that are not in its own folder or below it. Only for scenes that you trust.",
        NAME));

    /** {@return which files the scene may name} */
    Reach reach() {
        return outside.value() ? Reach.ANYWHERE : Reach.FOLDER;
    }
}
