package simpleray.cli;

import java.io.IOException;
import java.io.InputStream;
import java.io.PrintStream;
import java.nio.file.FileSystemException;
import java.nio.file.Path;
import simpleray.image.png.PictureFormatException;
import simpleray.scene.Reach;
import simpleray.scene.SceneFile;
import simpleray.text.Diagnostic;
import simpleray.text.SceneFormatException;

/** Reads the scene that a command line names. */
final class SceneArgument {
    /** The name of standard input and standard output. */
    static final String STREAM = "-";
    static final String DESCRIPTION = "The scene file; - is standard input.";

    private SceneArgument() {
    }

    /**
     * Reads a scene.
     *
     * @param name a path, or - for standard input
     * @param in standard input
     * @param reach the OBJ files that it may name
     */
    static SceneFile open(String name, InputStream in, Reach reach) throws IOException {
        return name.equals(STREAM) ? SceneFile.read(in, reach) : SceneFile.read(Path.of(name), reach);
    }

    /** {@return the name of a scene in messages} */
    static String told(String name) {
        return name.equals(STREAM) ? "<stdin>" : name;
    }

    /**
     * Reads a scene and prints its warnings.
     *
     * @param name a path, or - for standard input
     * @param in standard input
     * @param warnings gets the warnings; null for none
     * @param reach the OBJ files that it may name
     * @return the scene
     * @throws CommandException with the whole report if it is bad or cannot be read
     */
    static SceneFile read(String name, InputStream in, PrintStream warnings, Reach reach) throws CommandException {
        try {
            SceneFile file = open(name, in, reach);
            if (warnings != null) {
                for (Diagnostic warning : file.warnings()) {
                    warnings.println(warning);
                }
            }
            return file;
        } catch (SceneFormatException e) {
            throw new CommandException(ExitCode.BAD_SCENE, e.getMessage());
        } catch (PictureFormatException e) {
            throw new CommandException(ExitCode.BAD_SCENE, "simpleray: " + e.getMessage());
        } catch (FileSystemException e) {
            throw new CommandException(ExitCode.NO_SCENE, "simpleray: " + name + ": " + e.getReason());
        } catch (IOException e) {
            throw new CommandException(ExitCode.NO_SCENE, "simpleray: " + name + ": cannot be read: " + e.getMessage());
        }
    }
}
