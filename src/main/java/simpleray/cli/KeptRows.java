package simpleray.cli;

import java.io.IOException;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import java.util.function.Supplier;
import simpleray.image.Checkpoint;
import simpleray.image.Picture;
import simpleray.io.OutputTarget;
import simpleray.render.PictureIdentity;
import simpleray.render.Renderer;

/** The rows that an earlier rendering has kept, if there are any, and what becomes of them. <em>Mutable,</em> for one thread. */
final class KeptRows {
    private final Path path;
    private final CheckpointOptions options;
    private final Renderer renderer;
    private final RenderCheckpointer.Notes notes;
    private boolean free;

    /**
     * Prepares to look.
     *
     * @param path where they are
     * @param options what is asked for
     * @param renderer the rendering, not begun yet
     * @param notes where messages go
     */
    KeptRows(Path path, CheckpointOptions options, Renderer renderer, RenderCheckpointer.Notes notes) {
        this.path = path;
        this.options = options;
        this.renderer = renderer;
        this.notes = notes;
    }

    /**
     * Goes on with the rows if that is asked for, or discards them.
     *
     * @param identity finds what decides the picture's pixels
     * @return the checkpoint to go on with; null for none
     * @throws CommandException if they are of another picture, or something else is to be done first
     * @throws IOException if they cannot be used
     */
    Checkpoint resume(Supplier<Map<String, String>> identity) throws IOException, CommandException {
        if (!Files.exists(path)) {
            free = true;
            if (options.resumes()) {
                notes.say(path + " is not there: beginning with the first row");
            }
            return null;
        }
        Map<String, String> was;
        try {
            was = Checkpoint.identity(path);
        } catch (FileSystemException e) {
            if (!options.isNamed() && !options.resumes() && !options.restarts()) {
                return null;                                  // somebody's file that has the name by chance
            }
            if (options.resumes()) {
                throw new CommandException(ExitCode.BAD_SCENE, "simpleray: " + path + ": " + OutputTarget.reason(e));
            }
            throw e;
        }
        if (was == null || options.restarts()) {
            if (was == null && options.resumes()) {
                notes.say(path + " holds no row: beginning with the first");
            }
            Checkpoint.delete(path);
            free = true;
            return null;
        }
        if (options.resumes()) {
            return resume(was, identity.get());
        }
        if (options.isNamed()) {
            throw new CommandException(ExitCode.NO_OUTPUT, "simpleray: " + path
                + " holds rows of an earlier rendering: --resume goes on with them, --restart discards them");
        }
        notes.say(path + " holds rows of an earlier rendering, which --resume goes on with and --restart discards; "
            + "this one begins with the first row, and keeps none");
        return null;
    }

    private Checkpoint resume(Map<String, String> was, Map<String, String> now) throws IOException, CommandException {
        String difference = PictureIdentity.difference(was, now);
        if (!difference.isEmpty()) {
            throw new CommandException(ExitCode.BAD_SCENE, "simpleray: " + path + " holds rows of another picture: " + difference
                + " (--restart discards them)");
        }
        Picture picture = renderer.picture();
        Checkpoint opened = Checkpoint.open(path, was, picture.channels() * picture.width(), picture.height());
        notes.say("going on with " + opened.count() + " of " + picture.height() + " rows, kept in " + path);
        renderer.know(y -> light(opened, y));
        return opened;
    }

    private static double[] light(Checkpoint checkpoint, int y) {
        try {
            byte[] levels = checkpoint.levels(y);
            return levels == null ? null : Picture.light(levels);
        } catch (IOException e) {
            return null;                                      // then it is rendered
        }
    }

    /** {@return whether a new checkpoint may be begun there} */
    boolean isFree() {
        return free;
    }
}
