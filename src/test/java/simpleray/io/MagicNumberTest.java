package simpleray.io;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.PushbackInputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.Charset;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class MagicNumberTest {
    private static final long SEED = 512;

    private static byte[] bytes(String digits) {
        byte[] bytes = new byte[digits.length() / 2];
        for (int i = 0; i < bytes.length; i++) {
            bytes[i] = (byte) Integer.parseInt(digits.substring(2 * i, 2 * i + 2), 16);
        }
        return bytes;
    }

    private static String nameOf(byte[] file) throws IOException {
        PushbackInputStream in = new PushbackInputStream(new ByteArrayInputStream(file), MagicNumber.LENGTH);
        String name = MagicNumber.nameOf(in);
        assertThat(in.readAllBytes()).as("nothing is taken").isEqualTo(file);
        return name;
    }

    @ParameterizedTest
    @CsvSource({"504B0304 1400, a ZIP file", "1F8B08, a gzip file", "425A68, a bzip2 file", "FD377A585A00, an XZ file", "377ABCAF271C, a 7z file",
        "FFD8FFE000104A46 4946, a JPEG image", "474946383961, a GIF image", "49492A0008, a TIFF image", "4D4D002A00, a TIFF image",
        "28B52FFD04, a Zstandard file", "526172211A0700, a RAR file", "89504E470D0A1A0A 0000, a PNG image",
        "52494646 24000000 57454250 5650, a WebP image", "424D 36000300 00000000 3600, a BMP image", "00000018 66747970 68656963, 'an MP4, HEIC or AVIF file'",
        "D0CF11E0A1B11AE1, an Office file", "676C5446 02000000, a glTF model", "4B6179646172612046425820 42696E617279 2020001A00, an FBX model",
        "424C454E4445522D76333030, a Blender file", "424C454E4445525F76323739, a Blender file", "CAFEBABE0000003D, a Java class file",
        "4D5A90000300, a program", "255044462D31, a PDF file", "7F454C46020101, a program", "00000000, NUL bytes", "0000000000000000 0000, NUL bytes"})
    void aKindIsToldByItsFirstBytes(String bytes, String name) throws IOException {
        assertThat(nameOf(bytes(bytes.replace(" ", "")))).isEqualTo(name);
    }

    @ParameterizedTest
    @CsvSource({"UTF-16, UTF-16", "UTF-16LE, UTF-16", "UTF-16BE, UTF-16", "X-UTF-16LE-BOM, UTF-16", "X-UTF-32LE-BOM, UTF-32", "X-UTF-32BE-BOM, UTF-32"})
    void wideTextIsTold(String charset, String name) throws IOException {
        assertThat(nameOf("2\n0 0 0".getBytes(Charset.forName(charset)))).isEqualTo(name);
    }

    @ParameterizedTest
    @ValueSource(strings = {"", "2", "2\n", "2\n1 0 1 0", "\uFEFF2\n", "# scene", "\u00E9t\u00E9", "Grafik 8", "PK 3 4", "BM 0 0 0 0 0", "RIFF WEBP", "MZ 0", "Rar! 7", "BLENDER", "glTF 2", "1 2 ftyp", "\0\0", "\0002 3 4"})
    void whatMayBeATextIsNone(String text) throws IOException {
        assertThat(nameOf(text.getBytes(StandardCharsets.UTF_8))).isNull();
    }

    @ParameterizedTest
    @CsvSource({"FEFF, true", "FFFE, true", "FFFF, false", "FE, false", "76002000, true", "00760020, true", "760020, false", "007600, false",
        "76002020, false", "76760020, false", "00762020, false", "00760000, false", "76000000, false", "00000000, false", "76762020, false"})
    void wideTextIsToldByItsFirstFourBytes(String digits, boolean wide) throws IOException {
        assertThat("UTF-16".equals(nameOf(bytes(digits)))).isEqualTo(wide);
    }

    @ParameterizedTest
    @ValueSource(strings = {"UTF-16LE", "UTF-16BE"})
    void wideTextIsToldThoughItBeginsWithALetterBeyondAscii(String charset) throws IOException {
        assertThat(nameOf("\u2116 1\n0 0 0 1 # \u041F".getBytes(Charset.forName(charset)))).isEqualTo("UTF-16");
    }

    @Test
    void aTarFileIsToldThoughItBeginsWithAName() throws IOException {
        byte[] file = Arrays.copyOf("room.scene".getBytes(StandardCharsets.UTF_8), 1024);
        System.arraycopy("ustar".getBytes(StandardCharsets.UTF_8), 0, file, 257, 5);
        assertThat(nameOf(file)).isEqualTo("a tar file");
    }

    @Test
    void randomBytesAreBinaryData() throws IOException {
        Random random = new Random(SEED);
        for (int i = 0; i < 1000; i++) {
            byte[] file = new byte[1 << 13];
            random.nextBytes(file);
            file[0] = (byte) 0x80;                            // begins no other kind
            assertThat(nameOf(file)).as("seed " + SEED + ", sample " + i).isEqualTo("binary data");
        }
    }

    @Test
    void soAreNumbersInLittleEndianOrderAfterATitle() throws IOException {
        ByteBuffer stl = ByteBuffer.allocate(184).order(ByteOrder.LITTLE_ENDIAN);
        stl.put("solid".getBytes(StandardCharsets.UTF_8)).position(80);
        stl.putInt(2);
        stl.putFloat(0.1F).putFloat(-1);
        assertThat(nameOf(stl.array())).isEqualTo("binary data");
    }

    @ParameterizedTest
    @ValueSource(strings = {"windows-1252", "KOI8-R", "GBK", "Shift_JIS"})
    void aCommentInAnOldEncodingMayBeInAText(String charset) throws IOException {
        assertThat(nameOf("# \u00e9\u00e8 \u0441\u0446\u0435\u043d\u0430 \u573a\u666f \u30b7\u30fc\u30f3".repeat(30).getBytes(Charset.forName(charset))))
            .isNull();
    }

    @Test
    void aFewControlCharactersMayBeInAText() throws IOException {
        assertThat(nameOf("2\0 \1 \2 \3 \4 \5 \6".getBytes(StandardCharsets.UTF_8))).isNull();
        assertThat(nameOf(("2 \0\0\0\0\0\0\0" + " ".repeat(250)).getBytes(StandardCharsets.UTF_8))).isNull();
        assertThat(nameOf(("\0".repeat(3) + " ".repeat(497) + "\0".repeat(12)).getBytes(StandardCharsets.UTF_8))).isNull();
        assertThat(nameOf("\u001B[1m# \b \f \u000B".repeat(20).getBytes(StandardCharsets.UTF_8))).isNull();
    }

    @Test
    void aPipeIsNotReadFurtherThanItMustBe() throws IOException {
        InputStream slow = new ByteArrayInputStream("# a scene of one sphere\n".getBytes(StandardCharsets.UTF_8)) {
            @Override
            public synchronized int read(byte[] b, int off, int len) {
                assertThat(available()).as("it would wait here").isPositive();
                return super.read(b, off, Math.min(len, 12));
            }
        };
        assertThat(MagicNumber.nameOf(new PushbackInputStream(slow, MagicNumber.LENGTH))).isNull();
    }

    private static String marked(int length, String... marks) throws IOException {
        return nameOf(("ab" + String.join("", marks) + " ".repeat(length)).substring(0, length).getBytes(StandardCharsets.UTF_8));
    }

    @Test
    void aTextHasFewControlCharacters() throws IOException {
        assertThat(marked(100, "\u0001".repeat(7))).isNull();
        assertThat(marked(100, "\u0001".repeat(8))).isEqualTo("binary data");
        assertThat(marked(512, "\u0001".repeat(15))).isNull();
        assertThat(marked(512, "\u0001".repeat(16))).isEqualTo("binary data");
        for (String harmless : List.of("\b", "\t", "\n", "\u000B", "\f", "\r", "\u001B", " ", "~")) {
            assertThat(marked(100, harmless.repeat(20))).isNull();
        }
        for (String control : List.of("\u0007", "\u000E", "\u001A", "\u007F")) {
            assertThat(marked(100, control.repeat(8))).isEqualTo("binary data");
        }
    }

    @Test
    void nulsInEachSecondPlaceAreUtf16IfTheyAreHalfOfTheControlCharacters() throws IOException {
        assertThat(marked(100, "\0c\0d\0e\0f", "\u0001".repeat(4))).isEqualTo("UTF-16");
        assertThat(marked(100, "\0c\0d\0e\0f", "\u0001".repeat(5))).isEqualTo("binary data");
        assertThat(marked(100, "\0\0cd\0e\0f", "\u0001".repeat(4))).isEqualTo("binary data");
    }
}
