package simpleray.cli;

import java.nio.file.Path;
import picocli.CommandLine.Option;

/** The options that say what becomes of the rows of a rendering that is ended before its picture is whole. */
final class CheckpointOptions {
    /** What the checkpoint of a picture is called unless it is named: this behind the picture's name. */
    private static final String PART = ".part";

    @Option(names = "--checkpoint", paramLabel = "FILE",
        description = "Keep each finished row in FILE until the picture is whole (default: in OUT.png.part, from 10 seconds on).")
    private String checkpoint;

    @Option(names = "--resume",
        description = "Go on with the rows that an ended rendering has kept; the picture is the same as if it had not been ended.")
    private boolean resume;

    @Option(names = "--restart",
        description = "Discard the rows that an ended rendering has kept, and begin anew.")
    private boolean restart;

    /** Takes an option as picocli would. */
    boolean take(String name, String value) {
        switch (name) {
            case "--checkpoint" -> checkpoint = value;
            case "--resume" -> resume = true;
            case "--restart" -> restart = true;
            default -> {
                return false;
            }
        }
        return true;
    }

    /** {@return whether rows are to be kept from the start} */
    boolean isNamed() {
        return checkpoint != null;
    }

    /** {@return whether kept rows are to be used} */
    boolean resumes() {
        return resume && !restart;
    }

    /** {@return whether kept rows are to be discarded} */
    boolean restarts() {
        return restart;
    }

    /**
     * Finds where rows are kept.
     *
     * @param output the picture's file, or - for standard output
     * @return the file; null if there is none
     * @throws CommandException if there must be one, and no name can be made of the picture's
     */
    Path file(String output) throws CommandException {
        if (checkpoint == null && output.equals(SceneArgument.STREAM)) {
            if (resume || restart) {
                throw CommandException.usage((restart ? "--restart" : "--resume")
                    + " needs --checkpoint FILE where the picture goes to standard output");
            }
            return null;
        }
        Path file = Path.of(checkpoint == null ? output + PART : checkpoint);
        if (file.toAbsolutePath().normalize().equals(Path.of(output).toAbsolutePath().normalize())) {
            throw CommandException.usage("the checkpoint " + file + " is the output itself");
        }
        return file;
    }
}
