package simpleray.cli;

import java.io.FilterOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.stream.Stream;
import simpleray.io.OutputTarget;

/** The folder of a job, which is written whole or not at all. <em>Mutable,</em> for one thread. */
final class JobFolder implements AutoCloseable {
    private final String name;
    private final Path folder;
    private final Deque<Path> made = new ArrayDeque<>();      // the last one first
    private boolean whole;

    /**
     * Makes the folder, unless it is there and empty.
     *
     * @throws CommandException if it is there and not empty, or cannot be made
     */
    JobFolder(String name) throws CommandException {
        this.name = name;
        folder = Path.of(name);
        boolean there = Files.isDirectory(folder);
        TextOutput.makeFolder(name);
        if (!there) {
            made.push(folder);
        }
        try (Stream<Path> files = Files.list(folder)) {
            if (files.findAny().isPresent()) {
                throw new CommandException(ExitCode.NO_OUTPUT, "simpleray: " + name + ": is not empty: a job has a folder of its own");
            }
        } catch (IOException e) {
            throw cannot("be read", e);
        }
    }

    Path path(String file) {
        return folder.resolve(file);
    }

    /** Makes a folder in it. */
    void makeFolder(String file) throws CommandException {
        try {
            makeFolder(path(file));
        } catch (IOException e) {
            throw new CommandException(ExitCode.NO_OUTPUT, "simpleray: " + path(file) + ": cannot be created: " + OutputTarget.reason(e));
        }
    }

    private void makeFolder(Path path) throws IOException {
        if (!Files.isDirectory(path)) {
            makeFolder(path.getParent());
            if (!Files.isDirectory(path)) {                   // as a/.. is, once there is a
                Files.createDirectory(path);
                made.push(path);
            }
        }
    }

    /** Writes a text. */
    void write(String file, String text) throws CommandException {
        try (OutputStream out = begin(file)) {
            out.write(text.getBytes(StandardCharsets.UTF_8));
        } catch (IOException e) {
            throw cannot("be written", e);
        }
    }

    /**
     * Copies a file into it.
     *
     * @param from the file
     * @param file its name here
     * @throws CommandException if it cannot be read, or the copy cannot be written
     */
    void copy(Path from, String file) throws CommandException {
        try (InputStream in = Files.newInputStream(from); OutputStream out = begin(file)) {
            in.transferTo(new FilterOutputStream(out) {
                @Override
                public void write(byte[] bytes, int from, int length) throws IOException {
                    try {
                        out.write(bytes, from, length);
                    } catch (IOException e) {
                        throw new Unwritten(e);
                    }
                }
            });
        } catch (Unwritten e) {
            throw cannot("be written", e.cause);
        } catch (IOException e) {
            throw new CommandException(ExitCode.NO_SCENE, "simpleray: " + from + ": cannot be read: " + OutputTarget.reason(e));
        }
    }

    private static final class Unwritten extends IOException {
        private static final long serialVersionUID = 1L;
        private final IOException cause;

        Unwritten(IOException cause) {
            super(cause);
            this.cause = cause;
        }
    }

    private OutputStream begin(String file) throws Unwritten {
        try {
            makeFolder(path(file).resolveSibling(""));
            OutputStream out = Files.newOutputStream(path(file));
            made.push(path(file));
            return out;
        } catch (IOException e) {
            throw new Unwritten(e);
        }
    }

    private CommandException cannot(String what, IOException e) {
        return new CommandException(what.equals("be read") ? ExitCode.NO_OUTPUT : ExitCode.WRITE_ERROR,
            "simpleray: " + name + ": cannot " + what + ": " + OutputTarget.reason(e instanceof Unwritten u ? u.cause : e));
    }

    /** Keeps the folder, which has all that it is to have. */
    void keep() {
        whole = true;
    }

    /** Removes all that was made, unless the folder is to be kept. */
    @Override
    public void close() {
        while (!whole && !made.isEmpty()) {
            try {
                Files.delete(made.pop());
            } catch (IOException e) {                         // then it stays
                continue;
            }
        }
    }
}
