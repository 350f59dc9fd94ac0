package simpleray.cli;

import java.io.File;
import java.nio.file.Path;
import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.ParentCommand;
import simpleray.scene.Mesh;
import simpleray.scene.Scene;

/** Rewrites a scene in canonical form. */
@Command(name = "convert", mixinStandardHelpOptions = true,
    description = "Rewrites a scene in canonical form: the same scene, one line for each thing, comments aside. "
        + "IN and OUT may be one file.")
final class ConvertCommand implements Callable<Integer> {
    @ParentCommand
    private Main main;

    @Parameters(index = "0", paramLabel = "IN", description = SceneArgument.DESCRIPTION)
    private String in;

    @Parameters(index = "1", paramLabel = "OUT", description = "The scene file to write; - is standard output.")
    private String out;

    @Override
    public Integer call() throws Failure {
        Scene scene = SceneArgument.read(in, main.in(), main.err()).scene();
        for (int i = 0; i < scene.getNumberObjects(); i++) {
            if (scene.getObject(i) instanceof Mesh mesh) {    // its file's name is relative to the scene's folder, which may be another
                mesh.file = folder(out).relativize(folder(in).resolve(mesh.file)).toString().replace(File.separatorChar, '/');
            }
        }
        TextOutput.write(main, out, scene::write);
        return ExitCode.DONE;
    }

    private static Path folder(String scene) {
        return (scene.equals(SceneArgument.STREAM) ? Path.of("") : Path.of(scene).resolveSibling("")).toAbsolutePath().normalize();
    }
}
