package simpleray.cli;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.Path;
import simpleray.io.AtomicFile;
import simpleray.io.FileInUseException;
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
        try (AtomicFile file = begin(name)) {
            SceneWriter writer = new SceneWriter(file.out());
            text.write(writer);
            writer.flush();
            file.commit();
        } catch (IOException e) {
            throw new CommandException(ExitCode.WRITE_ERROR, "simpleray: " + name + ": cannot be written: " + e.getMessage());
        }
    }

    /**
     * Begins a file.
     *
     * @throws CommandException if it cannot be created
     */
    static AtomicFile begin(String name) throws CommandException {
        try {
            return new AtomicFile(Path.of(name));
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
        String reason = e.getMessage();
        if (e instanceof FileInUseException busy) {
            return new CommandException(ExitCode.BUSY, "simpleray: " + name + ": " + busy.getReason());
        }
        if (e instanceof FileSystemException f) {
            reason = f.getReason() != null ? f.getReason() : e.getClass().getSimpleName().replace("Exception", "");
        }
        return new CommandException(ExitCode.NO_OUTPUT, "simpleray: " + name + ": cannot be created: " + reason);
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
