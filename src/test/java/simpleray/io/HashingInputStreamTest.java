package simpleray.io;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.util.Arrays;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class HashingInputStreamTest {
    @Test
    void theRestIsGivenIfItIsNotTooLong() throws IOException {
        byte[] ten = new byte[10];
        assertThat(new HashingInputStream(new ByteArrayInputStream(ten), 100).rest(11)).isEqualTo(ten);
        assertThat(new HashingInputStream(new ByteArrayInputStream(ten), 100).rest(10)).isEqualTo(ten);
        assertThat(new HashingInputStream(new ByteArrayInputStream(ten), 100).rest(9)).isNull();
        assertThat(new HashingInputStream(new ByteArrayInputStream(ten), 9).rest(20)).isNull();
    }

    @ParameterizedTest
    @ValueSource(ints = {0, 1, 2, 7, 8, 65_536, 65_537, 3_000_000})
    void whatIsReadIsDigestedAndKept(int length) throws IOException {
        byte[] bytes = new byte[length];
        new Random(length).nextBytes(bytes);
        HashingInputStream in = new HashingInputStream(new ByteArrayInputStream(bytes), length);

        assertThat(in.readAllBytes()).isEqualTo(bytes);
        assertThat(in.sha256()).isEqualTo(Sha256.of(bytes));
        assertThat(in.kept()).isEqualTo(bytes);
    }

    @Test
    void whatIsTooLongIsDigestedAndNotKept() throws IOException {
        byte[] bytes = new byte[100_000];
        HashingInputStream in = new HashingInputStream(new ByteArrayInputStream(bytes), 99_999);

        in.readAllBytes();

        assertThat(in.kept()).isNull();
        assertThat(in.sha256()).isEqualTo(Sha256.of(bytes));
    }

    @Test
    void whatIsNotKeptIsDigestedWhereverThePiecesAreCut() throws IOException {
        byte[] bytes = new byte[3_000_000];
        new Random(1).nextBytes(bytes);
        HashingInputStream in = new HashingInputStream(new ByteArrayInputStream(bytes), 150_000);
        Random lengths = new Random(2);
        byte[] some = new byte[40_000];

        while (in.read(some, 0, 1 + lengths.nextInt(some.length)) >= 0) {
            Arrays.fill(some, (byte) 0);                      // what was read is the reader's
        }

        assertThat(in.sha256()).isEqualTo(Sha256.of(bytes));
        assertThat(in.kept()).isNull();
    }

    @Test
    void theRestOfAShortFileCanBeReadToGetAllOfIt() throws IOException {
        byte[] bytes = new byte[20_000];
        new Random(3).nextBytes(bytes);
        HashingInputStream in = new HashingInputStream(new ByteArrayInputStream(bytes), 30_000);
        in.readNBytes(5);

        assertThat(in.rest(20_000)).isEqualTo(bytes);
        assertThat(in.read()).isEqualTo(-1);
    }

    @Test
    void ofATooLongFileNoMoreIsReadThanShowsIt() throws IOException {
        int[] read = new int[1];
        InputStream endless = new InputStream() {
            @Override
            public int read() {
                read[0]++;
                return 1;
            }
        };
        HashingInputStream in = new HashingInputStream(endless, 30_000);

        assertThat(in.rest(20_000)).isNull();
        assertThat(read[0]).isBetween(20_001, 30_000);
    }

    @Test
    void bytesMayBeReadOneByOne() throws IOException {
        HashingInputStream in = new HashingInputStream(new ByteArrayInputStream(new byte[] {(byte) 0xFF, 1}), 2);

        assertThat(new int[] {in.read(), in.read(), in.read()}).containsExactly(0xFF, 1, -1);
        assertThat(in.sha256()).isEqualTo(Sha256.of(new byte[] {(byte) 0xFF, 1}));
    }

    @Test
    void closingClosesTheFile() throws IOException {
        boolean[] closed = new boolean[1];
        new HashingInputStream(new ByteArrayInputStream(new byte[1]) {
            @Override
            public void close() {
                closed[0] = true;
            }
        }, 0).close();

        assertThat(closed).containsExactly(true);
    }
}
