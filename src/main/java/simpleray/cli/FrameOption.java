package simpleray.cli;

import simpleray.scene.Film;
import simpleray.scene.SceneFile;
import simpleray.text.NumberParser;

/** The option that says which frame of a film is meant. */
final class FrameOption extends OptionGroup {
    private static final String NAME = "--frame";

    private final CommandOption<Double> frame = add(new CommandOption<>(null, "F",
        "The frame of a film, from 0 to its last one; it need not be whole (default: 0).", NAME) {
        @Override
        Double parse(String text) {
            double value = NumberParser.parseDouble(text);
            if (Double.isNaN(value)) {
                throw new IllegalArgumentException("expected a number such as 12 or 12.5, found '" + text + "'");
            }
            return value;
        }
    });

    /** {@return whether it was given} */
    boolean isGiven() {
        return frame.value() != null;
    }

    /**
     * Returns the frame that is meant.
     *
     * @param file the scene
     * @param name the scene's name in messages
     * @return the frame's scene; the scene itself if it is no film
     * @throws CommandException if there is no such frame, or it has values that no scene may have
     */
    SceneFile of(SceneFile file, String name) throws CommandException {
        if (frame.value() == null && file.scene().settings.frames == null) {
            return file;                                      // without a class of films
        }
        double asked = frame.value() == null ? 0 : frame.value();
        Film film = file.scene().film();
        if (!film.has(asked)) {
            throw CommandException.usage(film.frames() == 1 ? NAME + " must be 0, the only frame of " + SceneArgument.told(name)
                : NAME + " must be 0 to " + (film.frames() - 1) + ", the frames of " + SceneArgument.told(name));
        }
        try {
            return file.still(asked);
        } catch (IllegalArgumentException e) {                // between two whole frames, which were checked when it was read
            throw new CommandException(ExitCode.BAD_SCENE, "simpleray: " + SceneArgument.told(name) + ": " + e.getMessage());
        }
    }
}
