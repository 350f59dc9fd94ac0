package simpleray.cli;

import java.nio.file.FileSystemException;
import java.nio.file.Path;
import simpleray.io.OutputTarget;

/** The options that say what becomes of the rows of a rendering that is ended before its picture is whole. */
final class CheckpointOptions extends OptionGroup {
    /** What the checkpoint of a picture is called unless it is named: this behind the picture's name. */
    private static final String PART = ".part";

    private final CommandOption<String> checkpoint = add(CommandOption.text("FILE",
        "Keep each finished row in FILE until the picture is whole (default: in OUT.png.part, from 10 seconds on).", "--checkpoint"));
    private final CommandOption<Boolean> resume = add(CommandOption.flag(
        "Go on with the rows that an ended rendering has kept; the picture is the same as if it had not been ended.", "--resume"));
    private final CommandOption<Boolean> restart = add(CommandOption.flag(
        "Discard the rows that an ended rendering has kept, and begin anew.", "--restart"));

    /** {@return whether rows are to be kept from the start} */
    boolean isNamed() {
        return checkpoint.value() != null;
    }

    /** {@return whether kept rows are to be used} */
    boolean resumes() {
        return resume.value() && !restart.value();
    }

    /** {@return whether kept rows are to be discarded} */
    boolean restarts() {
        return restart.value();
    }

    /**
     * Finds where rows are kept.
     *
     * @param output the picture's file, or - for standard output
     * @return the file; null if there is none
     * @throws CommandException if there must be one, and no name can be made of the picture's
     */
    Path file(String output) throws CommandException {
        String named = checkpoint.value();
        boolean stream = output.equals(SceneArgument.STREAM);
        if (named == null && (stream || OutputTarget.isStream(Path.of(output)))) {
            if (resume.value() || restart.value()) {
                throw CommandException.usage((restart.value() ? "--restart" : "--resume")
                    + " needs --checkpoint FILE where the picture goes to " + (stream ? "standard output" : output));
            }
            return null;
        }
        Path file = Path.of(named == null ? output + PART : named);
        if (file.toAbsolutePath().normalize().equals(Path.of(output).toAbsolutePath().normalize())) {
            throw CommandException.usage("the checkpoint " + file + " is the output itself");
        }
        if (named != null) {
            try {
                OutputName.requireFile(named);
            } catch (FileSystemException e) {
                throw new CommandException(ExitCode.NO_OUTPUT, "simpleray: " + named + ": " + e.getReason());
            }
        }
        return file;
    }
}
