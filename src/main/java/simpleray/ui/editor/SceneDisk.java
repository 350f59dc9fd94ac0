package simpleray.ui.editor;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.PushbackInputStream;
import java.nio.charset.CharacterCodingException;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.concurrent.Executor;
import java.util.function.Consumer;
import javax.swing.SwingUtilities;
import simpleray.image.png.PngChunks;
import simpleray.io.AtomicFile;
import simpleray.io.MagicNumber;
import simpleray.ui.file.SceneSource;

/** Reads and writes a scene's text on a thread of the window's, and answers on the event thread. */
final class SceneDisk {
    /** The largest file that is edited; beyond, typing would be slow. */
    static final long MAX = 8L << 20;
    private static final double MEBI = 1 << 20;

    private final Executor worker;

    /**
     * The result of reading or writing. <em>Constant.</em>
     *
     * @param bytes the bytes of the file now; null if there is no file or it was not read
     * @param failure why it could not be read or written; null if it was
     * @param other whether nothing was written, because the file holds other bytes than expected
     * @param note how it was written if not as files usually are, to be added to a message; mostly empty
     */
    record Answer(byte[] bytes, String failure, boolean other, String note) {
        Answer(byte[] bytes, String failure, boolean other) {
            this(bytes, failure, other, "");
        }
    }

    SceneDisk(Executor worker) {
        this.worker = worker;
    }

    /** Reads a scene's text. A file that is not there is no failure. */
    void read(SceneSource source, Consumer<Answer> then) {
        worker.execute(() -> {
            Answer answer;
            try {
                Path path = source.path();
                long size = path == null || !Files.exists(path) ? 0 : Files.size(path);
                byte[] text = size <= MAX ? source.text() : null;
                answer = size > MAX ? new Answer(null,
                    String.format("%s is too large to be edited here: %.0f MiB", path.getFileName(), size / MEBI), false)
                    : isPicture(text) ? new Answer(null, source.name() + " is a picture: simpleray convert makes a file of its scene", false)
                    : new Answer(text, null, false);
            } catch (NoSuchFileException e) {
                answer = new Answer(null, null, false);
            } catch (IOException e) {
                answer = new Answer(null, "The text cannot be read: " + reason(e), false);
            }
            tell(then, answer);
        });
    }

    /**
     * Writes a text, if the file is as it was before or is gone, or whatever it holds.
     *
     * @param path the file
     * @param whatever whether it may hold anything
     * @param before its bytes before; null if there was no file
     * @param maker makes the bytes
     * @param wrote called on the thread that writes, at once when the file is written
     * @param then called with the result
     */
    void write(Path path, boolean whatever, byte[] before, Maker maker, Runnable wrote, Consumer<Answer> then) {
        worker.execute(() -> {
            Answer answer;
            try {
                byte[] bytes = maker.make();
                if (bytes.length == 0) {
                    throw new FileSystemException(path.toString(), null, "there is no text to write");
                }
                byte[] now = !whatever && Files.isRegularFile(path) ? Files.readAllBytes(path) : null;
                if (now != null && !Arrays.equals(now, before) && !Arrays.equals(now, bytes)) {
                    answer = new Answer(now, null, true);
                } else {
                    StringBuilder note = new StringBuilder();
                    try (AtomicFile file = new AtomicFile(path, line -> note.append(": ").append(line))) {
                        file.out().write(bytes);
                        file.commit();
                    }
                    wrote.run();
                    answer = new Answer(bytes, null, false, note.toString());
                }
            } catch (CharacterCodingException e) {
                answer = new Answer(null, "it is not UTF-8 but ISO 8859-1, which has no such characters as were typed", false);
            } catch (IOException e) {
                answer = new Answer(null, reason(e), false);
            }
            tell(then, answer);
        });
    }

    /** Makes a file's bytes. */
    interface Maker {
        byte[] make() throws IOException;
    }

    private static boolean isPicture(byte[] text) throws IOException {
        return text != null && PngChunks.begin(new PushbackInputStream(new ByteArrayInputStream(text), MagicNumber.LENGTH));
    }

    private static String reason(IOException e) {
        return e instanceof FileSystemException f && f.getReason() != null ? f.getReason() : e.toString();
    }

    private static void tell(Consumer<Answer> then, Answer answer) {
        SwingUtilities.invokeLater(() -> then.accept(answer));
    }
}
