package simpleray.image.png;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.PushbackInputStream;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.zip.CRC32;
import org.junit.jupiter.api.Test;

/** Chunks that are read in pieces. */
class PngChunksTest {
    private static final byte[] DATA = "13 bytes long".getBytes(StandardCharsets.US_ASCII);

    @Test
    void howMuchOfAChunkIsLeftIsKnown() throws IOException {
        PngChunks chunks = open(DATA.length);
        byte[] some = new byte[DATA.length];

        assertThat(chunks.next()).isEqualTo("tEST");
        assertThat(chunks.read(some, 0, 5)).isEqualTo(5);
        assertThat(chunks.rest(8)).isEqualTo(Arrays.copyOfRange(DATA, 5, 13));
        assertThat(chunks.read(some, 0, 5)).isEqualTo(-1);
        assertThat(some).startsWith(Arrays.copyOf(DATA, 5));
        assertThat(chunks.next()).isEqualTo("IEND");
    }

    @Test
    void howTheBytesComeMakesNoDifference() throws IOException {
        for (int atOnce = 1; atOnce <= DATA.length; atOnce++) {
            PngChunks chunks = open(atOnce);
            chunks.next();
            assertThat(chunks.rest(1000)).as("by " + atOnce).isEqualTo(DATA);
        }
    }

    @Test
    void noMoreOfAChunkIsTakenThanIsWanted() throws IOException {
        PngChunks chunks = open(DATA.length);
        chunks.next();

        assertThatThrownBy(() -> chunks.rest(12)).hasMessage("a.png: has a chunk tEST that is too long: 13 bytes of at most 12");
    }

    @Test
    void behindTheLastChunkIsNoneHoweverOftenOneAsks() throws IOException {
        PngChunks chunks = open(DATA.length);
        assertThat(chunks.next()).isEqualTo("tEST");
        assertThat(chunks.next()).isEqualTo("IEND");

        assertThat(chunks.next()).isNull();
        assertThat(chunks.next()).isNull();
    }

    @Test
    void aPngIsKnownByItsFirstEightBytes() throws IOException {
        byte[] png = PngChunks.signature();
        assertThat(PngChunks.begin(file(png))).isTrue();
        for (int n = 0; n < png.length; n++) {
            assertThat(PngChunks.begin(file(Arrays.copyOf(png, n)))).as("cut after " + n).isFalse();
            byte[] other = png.clone();
            other[n]++;
            PushbackInputStream in = file(other);
            assertThat(PngChunks.begin(in)).as("other at " + n).isFalse();
            assertThat(in.readAllBytes()).as("nothing is lost").isEqualTo(other);
        }
    }

    @Test
    void behindTheSignatureOfAPngIsItsFirstChunk() throws IOException {
        byte[] bytes = Arrays.copyOf(PngChunks.signature(), 10);
        bytes[8] = 42;
        PushbackInputStream in = file(bytes);

        assertThat(PngChunks.begin(in)).isTrue();
        assertThat(in.readAllBytes()).containsExactly(42, 0);
    }

    /** Who types a scene must not have to type eight characters before the first is looked at. */
    @Test
    void ofATextNoMoreThanOneByteIsWaitedFor() throws IOException {
        InputStream in = new ByteArrayInputStream("2 # objects".getBytes(StandardCharsets.UTF_8));

        assertThat(PngChunks.begin(new PushbackInputStream(in, 8))).isFalse();
        assertThat(in.available()).isEqualTo("2 # objects".length() - 1);
    }

    @Test
    void aFileIsReadToTheEndOfItsLastChunkAndNoFarther() throws IOException {
        byte[] png = small();
        byte[] longer = Arrays.copyOf(png, png.length + 3);
        ByteArrayInputStream in = new ByteArrayInputStream(longer);

        assertThat(PngChunks.readFile(in)).isEqualTo(png);
        assertThat(in.available()).isEqualTo(3);
    }

    @Test
    void ofAFileThatBreaksOffAllIsRead() throws IOException {
        byte[] png = small();
        for (int length = 0; length <= png.length; length++) {
            byte[] cut = Arrays.copyOf(png, length);
            assertThat(PngChunks.readFile(new ByteArrayInputStream(cut))).as("%d bytes", length).isEqualTo(cut);
        }
    }

    @Test
    void ofAnotherFileEightBytesAreRead() throws IOException {
        ByteArrayInputStream in = new ByteArrayInputStream("no picture at all".getBytes(StandardCharsets.US_ASCII));

        assertThat(PngChunks.readFile(in)).asString(StandardCharsets.US_ASCII).isEqualTo("no pictu");
        assertThat(in.available()).isEqualTo(9);
    }

    private static byte[] small() throws IOException {
        ByteArrayOutputStream file = new ByteArrayOutputStream();
        file.write(PngChunks.signature());
        write(file, "IHDR", DATA);
        write(file, "tEXt", new byte[0]);
        write(file, "IEND", new byte[0]);
        return file.toByteArray();
    }

    private static PushbackInputStream file(byte[] bytes) {
        return new PushbackInputStream(new ByteArrayInputStream(bytes), 8);
    }

    private static PngChunks open(int atOnce) throws IOException {
        ByteArrayOutputStream file = new ByteArrayOutputStream();
        file.write(PngChunks.signature());
        write(file, "tEST", DATA);
        write(file, "IEND", new byte[0]);
        return new PngChunks(new ByteArrayInputStream(file.toByteArray()) {
            @Override
            public synchronized int read(byte[] b, int off, int len) {
                return super.read(b, off, Math.min(len, atOnce));
            }
        }, "a.png").begin();
    }

    private static void write(ByteArrayOutputStream file, String name, byte[] data) throws IOException {
        byte[] named = (name + new String(data, StandardCharsets.US_ASCII)).getBytes(StandardCharsets.US_ASCII);
        CRC32 sum = new CRC32();
        sum.update(named);
        file.write(ByteBuffer.allocate(Integer.BYTES).putInt(data.length).array());
        file.write(named);
        file.write(ByteBuffer.allocate(Integer.BYTES).putInt((int) sum.getValue()).array());
    }
}
