package simpleray.image.png;

import java.io.BufferedInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.nio.ByteBuffer;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;

/**
 * Joins PNG files of one size and kind into an animated one, which is shown for ever (Vukicevic and Parmenter, "APNG Specification", 2004; W3C,
 * "Portable Network Graphics Specification", third edition, 2025). The pixels are taken as they are compressed. The first file's texts come along,
 * and programs that know no APNG show its picture.
 */
public final class ApngWriter {
    private static final String DATA = "IDAT";

    private final OutputStream out;
    private final int numerator;
    private final int denominator;
    private int sequence;
    private int width;
    private int height;

    private ApngWriter(OutputStream out, int numerator, int denominator) {
        this.out = out;
        this.numerator = numerator;
        this.denominator = denominator;
    }

    /**
     * Writes a film. The stream is flushed and stays open.
     *
     * @param frames the frames' pictures
     * @param numerator a frame is shown for so many seconds divided by the denominator, 1 to 65535
     * @param denominator 1 to 65535
     * @param out where to write to
     * @throws PictureFormatException if a picture is damaged
     * @throws IOException if a picture cannot be read, or the film not be written
     */
    public static void write(List<Path> frames, int numerator, int denominator, OutputStream out) throws IOException {
        ApngWriter writer = new ApngWriter(out, numerator, denominator);
        out.write(PngChunks.signature());
        for (int i = 0; i < frames.size(); i++) {
            try (InputStream in = new BufferedInputStream(Files.newInputStream(frames.get(i)))) {
                writer.frame(new PngChunks(in, frames.get(i).toString()).begin(), i == 0, frames.size());
            }
        }
        PngChunk.end().writeTo(out);
        out.flush();
    }

    private void frame(PngChunks chunks, boolean first, int frames) throws IOException {
        boolean begun = false;
        for (String name = chunks.next(); name != null; name = chunks.next()) {
            byte[] data = chunks.rest(Integer.MAX_VALUE);
            if (!name.equals(DATA)) {
                if (first && !begun) {
                    head(name, data);
                }
                continue;
            }
            if (!begun) {
                begun = true;
                if (first) {
                    PngChunk control = new PngChunk("acTL", 2 * Integer.BYTES);
                    control.putInt(frames);
                    control.putInt(0);                        // for ever
                    control.finished().writeTo(out);
                }
                control();
            }
            PngChunk copy = new PngChunk(first ? DATA : "fdAT", Integer.BYTES + data.length);
            if (!first) {
                copy.putInt(sequence++);
            }
            copy.put(data);
            copy.finished().writeTo(out);
        }
    }

    private void head(String name, byte[] data) throws IOException {
        if (name.equals("IHDR")) {
            width = ByteBuffer.wrap(data).getInt();
            height = ByteBuffer.wrap(data).getInt(Integer.BYTES);
        }
        PngChunk copy = new PngChunk(name, data.length + 1);
        copy.put(data);
        copy.finished().writeTo(out);
    }

    /** Writes what says how a frame is shown: whole, in place of the one before. */
    private void control() throws IOException {
        PngChunk control = new PngChunk("fcTL", 26);
        control.putInt(sequence++);
        control.putInt(width);
        control.putInt(height);
        control.putInt(0);                                    // from the left, and from the top
        control.putInt(0);
        control.put(numerator >>> 8, numerator, denominator >>> 8, denominator);
        control.put(0, 0);                                    // stays until the next one, and covers it
        control.finished().writeTo(out);
    }
}
