package simpleray.text;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;

/**
 * A part of a scene file, given by the offsets of its bytes, so that a word of a file can be changed and all else kept.
 * <em>Constant.</em>
 *
 * @param start the first byte's offset; a byte order mark counts
 * @param end the offset after the last byte
 */
public record SourceSpan(long start, long end) {
    private static final int BUFFER = 1 << 16;

    /**
     * Creates a reader of a scene file whose bytes are in memory.
     *
     * @param bytes the file's bytes
     * @param path the file, which messages name; files that the scene names are in its folder
     * @return a reader of the bytes
     */
    public static SceneReader reader(byte[] bytes, Path path) {
        return new SceneReader(new ByteArrayInputStream(bytes), path.toString(), path.resolveSibling(""), BUFFER);
    }

    /**
     * Returns the part of the file that is the value just read.
     *
     * @param is the reader, which has read a value
     * @return where the value is in the file
     */
    public static SourceSpan last(SceneReader is) {
        return is.tokenizer.lastSpan();
    }

    /**
     * Finds the words of this part. Comments and headings are none.
     *
     * @param bytes the file's bytes
     * @return the parts that are words, one after another
     * @throws IOException never
     */
    public List<SourceSpan> words(byte[] bytes) throws IOException {
        Tokenizer tokenizer = new Tokenizer(new ByteArrayInputStream(bytes, (int) start, (int) (end - start)), BUFFER, new Diagnostics(""));
        List<SourceSpan> found = new ArrayList<>();
        while (tokenizer.skip(Set.of())) {
            tokenizer.take(false);
            SourceSpan word = tokenizer.lastSpan();
            found.add(new SourceSpan(start + word.start, start + word.end));
        }
        return found;
    }
}
