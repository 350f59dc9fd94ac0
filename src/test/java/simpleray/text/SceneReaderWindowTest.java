package simpleray.text;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.catchThrowableOfType;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.SequenceInputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.Set;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Files longer than the piece of them that is kept in memory: no place, word or line is another for where that piece ends. */
class SceneReaderWindowTest {
    private static final int SIZE = 4096;
    private static final String SMILE = "\uD83D\uDE00";

    /** The file is kept in pieces of 4096 bytes, of which 2048 or less stay: a border every 2048 to 4096 bytes. */
    @Test
    void aBadWordIsFoundAtEveryPlace() throws IOException {
        String line = "1 22 \u00e9*" + SMILE + " 4.5";
        for (int before = 0; before < SIZE + 64; before++) {
            SceneReader is = open("#" + "x".repeat(before) + "\n" + line + "\n6");
            is.tolerate(2);
            assertThat(is.readInt()).isEqualTo(1);
            assertThat(is.readDouble()).isEqualTo(22);
            assertThat(is.readDouble()).isNaN();
            assertThat(is.readDouble()).isEqualTo(4.5);
            assertThat(is.readInt()).isEqualTo(6);
            assertThatThrownBy(() -> is.complete("")).hasMessage(
                "f:2:6: error: expected a number, found '\u00e9*" + SMILE + "'\n" + line + "\n     ^");
        }
    }

    @Test
    void aLongLineIsCountedAndShownAboutTheBadWordAtEveryPlace() {
        for (int before = 3 * SIZE - 64; before < 3 * SIZE + 64; before++) {
            String pad = SMILE + "\u00e9 ".repeat(before / 2) + " ".repeat(before % 2);
            // the pad is one bad word after another, and so a comment of the line before; only blanks may stand in front
            SceneReader is = open(" ".repeat(before) + "7\t\u20AC 8 #" + pad);
            int column = before + 3;
            assertThatThrownBy(() -> {
                is.readInt();
                is.readInt();
            }).hasMessageStartingWith("f:1:" + column + ": error: expected an integer, found '\u20AC'\n..." + " ".repeat(78)
                + "7\t\u20AC 8 #" + SMILE + "\u00e9 \u00e9").hasMessageEndingWith("...\n" + " ".repeat(82) + "\t^");
        }
    }

    @Test
    void aBadWordFarIntoItsLineIsCountedInCharacters() throws IOException {
        int many = 300;
        SceneReader is = open((SMILE + ' ').repeat(many) + "*");
        is.tolerate(many + 1);
        for (int i = 0; i < many; i++) {
            assertThat(is.readDouble()).isNaN();
        }
        SceneFormatException e = catchThrowableOfType(SceneFormatException.class, is::readDouble);

        for (int i = 0; i <= many; i++) {
            assertThat(e.problems().get(i).column()).isEqualTo(2 * i + 1);
        }
    }

    @Tag("slow")
    @Test
    void aBadWordAfterManyOthersOfItsLineIsCountedInCharacters() throws IOException {
        int many = 5000;
        SceneReader is = open((SMILE + ' ').repeat(many) + "* 1");
        is.tolerate(many + 1);
        for (int i = 0; i < many; i++) {
            assertThat(is.readDouble()).isNaN();
        }
        SceneFormatException e = catchThrowableOfType(SceneFormatException.class, is::readDouble);

        for (int i = 0; i <= many; i++) {
            assertThat(e.problems().get(i).column()).isEqualTo(2 * i + 1);
        }
        assertThat(e.problems().get(many)).hasToString("f:1:10001: error: expected a number, found '*'\n..."
            + (SMILE + ' ').repeat(26) + SMILE + " * 1\n" + " ".repeat(3 + 2 * 26 + 2) + "^");
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 2, 3, 7, 4096})
    void howTheBytesComeMakesNoDifference(int atOnce) throws IOException {
        String text = "\uFEFF1\r\n\r\n2 # \u00e9\r3\u20034\u00A0\"a b\"\nheading " + SMILE + "\n5e0 \u7269\r\n";
        byte[] bytes = text.getBytes(StandardCharsets.UTF_8);
        SceneReader is = new SceneReader(new ByteArrayInputStream(bytes) {
            @Override
            public synchronized int read(byte[] b, int off, int len) {
                return super.read(b, off, Math.min(len, atOnce));
            }
        }, "f", Path.of(""), SIZE);

        assertThat(is.readDouble()).isEqualTo(1);
        assertThat(is.readInt()).isEqualTo(2);
        assertThat(is.readInt()).isEqualTo(3);
        assertThat(is.readDouble()).isEqualTo(4);
        assertThat(is.readQuoted("")).isEqualTo("a b");
        assertThat(is.readDouble()).isEqualTo(5);
        assertThat(is.warnings()).singleElement().extracting(Diagnostic::headline)
            .isEqualTo("f:5:1: warning: expected a value or a comment, found the heading 'heading " + SMILE + "', which is skipped");
        assertThatThrownBy(is::readDouble).hasMessage("f:6:5: error: expected a number, found '\u7269'\n5e0 \u7269\n    ^");
    }

    @Test
    void aStreamMayGiveNothingAtTimes() throws IOException {
        SceneReader is = new SceneReader(new ByteArrayInputStream("1 2\n3".getBytes(StandardCharsets.UTF_8)) {
            private int asked;

            @Override
            public synchronized int read(byte[] b, int off, int len) {
                return ++asked % 3 == 0 ? super.read(b, off, 1) : 0;
            }
        }, "f", Path.of(""), SIZE);

        assertThat(is.readInt()).isEqualTo(1);
        assertThat(is.readInt()).isEqualTo(2);
        assertThat(is.readInt()).isEqualTo(3);
        assertThat(is.eof()).isTrue();
    }

    @Test
    void bytesThatAreNoUtf8AreOneReplacementCharacterOrMore() {
        byte[] bytes = {'1', ' ', (byte) 0xE2, (byte) 0x80, ' ', (byte) 0xFF, (byte) 0xC2, (byte) 0xA0, '*'};
        SceneReader is = new SceneReader(new ByteArrayInputStream(bytes), "f", Path.of(""));

        assertThatThrownBy(() -> {
            is.tolerate(3);
            for (int i = 0; i < 4; i++) {
                is.readDouble();
            }
        }).hasMessageContaining("f:1:3: error: expected a number, found '\uFFFD' (not UTF-8)\n")
            .hasMessageContaining("f:1:5: error: expected a number, found '\uFFFD' (not UTF-8)\n")
            .hasMessageContaining("f:1:7: error: expected a number, found '*'\n");
    }

    @Test
    void aNumberMayBeLongerThanWhatIsKept() throws IOException {
        String zeros = "0".repeat(3 * SIZE);
        SceneReader is = open("0." + zeros + "25e" + (3 * SIZE) + " -" + zeros + "7 " + "9".repeat(SIZE) + "x 1");

        assertThat(is.readDouble()).isEqualTo(0.25);
        assertThat(is.readInt()).isEqualTo(-7);
        is.tolerate(2);
        assertThat(is.readDouble()).isNaN();
        assertThat(is.readInt()).isEqualTo(1);
        assertThatThrownBy(() -> is.complete("")).hasMessageStartingWith("f:1:" + (2 + 3 * SIZE + 2 + 1 + 5 + 2 + 1 + 3 * SIZE + 2)
            + ": error: expected a number, found '" + "9".repeat(60) + "...' (beyond 1.8e308, the largest number)\n...");
    }

    @Test
    void evenAtTheEndOfTheFile() throws IOException {
        for (int zeros = 2 * SIZE - 4; zeros < 2 * SIZE + 4; zeros++) {
            SceneReader is = open("0".repeat(zeros) + "7");
            assertThat(is.readInt()).isEqualTo(7);
            assertThat(is.eof()).isTrue();
        }
    }

    @Test
    void aNameInQuotesMayBeLongerThanWhatMostFilesNeed() throws IOException {
        String name = "x ".repeat(30_000);

        assertThat(SceneText.reader("\"" + name + "\" 1").readQuoted("name")).isEqualTo(name);
    }

    @Test
    void anEvenLongerOneMayNot() {
        assertThatThrownBy(() -> open("\"" + "x ".repeat(SIZE) + '"').readQuoted("name"))
            .hasMessageStartingWith("f:1:1: error: expected name between double quotes, found '\"x'\n");
        assertThatThrownBy(() -> open("\"" + "x".repeat(2 * SIZE) + '"').readQuoted("name"))
            .hasMessageStartingWith("f:1:1: error: expected name between double quotes, found '\"" + "x".repeat(59) + "...'\n");
    }

    @Test
    void aGroupIsRejectedWhereItBeganHoweverLongAgo() throws IOException {
        SceneReader one = open(" 1 2" + " ".repeat(3 * SIZE) + "3 # end");
        one.group();
        one.readInt();
        one.readInt();
        one.readInt();
        assertThatThrownBy(() -> one.rejectGroup("more")).hasMessage("f:1:2: error: expected more, found '1 2" + " ".repeat(57) + "...'\n"
            + " 1 2" + " ".repeat(156) + "...\n ^");

        SceneReader two = open(" 12 2" + "\n".repeat(3 * SIZE) + "3 # end");
        two.group();
        two.readInt();
        two.readInt();
        two.readInt();
        assertThatThrownBy(() -> two.rejectGroup("more")).hasMessage("f:1:2: error: expected more, found '12'\n 12 2\n ^");
    }

    @Test
    void aValueIsRejectedWhereItWasThoughMuchWasPassedOverSince() throws IOException {
        SceneReader is = open("1 23 # x\n" + "# y\n".repeat(SIZE) + "4");
        is.readInt();
        is.readInt();
        assertThat(is.takeKeyword(Set.of("transmit"))).isNull();

        assertThatThrownBy(() -> is.reject("less")).hasMessage("f:1:3: error: expected less, found '23'\n1 23 # x\n  ^");
    }

    @Test
    void aLongHeadingIsSkippedWhole() throws IOException {
        SceneReader is = open("Call" + " me".repeat(2 * SIZE) + "\nIshmael" + " ".repeat(2 * SIZE) + "\n1");

        assertThat(is.readInt()).isEqualTo(1);
        assertThat(is.warnings()).extracting(Diagnostic::message).containsExactly(
            "expected a value or a comment, found the heading 'Call" + " me".repeat(18) + " m...', which is skipped",
            "expected a value or a comment, found the heading 'Ishmael', which is skipped");
    }

    @Test
    void charactersOfTwoCharsComeInHalves() throws IOException {
        SceneReader is = open(SMILE + "\u00e9x" + SMILE + " 1");

        assertThat("" + is.readChar() + is.readChar() + is.readChar() + is.readChar() + is.readChar() + is.readChar())
            .isEqualTo(SMILE + "\u00e9x" + SMILE);
        assertThat(is.readInt()).isEqualTo(1);
    }

    @Test
    void anErrorComesBeforeTheFaultOfTheStreamBehindIt() throws IOException {
        InputStream broken = new InputStream() {
            @Override
            public int read() throws IOException {
                throw new IOException("the disk is gone");
            }
        };
        InputStream start = new ByteArrayInputStream("1 * 2 ".getBytes(StandardCharsets.UTF_8));
        SceneReader is = new SceneReader(new SequenceInputStream(start, broken), "f", Path.of(""), SIZE);
        is.readInt();
        is.tolerate(2);

        assertThat(is.readDouble()).isNaN();
        assertThat(is.readInt()).isEqualTo(2);
        assertThatThrownBy(is::eof).isExactlyInstanceOf(IOException.class).hasMessage("the disk is gone");
        assertThatThrownBy(is::eof).hasMessage("the disk is gone");
    }

    @Test
    void whatWasReadBeforeTheFaultIsNotReadTwice() throws IOException {
        InputStream start = new ByteArrayInputStream(("#" + "9".repeat(3000) + "\n* 2 ").getBytes(StandardCharsets.UTF_8));
        InputStream broken = new InputStream() {
            @Override
            public int read() throws IOException {
                throw new IOException("the disk is gone");
            }
        };
        SceneReader is = new SceneReader(new SequenceInputStream(start, broken), "f", Path.of(""), SIZE);
        is.tolerate(2);

        assertThat(is.readDouble()).isNaN();
        assertThat(is.readInt()).isEqualTo(2);
        assertThatThrownBy(is::eof).isExactlyInstanceOf(IOException.class).hasMessage("the disk is gone");
    }

    private static SceneReader open(String text) {
        return new SceneReader(new ByteArrayInputStream(text.getBytes(StandardCharsets.UTF_8)), "f", Path.of(""), SIZE);
    }
}
