package simpleray.text;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.charset.StandardCharsets;
import java.security.MessageDigest;
import java.util.Arrays;
import java.util.HexFormat;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class Sha256Test {
    private static final long SEED = 256;

    /** The examples of FIPS 180. */
    @ParameterizedTest
    @CsvSource({"'', e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855",
        "abc, ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad",
        "abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq, 248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1"})
    void theExamplesOfTheStandardHold(String text, String digest) {
        assertThat(Sha256.of(text.getBytes(StandardCharsets.US_ASCII))).isEqualTo(digest);
    }

    @Test
    void itIsThatOfJavaForEveryLengthAboutABlock() throws Exception {
        Random random = new Random(SEED);
        for (int length = 0; length < 300; length++) {
            byte[] bytes = new byte[length];
            random.nextBytes(bytes);
            assertThat(Sha256.of(bytes)).as("length " + length).isEqualTo(javas(bytes));
        }
    }

    @Test
    void itDoesNotDependOnThePiecesInWhichTheBytesCome() throws Exception {
        Random random = new Random(SEED);
        byte[] bytes = new byte[100_000];
        random.nextBytes(bytes);
        Sha256 sum = new Sha256();
        for (int at = 0; at < bytes.length;) {
            int some = Math.min(random.nextInt(200), bytes.length - at);
            sum.update(bytes, at, some);
            at += some;
        }

        assertThat(sum.hex()).isEqualTo(javas(bytes)).isEqualTo(Sha256.of(bytes))
            .isNotEqualTo(Sha256.of(Arrays.copyOf(bytes, bytes.length - 1)));
    }

    private static String javas(byte[] bytes) throws Exception {
        return HexFormat.of().formatHex(MessageDigest.getInstance("SHA-256").digest(bytes));
    }
}
