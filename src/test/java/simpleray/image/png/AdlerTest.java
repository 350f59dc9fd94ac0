package simpleray.image.png;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.Random;
import java.util.zip.Adler32;
import org.junit.jupiter.api.Test;

class AdlerTest {
    private static final long SEED = 1995;

    @Test
    void theSumOfNothingIsOne() {
        assertThat(new Adler().value()).isEqualTo(1);
    }

    @Test
    void piecesAddUpToTheSumOfAll() {
        Random random = new Random(SEED);
        for (int i = 0; i < 1000; i++) {
            byte[] bytes = new byte[random.nextInt(2000)];
            random.nextBytes(bytes);
            assertAddsUp(bytes, random.nextInt(bytes.length + 1), random.nextInt(bytes.length + 1));
        }
    }

    @Test
    void longPiecesOfTheLargestBytesAddUp() {
        byte[] bytes = new byte[300_000];
        Arrays.fill(bytes, (byte) -1);
        assertAddsUp(bytes, 1, 299_999);
        assertAddsUp(bytes, 65_521, 131_042);
    }

    @Test
    void aLowHalfOfZeroIsGoneOnFrom() {
        // 1 + 256 * 255 + 240 = 65521, which is 0 by the modulus
        byte[] bytes = new byte[300];
        Arrays.fill(bytes, 0, 256, (byte) -1);
        bytes[256] = (byte) 240;
        assertThat(sum(bytes, 0, 257) & 0xFFFF).isZero();
        assertAddsUp(bytes, 257, 257);
        assertAddsUp(bytes, 257, 280);
    }

    private static void assertAddsUp(byte[] bytes, int oneEnd, int otherEnd) {
        int first = Math.min(oneEnd, otherEnd);
        int second = Math.max(oneEnd, otherEnd);
        Adler adler = new Adler();
        adler.append(sum(bytes, 0, first), first);
        adler.append(sum(bytes, first, second), second - first);
        adler.append(sum(bytes, second, bytes.length), bytes.length - second);
        assertThat(adler.value()).as(bytes.length + " bytes, cut at " + first + " and " + second + ", seed " + SEED)
            .isEqualTo(sum(bytes, 0, bytes.length));
    }

    private static int sum(byte[] bytes, int from, int to) {
        Adler32 sum = new Adler32();
        sum.update(bytes, from, to - from);
        return (int) sum.getValue();
    }
}
