package simpleray.cli;

import java.io.FilterInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.ParentCommand;
import simpleray.convert.ForeignFormat;
import simpleray.convert.ImportedScene;
import simpleray.io.AtomicFile;
import simpleray.io.InputFile;
import simpleray.io.OutputTarget;
import simpleray.text.SceneFormatException;
import simpleray.text.SceneWriter;

/** Makes a scene of that of another program. */
@Command(mixinStandardHelpOptions = true, sortOptions = false,
    description = "Makes a scene of that of another program, as exactly as can be: .rt (miniRT) or .nff (Haines' Neutral File Format). "
        + "A warning tells what is changed or left out.")
final class ImportCommand implements Callable<Integer> {
    @ParentCommand
    private Main main;

    @Parameters(paramLabel = "FILE", description = "The file to read; - is standard input.")
    private String file;

    @Option(names = {"-o", "--output"}, paramLabel = "OUT.scene", required = true,
        description = "The scene file to write; - is standard output. Many polygons go to an OBJ beside it, of the same name.")
    private String output;

    @Option(names = "--from", paramLabel = "FORMAT", description = "${COMPLETION-CANDIDATES}: the file's format (default: by its name).")
    private ForeignFormat from;

    @Override
    public Integer call() throws CommandException {
        OutputName.refuse(output, file, "the file to read");
        if (from == null) {
            from = ForeignFormat.of(file);
        }
        if (from == null) {
            throw CommandException.usage("the name of " + SceneArgument.told(file) + " tells no format: --from rt or --from nff does");
        }
        ImportedScene scene = read();
        if (scene.facets().areMesh()) {
            writeWithMesh(scene);
        } else {
            TextOutput.write(main, output, scene::write);
        }
        scene.warnings().forEach(warning -> main.err().println(warning));
        return ExitCode.DONE;
    }

    private ImportedScene read() throws CommandException {
        String reason = file.equals(SceneArgument.STREAM) ? null : InputFile.refusal(Path.of(file));
        if (reason != null) {
            throw new CommandException(ExitCode.NO_SCENE, "simpleray: " + file + ": " + reason);
        }
        try (InputStream in = open()) {
            return from.read(in, SceneArgument.told(file));
        } catch (SceneFormatException e) {
            throw new CommandException(ExitCode.BAD_SCENE, e.getMessage());
        } catch (IOException e) {
            throw new CommandException(ExitCode.NO_SCENE, "simpleray: " + file + ": cannot be read: " + OutputTarget.reason(e));
        }
    }

    private InputStream open() throws IOException {
        return file.equals(SceneArgument.STREAM) ? new FilterInputStream(main.in()) {
            @Override
            public void close() {
                // standard input stays open
            }
        } : Files.newInputStream(Path.of(file));
    }

    private void writeWithMesh(ImportedScene scene) throws CommandException {
        if (OutputName.isStandardOutput(output) || OutputTarget.isStream(Path.of(output))) {
            throw CommandException.usage("polygons go to an OBJ beside the scene, which " + output + " has no place for");
        }
        Path target = Path.of(output);
        String name = target.getFileName() == null ? "" : target.getFileName().toString();
        String base = name.contains(".") ? name.substring(0, name.lastIndexOf('.')) : name;
        if (base.isEmpty() || name.matches("(?i).*\\.(obj|mtl)") || base.matches("(?s).*[\"\n\r].*")) {
            throw CommandException.usage("the output " + output + " leaves no name for an OBJ beside it");
        }
        String obj = beside(base + ".obj");
        String mtl = scene.facets().areColourful() ? beside(base + ".mtl") : null;
        try (AtomicFile objFile = TextOutput.begin(obj, main.err());
            AtomicFile mtlFile = mtl == null ? null : TextOutput.begin(mtl, main.err());
            AtomicFile sceneFile = TextOutput.begin(output, main.err())) {
            fill(objFile, os -> scene.writeObj(os, base + ".mtl"));
            if (mtlFile != null) {
                fill(mtlFile, scene::writeMtl);
            }
            fill(sceneFile, os -> scene.write(os, base + ".obj"));
            objFile.commit();
            if (mtlFile != null) {
                mtlFile.commit();
            }
            sceneFile.commit();
        } catch (IOException e) {
            throw new CommandException(ExitCode.WRITE_ERROR, "simpleray: " + output + ": cannot be written: " + OutputTarget.reason(e));
        }
    }

    /**
     * Finds the path of a file beside the scene.
     *
     * @throws CommandException if that is what is read, or a file that no import has written
     */
    private String beside(String name) throws CommandException {
        Path path = Path.of(output).resolveSibling(name);
        OutputName.refuse(path.toString(), file, "the file to read");
        if (Files.isDirectory(path)) {
            throw new CommandException(ExitCode.NO_OUTPUT, "simpleray: " + path + ": is a folder: give the scene another name");
        }
        if (Files.exists(path)) {
            byte[] mark = ImportedScene.MARK.getBytes(StandardCharsets.UTF_8);
            boolean ours;
            try (InputStream in = Files.newInputStream(path)) {
                ours = new String(in.readNBytes(mark.length), StandardCharsets.UTF_8).equals(ImportedScene.MARK);
            } catch (IOException e) {
                ours = false;
            }
            if (!ours) {
                throw new CommandException(ExitCode.NO_OUTPUT, "simpleray: " + path + ": is there, and from no import: "
                    + "give the scene another name, or this file");
            }
        }
        return path.toString();
    }

    private static void fill(AtomicFile file, TextOutput.Text text) throws IOException {
        SceneWriter writer = new SceneWriter(file.out());
        text.write(writer);
        writer.flush();
    }
}
