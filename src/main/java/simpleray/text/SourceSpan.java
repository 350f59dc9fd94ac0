package simpleray.text;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;

/**
 * A piece of a scene file, by the offsets of its bytes: for those who change a word of a file and leave all else as it is.
 * <em>Constant.</em>
 *
 * @param start the first byte's offset; a byte order mark counts
 * @param end the offset behind the last byte
 */
public record SourceSpan(long start, long end) {
    private static final int BUFFER = 1 << 16;

    /**
     * Reads a scene file whose bytes are in memory.
     *
     * @param bytes the file's bytes
     * @param path the file, which messages name, and in whose folder lies what the scene names
     * @return a reader of the bytes
     */
    public static SceneReader reader(byte[] bytes, Path path) {
        return new SceneReader(new ByteArrayInputStream(bytes), path.toString(), path.resolveSibling(""), BUFFER);
    }

    /**
     * Finds the value that a reader has just read.
     *
     * @param is the reader, which has read one
     * @return the piece of the file where it stands
     */
    public static SourceSpan last(SceneReader is) {
        return is.words.lastSpan();
    }

    /**
     * Finds the words of this piece. Comments and headings are none.
     *
     * @param bytes the file's bytes
     * @return the words' own pieces, one after another
     * @throws IOException never
     */
    public List<SourceSpan> words(byte[] bytes) throws IOException {
        Tokenizer words = new Tokenizer(new ByteArrayInputStream(bytes, (int) start, (int) (end - start)), BUFFER, new Diagnostics(""));
        List<SourceSpan> found = new ArrayList<>();
        while (words.skip(Set.of())) {
            words.take();
            SourceSpan word = words.lastSpan();
            found.add(new SourceSpan(start + word.start, start + word.end));
        }
        return found;
    }
}
