package simpleray.image.png;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.Map;
import java.util.zip.CRC32;
import java.util.zip.DeflaterOutputStream;
import org.assertj.core.api.ThrowableAssert.ThrowingCallable;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import simpleray.image.PictureText;

/** The texts of PNG files, good ones and hostile ones. */
class PngTextReaderTest {
    private static final byte[] PLAIN = bytes("key\0\0\0en\0translated\0hello");

    private static byte[] bytes(String text) {
        return text.getBytes(StandardCharsets.ISO_8859_1);
    }

    private static byte[] file(Object... namesAndData) throws IOException {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        DataOutputStream out = new DataOutputStream(bytes);
        out.write(PngChunks.signature());
        for (int i = 0; i < namesAndData.length; i += 2) {
            byte[] name = bytes((String) namesAndData[i]);
            byte[] data = (byte[]) namesAndData[i + 1];
            CRC32 crc = new CRC32();
            crc.update(name);
            crc.update(data);
            out.writeInt(data.length);
            out.write(name);
            out.write(data);
            out.writeInt((int) crc.getValue());
        }
        return bytes.toByteArray();
    }

    private static Map<String, byte[]> read(byte[] file) throws IOException {
        return PngTextReader.read(new PngChunks(new ByteArrayInputStream(file), "a.png").begin());
    }

    private static void assertFault(String fault, ThrowingCallable reading) {
        assertThatThrownBy(reading).isInstanceOf(PictureFormatException.class).hasMessage("a.png: " + fault);
    }

    private static byte[] packed(byte[] text) throws IOException {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        bytes.write(bytes("key\0\1\0\0\0"));
        try (DeflaterOutputStream deflater = new DeflaterOutputStream(bytes)) {
            deflater.write(text);
        }
        return bytes.toByteArray();
    }

    @Test
    void plainAndCompressedTextsAreFoundWhereverTheyStand() throws IOException {
        byte[] file = file("IHDR", new byte[13], "iTXt", PLAIN, "IDAT", new byte[100_000], "iTXt",
            bytes("other\0\0\0\0\0\u00C3\u00A4"), "tEXt", bytes("key\0no"), "IEND", new byte[0]);

        Map<String, byte[]> texts = read(file);

        assertThat(texts).containsOnlyKeys("key", "other");
        assertThat(texts.get("key")).isEqualTo(bytes("hello"));
        assertThat(new PictureText("other", texts.get("other")).string()).isEqualTo("\u00E4");
        assertThat(read(file("iTXt", packed(bytes("hello")), "IEND", new byte[0])).get("key")).isEqualTo(bytes("hello"));
    }

    @Test
    void aLongCompressedTextComesBack() throws IOException {
        byte[] text = new byte[PictureText.LONGEST];
        for (int i = 0; i < text.length; i++) {
            text[i] = (byte) (i * i >> 7);
        }

        assertThat(read(file("iTXt", packed(text), "IEND", new byte[0])).get("key")).isEqualTo(text);
    }

    @Test
    void ofTwoTextsWithOneKeywordTheFirstCounts() throws IOException {
        assertThat(read(file("iTXt", PLAIN, "iTXt", bytes("key\0\0\0\0\0bye"), "IEND", new byte[0])).get("key")).isEqualTo(bytes("hello"));
    }

    @Test
    void aBombIsNotUnpacked() {
        assertFault("carries a text that is too long: more than 4194304 bytes",
            () -> read(file("iTXt", packed(new byte[PictureText.LONGEST + 1]), "IEND", new byte[0])));
    }

    @Test
    void aChunkThatIsTooLongIsNotTaken() throws IOException {
        byte[] head = Arrays.copyOf(file("iTXt", new byte[0]), 16);
        head[8] = 0x7F;

        assertFault("has a chunk iTXt that is too long: 2130706432 bytes of at most 4195328", () -> read(head));
    }

    @ParameterizedTest
    @CsvSource({"k", "key~", "key~~", "key~~~en", "key~~~en~hallo", "key~\u0002~~~text", "key~\u0001\u0001~~text", "key~\u0001~~~text"})
    void aTextThatCannotBeReadIsAnError(String data) {
        assertFault("carries a text that cannot be read", () -> read(file("iTXt", bytes(data.replace('~', '\0')), "IEND", new byte[0])));
    }

    @ParameterizedTest
    @CsvSource({"4, 2", "4, -1", "5, 1", "5, -1"})
    void aTextCompressedInAnyOtherWayIsAnError(int at, byte flag) throws IOException {
        byte[] text = packed(bytes("hello"));
        text[at] = flag;

        assertFault("carries a text that cannot be read", () -> read(file("iTXt", text, "IEND", new byte[0])));
    }

    @Test
    void aCompressedTextThatIsCutOffIsAnError() throws IOException {
        byte[] whole = packed(bytes("hello, hello, hello"));

        assertFault("carries a text that cannot be read",
            () -> read(file("iTXt", Arrays.copyOf(whole, whole.length - 8), "IEND", new byte[0])));
    }

    @Test
    void everyFileThatIsCutOffSaysSo() throws IOException {
        byte[] file = file("IHDR", new byte[13], "iTXt", PLAIN, "IEND", new byte[0]);
        for (int n = 0; n < file.length; n++) {
            byte[] cut = Arrays.copyOf(file, n);
            assertThatThrownBy(() -> read(cut)).as("cut after " + n).isInstanceOf(PictureFormatException.class)
                .hasMessageMatching(n < 8 ? "a\\.png: is no PNG" : "a\\.png: is cut off (behind|in) .+");
        }
        assertFault("is cut off behind the chunk iTXt", () -> read(Arrays.copyOf(file, file.length - 12)));
        assertFault("is cut off in the chunk IEND", () -> read(Arrays.copyOf(file, file.length - 1)));
        assertFault("is cut off behind its signature", () -> read(Arrays.copyOf(file, 8)));
    }

    @Test
    void everyBitThatIsWrongIsFound() throws IOException {
        byte[] file = file("IHDR", new byte[13], "iTXt", PLAIN, "IEND", new byte[0]);
        for (int bit = 0; bit < 8 * file.length; bit++) {
            byte[] wrong = file.clone();
            wrong[bit / 8] ^= (byte) (1 << bit % 8);
            assertThatThrownBy(() -> read(wrong)).as("bit " + bit).isInstanceOf(PictureFormatException.class)
                .hasMessageStartingWith("a.png: ");
        }
    }

    @Test
    void aWrongSumIsToldWithItsChunk() throws IOException {
        byte[] file = file("IHDR", new byte[13], "IEND", new byte[0]);
        file[20]++;

        assertFault("is damaged in the chunk IHDR: its checksum is wrong", () -> read(file));
    }

    @Test
    void aNameThatIsNoneIsDamage() throws IOException {
        assertFault("is damaged behind its signature", () -> read(file("I\u001BHD", new byte[13])));
        assertFault("is damaged behind the chunk IHDR", () -> read(file("IHDR", new byte[13], "\u00C9END", new byte[0])));
    }
}
