package simpleray.cli;

import picocli.CommandLine.Option;
import simpleray.scene.Reach;

/** The option that lets a scene name files anywhere. */
final class OutsideOption {
    /** Its name. */
    static final String NAME = "--allow-outside";

    @Option(names = NAME,
        description = "The scene may also name OBJ files that are not in its own folder or below it. Only for scenes that you trust.")
    private boolean outside;

    /** Takes the option as picocli would. */
    boolean take(String name) {
        outside |= name.equals(NAME);
        return name.equals(NAME);
    }

    /** {@return which files the scene may name} */
    Reach reach() {
        return outside ? Reach.ANYWHERE : Reach.FOLDER;
    }
}
