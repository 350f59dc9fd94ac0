package simpleray.io;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.PushbackInputStream;
import java.nio.charset.Charset;
import java.nio.charset.StandardCharsets;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class MagicNumberTest {
    private static String nameOf(byte[] file) throws IOException {
        PushbackInputStream in = new PushbackInputStream(new ByteArrayInputStream(file), MagicNumber.LENGTH);
        String name = MagicNumber.nameOf(in);
        assertThat(in.readAllBytes()).as("nothing is taken").isEqualTo(file);
        return name;
    }

    @ParameterizedTest
    @CsvSource({"504B0304 1400, a ZIP file", "1F8B08, a gzip file", "425A68, a bzip2 file", "FD377A585A00, an XZ file", "377ABCAF271C, a 7z file",
        "FFD8FFE000104A46 4946, a JPEG image", "474946383961, a GIF image", "49492A0008, a TIFF image", "4D4D002A00, a TIFF image",
        "255044462D31, a PDF file", "7F454C46020101, a program", "00000000, NUL bytes", "0000000000000000 0000, NUL bytes"})
    void aKindIsToldByItsFirstBytes(String bytes, String name) throws IOException {
        String digits = bytes.replace(" ", "");
        byte[] file = new byte[digits.length() / 2];
        for (int i = 0; i < file.length; i++) {
            file[i] = (byte) Integer.parseInt(digits.substring(2 * i, 2 * i + 2), 16);
        }

        assertThat(nameOf(file)).isEqualTo(name);
    }

    @ParameterizedTest
    @CsvSource({"UTF-16, UTF-16", "UTF-16LE, UTF-16", "UTF-16BE, UTF-16", "X-UTF-16LE-BOM, UTF-16", "X-UTF-32LE-BOM, UTF-32", "X-UTF-32BE-BOM, UTF-32"})
    void wideTextIsTold(String charset, String name) throws IOException {
        assertThat(nameOf("2\n0 0 0".getBytes(Charset.forName(charset)))).isEqualTo(name);
    }

    @ParameterizedTest
    @ValueSource(strings = {"", "2", "2\n", "2\n1 0 1 0", "\uFEFF2\n", "# scene", "\u00E9t\u00E9", "Grafik 8", "PK 3 4", "\0\0", "\0002 3 4"})
    void whatMayBeATextIsNone(String text) throws IOException {
        assertThat(nameOf(text.getBytes(StandardCharsets.UTF_8))).isNull();
    }

    /** The bytes before the text are a letter, those behind it are zeros. */
    @ParameterizedTest
    @CsvSource({"FEFF, true", "FFFE, true", "FFFF, false", "FE, false", "76002000, true", "00760020, true", "760020, false", "007600, false",
        "76002020, false", "76760020, false", "00762020, false", "00760000, false", "76000000, false", "00000000, false", "76762020, false"})
    void wideTextIsToldByItsFirstFourBytes(String digits, boolean wide) {
        byte[] bytes = new byte[9];
        bytes[0] = 'v';
        int length = digits.length() / 2;
        for (int i = 0; i < length; i++) {
            bytes[1 + i] = (byte) Integer.parseInt(digits.substring(2 * i, 2 * i + 2), 16);
        }

        assertThat(MagicNumber.isUtf16(bytes, 1, 1 + length)).isEqualTo(wide);
    }
}
