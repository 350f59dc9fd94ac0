package simpleray.cli;

import java.io.File;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.function.Consumer;
import simpleray.io.AtomicFile;
import simpleray.io.FileInUseException;
import simpleray.io.OutputTarget;
import simpleray.scene.Mesh;
import simpleray.scene.Scene;
import simpleray.text.SceneWriter;

/** Writes text to a file or to standard output. */
final class TextOutput {
    private TextOutput() {
    }

    /** Something that writes text. */
    interface Text {
        void write(SceneWriter out) throws IOException;
    }

    /**
     * Writes a text whole, or not at all.
     *
     * @param name a path, or - for standard output
     * @throws CommandException if the output cannot be created or written
     */
    static void write(Main main, String name, Text text) throws CommandException {
        if (name.equals(SceneArgument.STREAM)) {
            try {
                SceneWriter writer = new SceneWriter(main.out());
                text.write(writer);
                writer.flush();
            } catch (IOException e) {
                throw new CommandException(ExitCode.WRITE_ERROR, "simpleray: standard output cannot be written: " + e.getMessage());
            }
            return;
        }
        try (AtomicFile file = begin(name, main.err())) {
            SceneWriter writer = new SceneWriter(file.out());
            text.write(writer);
            writer.flush();
            file.commit();
        } catch (IOException e) {
            throw new CommandException(ExitCode.WRITE_ERROR, "simpleray: " + name + ": cannot be written: " + e.getMessage());
        }
    }

    /**
     * Writes a scene, whole or not at all. Its OBJ files stay where they are, and so its meshes may get other names for them.
     *
     * @param name a path, or - for standard output
     * @param from the name of the scene in whose folder the OBJ files are now
     * @throws CommandException if the output cannot be created or written
     */
    static void writeScene(Main main, String name, Scene scene, String from) throws CommandException {
        boolean leaves = false;
        for (int i = 0; i < scene.getNumberObjects(); i++) {
            if (scene.getObject(i) instanceof Mesh mesh) {    // its file's name is relative to the scene's folder, which may be another
                mesh.file = folder(name).relativize(folder(from).resolve(mesh.file)).toString().replace(File.separatorChar, '/');
                leaves |= mesh.file.startsWith("../") || Path.of(mesh.file).isAbsolute();
            }
        }
        write(main, name, scene::write);
        if (leaves) {
            main.err().println(name + ": warning: names OBJ files outside its folder: " + OutsideOption.NAME + " allows them");
        }
    }

    private static Path folder(String scene) {
        return (scene.equals(SceneArgument.STREAM) ? Path.of("") : Path.of(scene).resolveSibling("")).toAbsolutePath().normalize();
    }

    /**
     * Begins a file.
     *
     * @param name its path
     * @param notes told in what way it could not be written as files usually are; null for nobody
     * @throws CommandException if it cannot be created
     */
    static AtomicFile begin(String name, PrintStream notes) throws CommandException {
        try {
            OutputName.requireFile(name);
            return new AtomicFile(Path.of(name), new Consumer<String>() {   // no lambda: the first one takes its time
                @Override
                public void accept(String note) {
                    if (notes != null) {
                        notes.println("simpleray: " + name + ": " + note);
                    }
                }
            });
        } catch (IOException e) {
            throw notCreated(name, e);
        }
    }

    /**
     * Makes sure that a folder is there.
     *
     * @throws CommandException if it cannot be created
     */
    static void makeFolder(String name) throws CommandException {
        try {
            Files.createDirectories(Path.of(name));
        } catch (FileAlreadyExistsException e) {
            throw new CommandException(ExitCode.NO_OUTPUT, "simpleray: " + name + ": cannot be created: " + e.getFile() + " is no folder");
        } catch (IOException e) {
            throw notCreated(name, e);
        }
    }

    private static CommandException notCreated(String name, IOException e) {
        if (e instanceof FileInUseException busy) {
            return new CommandException(ExitCode.BUSY, "simpleray: " + name + ": " + busy.getReason());
        }
        return new CommandException(ExitCode.NO_OUTPUT, "simpleray: " + name + ": cannot be created: " + OutputTarget.reason(e));
    }

    /**
     * Writes to standard output.
     *
     * @throws CommandException if it cannot be written
     */
    static void say(Main main, String text) throws CommandException {
        try {
            main.out().write(text.getBytes(StandardCharsets.UTF_8));
            main.out().flush();
        } catch (IOException e) {
            throw new CommandException(ExitCode.WRITE_ERROR, "simpleray: standard output cannot be written: " + e.getMessage());
        }
    }
}
