package simpleray.cli;

import java.io.IOException;
import java.io.InputStream;
import java.io.PrintStream;
import java.nio.file.FileSystemException;
import java.nio.file.Path;
import simpleray.scene.SceneFile;
import simpleray.text.Problem;
import simpleray.text.SceneFormatException;

/** Reads the scene that a command line names. */
final class SceneArgument {
    /** The name of standard input and standard output. */
    static final String STREAM = "-";
    static final String DESCRIPTION = "The scene file; - is standard input.";

    private SceneArgument() {
    }

    /**
     * Reads a scene and reports what is odd about it.
     *
     * @param name a path, or - for standard input
     * @param in standard input
     * @param warnings where warnings go; null for nowhere
     * @return the scene
     * @throws Failure with the whole report if it is bad or cannot be read
     */
    static SceneFile read(String name, InputStream in, PrintStream warnings) throws Failure {
        try {
            SceneFile file = name.equals(STREAM) ? SceneFile.read(in) : SceneFile.read(Path.of(name));
            if (warnings != null) {
                for (Problem warning : file.warnings()) {
                    warnings.println(warning);
                }
            }
            return file;
        } catch (SceneFormatException e) {
            throw new Failure(ExitCode.BAD_SCENE, e.getMessage());
        } catch (FileSystemException e) {
            throw new Failure(ExitCode.NO_SCENE, "simpleray: " + name + ": " + e.getReason());
        } catch (IOException e) {
            throw new Failure(ExitCode.NO_SCENE, "simpleray: " + name + ": cannot be read: " + e.getMessage());
        }
    }
}
