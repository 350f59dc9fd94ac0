package simpleray.image.png;

import java.io.BufferedInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import simpleray.image.PictureText;

/** What is in the place of a picture that may have been written by an earlier run. */
public enum KeptPicture {
    /** Nothing. */
    NONE,
    /** The picture, whole: it carries all texts that it is to carry, and no others, and each chunk has the right checksum. */
    WHOLE,
    /** The beginning of the picture, or a damaged one. */
    BROKEN,
    /** Another picture, or no picture. */
    OTHER;

    private static final int LENGTH = PngChunks.signature().length;

    /**
     * Looks for a picture that {@link PngWriter} has written.
     *
     * @param file the place
     * @param texts the texts that the picture is to carry, which say all that it was made of
     * @return what there is
     * @throws IOException if it cannot be read
     */
    public static KeptPicture find(Path file, List<PictureText> texts) throws IOException {
        if (!Files.exists(file)) {
            return NONE;
        }
        if (!Files.isRegularFile(file)) {
            return OTHER;
        }
        try (InputStream in = new BufferedInputStream(Files.newInputStream(file))) {
            byte[] head = in.readNBytes(LENGTH);
            if (!Arrays.equals(head, Arrays.copyOf(PngChunks.signature(), head.length))) {
                return OTHER;
            }
            return head.length < LENGTH ? BROKEN : find(in, file, texts);
        }
    }

    private static KeptPicture find(InputStream in, Path file, List<PictureText> texts) throws IOException {
        PngChunks chunks = new PngChunks(in, file.toString());
        int next = 0;
        try {
            for (String name = chunks.next(); name != null; name = chunks.next()) {
                if (name.equals(PngChunks.TEXT)) {
                    byte[] data = chunks.rest(Integer.MAX_VALUE);
                    if (next == texts.size() || !Arrays.equals(data, PngChunk.of(texts.get(next)).data())) {
                        return OTHER;
                    }
                    next++;
                } else if (name.equals("IDAT") && next < texts.size()) {
                    return OTHER;                             // its texts would stand before
                }
            }
        } catch (PictureFormatException e) {
            return BROKEN;
        }
        return in.read() < 0 ? WHOLE : BROKEN;
    }
}
