package simpleray.cli;

import java.io.File;
import java.io.IOException;
import java.io.PushbackInputStream;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import java.util.Set;
import simpleray.image.png.PngChunks;
import simpleray.io.MagicNumber;
import simpleray.io.OutputTarget;
import simpleray.scene.SceneFile;

/** What an output may not be called: nothing that a command reads is written over. In all names - is standard input or output. */
final class OutputName {
    private static final Set<String> OTHER_FORMATS = Set.of("jpg", "jpeg", "gif", "bmp", "tif", "tiff", "webp", "ppm", "svg", "pdf");
    private static final Set<String> SCENES = Set.of("scene", "txt", "obj", "mtl", "pov");
    private static final String STDIN = "/dev/stdin";
    private static final String STDOUT = "/dev/stdout";

    private OutputName() {
    }

    /** {@return whether an output is standard output, by whatever name} */
    static boolean isStandardOutput(String output) {
        return output.equals(SceneArgument.STREAM) || OutputTarget.isStandardOutput(Path.of(output));
    }

    /**
     * Makes sure that a name does not end as that of a folder.
     *
     * @throws FileSystemException if it does
     */
    static void requireFile(String name) throws FileSystemException {
        if (name.endsWith("/") || name.endsWith(File.separator)) {
            Path folder = Path.of(name);
            throw new FileSystemException(name, null, Files.isDirectory(folder) ? "is a folder" : "there is no folder " + folder);
        }
    }

    /**
     * Makes sure that an output is none of the files that a command reads.
     *
     * @param output the output's name
     * @param input the input's name
     * @param what what messages call the input
     * @throws CommandException if writing one would lose the other
     */
    static void refuse(String output, String input, String what) throws CommandException {
        if (isSame(input, output)) {
            throw CommandException.usage("the output " + output + " is " + what);
        }
    }

    /**
     * Makes sure that an output is not the scene.
     *
     * @param output the output's name
     * @param scene the scene's name
     * @throws CommandException if it is
     */
    static void refuseScene(String output, String scene) throws CommandException {
        refuse(output, scene, "the scene itself");
    }

    /**
     * Makes sure that an output is not a picture of which the scene is read. A scene may be written over itself.
     *
     * @param output the output's name
     * @param scene the scene's name
     * @throws CommandException if it is
     */
    static void refusePicture(String output, String scene) throws CommandException {
        if (isSame(scene, output) && isPicture(Path.of(output))) {
            throw CommandException.usage("the output " + output + " is the picture that carries the scene");
        }
    }

    /**
     * Makes sure that an output is none of the files that a scene names.
     *
     * @param output the output's name
     * @param scene the scene's name
     * @param read the scene
     * @throws CommandException if it is one
     */
    static void refuseNamed(String output, String scene, SceneFile read) throws CommandException {
        if (read.text().names(path(output), Path.of(scene).resolveSibling(""))) {
            throw CommandException.usage("the output " + output + " is read by the scene");
        }
    }

    /**
     * Makes sure that a picture is not called as scenes and meshes are.
     *
     * @param output the picture's name
     * @throws CommandException if it is
     */
    static void refuseSceneNames(String output) throws CommandException {
        refuseEndings(output, SCENES);
        if (Files.isSymbolicLink(Path.of(output))) {
            String name = behindLinks(output);
            if (hasEnding(name, SCENES)) {
                throw CommandException.usage("pictures are written as PNG only, and the output " + output + " is a link to " + name);
            }
        }
    }

    private static String behindLinks(String output) {
        try {
            return OutputTarget.file(Path.of(output)).toString();
        } catch (IOException e) {
            return output;                                    // then opening it says what is wrong
        }
    }

    /**
     * Makes sure that a picture is not called as those of other formats are.
     *
     * @param output the picture's name
     * @throws CommandException if it is
     */
    static void refuseOtherFormats(String output) throws CommandException {
        refuseEndings(output, OTHER_FORMATS);
    }

    private static void refuseEndings(String output, Set<String> endings) throws CommandException {
        if (hasEnding(output, endings)) {
            throw CommandException.usage("pictures are written as PNG only: call the output " + output + ".png?");
        }
    }

    private static boolean hasEnding(String name, Set<String> endings) {
        return name.contains(".") && endings.contains(name.substring(name.lastIndexOf('.') + 1).toLowerCase(Locale.ROOT));
    }

    private static boolean isSame(String input, String output) {
        return OutputTarget.isSame(path(output), Path.of(input.equals(SceneArgument.STREAM) ? STDIN : input));
    }

    /** {@return the path of an output; of standard output, which a shell may have opened on any file, its name among the devices} */
    private static Path path(String output) {
        return Path.of(output.equals(SceneArgument.STREAM) ? STDOUT : output);
    }

    private static boolean isPicture(Path path) {
        try (PushbackInputStream in = new PushbackInputStream(Files.newInputStream(path), MagicNumber.LENGTH)) {
            return PngChunks.begin(in);
        } catch (IOException e) {
            return false;
        }
    }
}
