package simpleray.cli;

import java.io.File;
import java.nio.file.Path;
import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.ParentCommand;
import simpleray.scene.Mesh;
import simpleray.scene.Scene;
import simpleray.scene.SceneFile;

/** Rewrites a scene in canonical form. */
@Command(mixinStandardHelpOptions = true,
    description = "Rewrites a scene in canonical form: the same scene, one line for each thing, comments aside. "
        + "IN and OUT may be one file.")
final class ConvertCommand implements Callable<Integer> {
    @ParentCommand
    private Main main;

    @Parameters(index = "0", paramLabel = "IN", description = SceneArgument.DESCRIPTION)
    private String in;

    @Parameters(index = "1", paramLabel = "OUT", description = "The scene file to write; - is standard output.")
    private String out;

    @Mixin
    private OutsideOption outside;

    @Override
    public Integer call() throws CommandException {
        OutputName.refusePicture(out, in);
        SceneFile file = SceneArgument.read(in, main.in(), main.err(), outside.reach());
        OutputName.refuseNamed(out, in, file);
        Scene scene = file.scene();
        boolean leaves = false;
        for (int i = 0; i < scene.getNumberObjects(); i++) {
            if (scene.getObject(i) instanceof Mesh mesh) {    // its file's name is relative to the scene's folder, which may be another
                mesh.file = folder(out).relativize(folder(in).resolve(mesh.file)).toString().replace(File.separatorChar, '/');
                leaves |= mesh.file.startsWith("../") || Path.of(mesh.file).isAbsolute();
            }
        }
        TextOutput.write(main, out, scene::write);
        if (leaves) {
            main.err().println(out + ": warning: names OBJ files outside its folder: " + OutsideOption.NAME + " allows them");
        }
        return ExitCode.DONE;
    }

    private static Path folder(String scene) {
        return (scene.equals(SceneArgument.STREAM) ? Path.of("") : Path.of(scene).resolveSibling("")).toAbsolutePath().normalize();
    }
}
