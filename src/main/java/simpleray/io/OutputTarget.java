package simpleray.io;

import java.io.BufferedOutputStream;
import java.io.FileDescriptor;
import java.io.FileOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.io.UncheckedIOException;
import java.net.UnixDomainSocketAddress;
import java.nio.channels.Channels;
import java.nio.channels.SocketChannel;
import java.nio.charset.StandardCharsets;
import java.nio.file.AccessDeniedException;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.nio.file.attribute.BasicFileAttributes;
import java.util.Locale;
import java.util.stream.Stream;
import java.util.zip.CRC32;

/** What the name of an output stands for: a file, which need not be there yet, or a stream, which is written to as it is. */
public final class OutputTarget {
    /** As many links are followed as Linux follows. */
    private static final int MAX_LINKS = 40;
    /** The longest name, in bytes, to which something is added; on some disks 143 is all that a name may have. */
    private static final int LONGEST_NAME = 100;

    private OutputTarget() {
    }

    /**
     * Tells whether a name stands for something that is no file: an open file of a process such as {@code /dev/fd/3}, a device, a pipe,
     * a socket.
     *
     * @param path the name
     * @return whether it is written to as it is, and nothing can lie beside it
     */
    public static boolean isStream(Path path) {
        return descriptor(path) != null || Files.exists(path) && !Files.isRegularFile(path) && !Files.isDirectory(path);
    }

    /**
     * Tells whether a name stands for standard output, as {@code /dev/stdout} does.
     *
     * @param path the name
     * @return whether it is the same as writing to standard output
     */
    public static boolean isStandardOutput(Path path) {
        return standard(descriptor(path)) == FileDescriptor.out;
    }

    /**
     * Tells whether writing one file would lose another.
     *
     * @param written the path of what is written
     * @param read the path of what is to stay
     * @return whether both are one file, by whatever names
     */
    public static boolean isSame(Path written, Path read) {
        try {
            return Files.isRegularFile(written) && Files.isSameFile(written, read);
        } catch (IOException e) {
            return false;                                     // then opening them says what is wrong
        }
    }

    /** {@return the open file that a path names, in a folder without links; null if it names none} */
    private static Path descriptor(Path path) {
        Path at = path.toAbsolutePath();
        try {
            for (int links = 0; links < MAX_LINKS && at.getParent() != null; links++) {
                Path folder = at.getParent().toRealPath();
                if (folder.endsWith("fd") && folder.startsWith("/proc") || folder.toString().equals("/dev/fd")) {
                    return folder.resolve(at.getFileName());
                }
                if (!Files.isSymbolicLink(at)) {
                    return null;
                }
                at = folder.resolve(Files.readSymbolicLink(at));
            }
        } catch (IOException e) {
            return null;                                      // opening it says what is wrong
        }
        return null;
    }

    /** {@return this process's standard output or standard error if an open file is that; else null} */
    private static FileDescriptor standard(Path descriptor) {
        try {
            if (descriptor == null || !descriptor.startsWith("/dev")
                && !descriptor.getParent().equals(Path.of("/proc/self/fd").toRealPath())) {
                return null;
            }
            return switch (descriptor.getFileName().toString()) {
                case "1" -> FileDescriptor.out;
                case "2" -> FileDescriptor.err;
                default -> null;
            };
        } catch (IOException e) {
            return null;
        }
    }

    /**
     * Opens what is a stream.
     *
     * @throws FileSystemException if it cannot be opened; the reason says why
     */
    static OutputStream open(Path path) throws IOException {
        Path descriptor = descriptor(path);
        if (descriptor == null) {
            return new BufferedOutputStream(device(path));
        }
        FileDescriptor standard = standard(descriptor);
        if (standard != null) {
            return new BufferedOutputStream(new FileOutputStream(standard)) {
                @Override
                public void close() throws IOException {
                    flush();                                  // messages still go there
                }
            };
        }
        if (!Files.exists(descriptor)) {
            throw new FileSystemException(path.toString(), null, "is no open file");
        }
        if (Files.isSymbolicLink(descriptor) && Files.readSymbolicLink(descriptor).toString().startsWith("socket:")) {
            throw new FileSystemException(path.toString(), null, "is a socket that has no name: write to standard output, and add >&"
                + descriptor.getFileName());
        }
        if (isReadOnly(descriptor)) {
            throw new FileSystemException(path.toString(), null, "is open for reading only");
        }
        // a file that was opened to be added to is not cut off
        return new BufferedOutputStream(Files.newOutputStream(descriptor, StandardOpenOption.WRITE, StandardOpenOption.APPEND));
    }

    /** {@return whether an open file is known to be open for reading only} Opening it anew by its name would allow more. */
    private static boolean isReadOnly(Path descriptor) {
        Path info = descriptor.getParent().resolveSibling("fdinfo").resolve(descriptor.getFileName());
        try (Stream<String> lines = Files.lines(info)) {
            return lines.anyMatch(line -> line.matches("flags:\\s*[0-7]*[04]"));   // O_RDONLY is 0; the last two bits tell
        } catch (IOException | UncheckedIOException e) {
            return false;                                     // no such system
        }
    }

    /** Opens a device or a pipe, or connects to a socket, which cannot be opened. */
    private static OutputStream device(Path path) throws IOException {
        if (!Files.isWritable(path)) {
            throw new FileSystemException(path.toString(), null, "is write-protected");
        }
        try {
            return Files.newOutputStream(path, StandardOpenOption.WRITE);
        } catch (FileSystemException e) {
            try {
                return Channels.newOutputStream(SocketChannel.open(UnixDomainSocketAddress.of(path)));
            } catch (IOException | UnsupportedOperationException none) {
                e.addSuppressed(none);
                throw e;
            }
        }
    }

    /**
     * Finds the file that a name stands for, which need not be there.
     *
     * @param path the name
     * @return the file's path, behind all links
     * @throws FileSystemException if there can be no such file; the reason says why
     * @throws IOException likewise
     */
    public static Path file(Path path) throws IOException {
        Path target;
        try {
            target = path.toRealPath();
        } catch (IOException e) {                             // mostly because it is not there yet
            target = followed(path.toAbsolutePath());
        }
        Path folder = target.getParent();
        if (folder == null || !Files.isDirectory(folder)) {
            boolean known = folder == null || Files.exists(folder) || Files.notExists(folder);
            throw new FileSystemException(path.toString(), null, known ? "there is no folder " + folder : "its folder may not be entered");
        }
        try {
            Files.readAttributes(target, BasicFileAttributes.class);
        } catch (AccessDeniedException e) {
            throw new FileSystemException(path.toString(), null, "its folder may not be entered");
        } catch (FileSystemException e) {
            if (e.getReason() != null) {                      // not because there is none yet, but because it cannot be, as a name too long
                throw new FileSystemException(path.toString(), null, e.getReason());
            }
        }
        return target;
    }

    /** {@return where links lead that lead to no file yet; the path itself if it is no link} */
    private static Path followed(Path path) throws IOException {
        Path at = path;
        for (int links = 0; links < MAX_LINKS && Files.isSymbolicLink(at); links++) {
            at = at.resolveSibling(Files.readSymbolicLink(at)).toAbsolutePath();
        }
        return at;
    }

    /**
     * {@return the name of a file that lies beside another only while that is written} It contains the other's name, so that two names are one
     * on a disk that takes the others for one, as one that ignores case does. A name to which nothing can be added is stood for by its checksum.
     */
    static Path beside(Path target, String ending) throws IOException {
        String name = String.valueOf(target.getFileName());
        if (name.getBytes(StandardCharsets.UTF_8).length > LONGEST_NAME) {
            CRC32 sum = new CRC32();
            sum.update(name.toLowerCase(Locale.ROOT).getBytes(StandardCharsets.UTF_8));
            name = Long.toHexString(sum.getValue());
        }
        return target.resolveSibling(".").toRealPath().resolve(".simpleray-" + name + ending);
    }

    /**
     * Says why something cannot be done with a file.
     *
     * @param e what was thrown
     * @return the reason, without the file's name
     */
    public static String reason(IOException e) {
        if (e instanceof AccessDeniedException) {
            return "permission denied";
        }
        return !(e instanceof FileSystemException f) ? e.getMessage()
            : f.getReason() != null ? f.getReason()
            : e.getClass().getSimpleName().replace("Exception", "").replaceAll("\\B([A-Z])", " $1").toLowerCase(Locale.ROOT);
    }
}
