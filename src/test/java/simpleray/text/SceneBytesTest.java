package simpleray.text;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.InterruptedIOException;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

@Timeout(value = 60, threadMode = Timeout.ThreadMode.SEPARATE_THREAD)
class SceneBytesTest {
    private static final byte[] PNG = PngChunks.signature();
    private static final int LONG = 100_000;                  // another thread digests so many bytes

    @ParameterizedTest
    @ValueSource(ints = {0, 1, 2, 7, 8, 65_536, 65_537, 3_000_000})
    void whatIsReadIsDigestedAndKept(int length) throws IOException {
        byte[] bytes = new byte[length];
        new Random(length).nextBytes(bytes);
        SceneBytes in = new SceneBytes(new ByteArrayInputStream(bytes), length);

        assertThat(in.isPng()).isFalse();
        assertThat(in.readAllBytes()).isEqualTo(bytes);
        assertThat(in.sha256()).isEqualTo(Sha256.of(bytes)).isEqualTo(in.sha256());
        assertThat(in.kept()).isEqualTo(bytes);
        assertThat(in.length()).isEqualTo(length);
    }

    @Test
    void whatIsTooLongIsDigestedAndNotKept() throws IOException {
        byte[] bytes = new byte[100_000];
        SceneBytes in = new SceneBytes(new ByteArrayInputStream(bytes), 99_999);

        in.readAllBytes();

        assertThat(in.kept()).isNull();
        assertThat(in.sha256()).isEqualTo(Sha256.of(bytes));
    }

    @Test
    void whatIsNotKeptIsDigestedWhereverThePiecesAreCut() throws IOException {
        byte[] bytes = new byte[3_000_000];
        new Random(1).nextBytes(bytes);
        SceneBytes in = new SceneBytes(new ByteArrayInputStream(bytes), 150_000);
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
        SceneBytes in = new SceneBytes(new ByteArrayInputStream(bytes), 30_000);
        in.readNBytes(5);

        assertThat(in.rest(20_000)).isEqualTo(bytes);
        assertThat(in.read()).isEqualTo(-1);
    }

    @Test
    void ofATooLongFileNoMoreIsReadThanShowsIt() throws IOException {
        InputStream endless = new InputStream() {
            @Override
            public int read() {
                return 1;
            }
        };
        SceneBytes in = new SceneBytes(endless, 30_000);

        assertThat(in.rest(20_000)).isNull();
        assertThat(in.length()).isBetween(20_001L, 30_000L);
    }

    @Test
    void bytesMayBeReadOneByOne() throws IOException {
        SceneBytes in = new SceneBytes(new ByteArrayInputStream(new byte[] {(byte) 0xFF, 1}), 2);

        assertThat(new int[] {in.read(), in.read(), in.read()}).containsExactly(0xFF, 1, -1);
        assertThat(in.sha256()).isEqualTo(Sha256.of(new byte[] {(byte) 0xFF, 1}));
    }

    @Test
    void aPngIsKnownByItsFirstEightBytes() throws IOException {
        assertThat(new SceneBytes(new ByteArrayInputStream(PNG), 0).isPng()).isTrue();
        for (int n = 0; n < PNG.length; n++) {
            assertThat(new SceneBytes(new ByteArrayInputStream(Arrays.copyOf(PNG, n)), 0).isPng()).as("cut after " + n).isFalse();
            byte[] other = PNG.clone();
            other[n]++;
            SceneBytes in = new SceneBytes(new ByteArrayInputStream(other), PNG.length);
            assertThat(in.isPng()).as("other at " + n).isFalse();
            assertThat(in.readAllBytes()).as("nothing is lost").isEqualTo(other);
        }
    }

    @Test
    void behindTheSignatureOfAPngIsItsFirstChunk() throws IOException {
        byte[] file = Arrays.copyOf(PNG, 10);
        file[8] = 42;
        SceneBytes in = new SceneBytes(new ByteArrayInputStream(file), 0);

        assertThat(in.isPng()).isTrue();
        assertThat(in.behindHead().readAllBytes()).containsExactly(42, 0);
    }

    /** Who types a scene must not have to type eight characters before the first is looked at. */
    @Test
    void ofATextNoMoreThanOneByteIsWaitedFor() throws IOException {
        InputStream in = new ByteArrayInputStream("2 # objects".getBytes(StandardCharsets.UTF_8));

        assertThat(new SceneBytes(in, 0).isPng()).isFalse();
        assertThat(in.available()).isEqualTo("2 # objects".length() - 1);
    }

    @Test
    void releasingEndsTheThreadThatDigestsAndClosingClosesTheFile() throws Exception {
        boolean[] closed = new boolean[1];
        SceneBytes in = new SceneBytes(new ByteArrayInputStream(new byte[LONG]) {
            @Override
            public void close() {
                closed[0] = true;
            }
        }, 0);
        in.readNBytes(LONG);
        Thread digester = Thread.getAllStackTraces().keySet().stream().filter(t -> t.getName().equals("simpleray-digest")).findAny()
            .orElseThrow();

        in.release();
        digester.join();
        assertThat(closed).containsExactly(false);
        in.close();
        assertThat(closed).containsExactly(true);
    }

    @Test
    void anInterruptIsPassedOn() throws IOException {
        SceneBytes in = new SceneBytes(new ByteArrayInputStream(new byte[LONG]), 0);
        in.readNBytes(LONG);

        Thread.currentThread().interrupt();
        assertThatThrownBy(in::sha256).isInstanceOf(InterruptedIOException.class).hasMessage("the reading was interrupted");
        assertThat(Thread.interrupted()).isTrue();
        in.close();
    }

    /** Memory may end on any thread; who reads must hear of it, as of all else. */
    @ParameterizedTest
    @ValueSource(ints = {LONG, 3_000_000})
    void whatEndsTheThreadThatDigestsIsThrownWhereItIsReadOrAskedFor(int length) throws IOException {
        OutOfMemoryError full = new OutOfMemoryError("made up");
        SceneBytes in = new SceneBytes(new ByteArrayInputStream(new byte[length]), 0) {
            @Override
            void digest(byte[] bytes, int count) {
                throw full;
            }
        };

        assertThatThrownBy(() -> {
            in.readAllBytes();
            in.sha256();
        }).isSameAs(full);
        in.close();
    }

    @Test
    void aFaultOfTheDigestIsAFileThatCannotBeRead() throws IOException {
        IllegalStateException fault = new IllegalStateException("made up");
        SceneBytes in = new SceneBytes(new ByteArrayInputStream(new byte[LONG]), 0) {
            @Override
            void digest(byte[] bytes, int count) {
                throw fault;
            }
        };
        in.readAllBytes();

        assertThatThrownBy(in::sha256).isInstanceOf(IOException.class).hasMessage("the digest cannot be computed").hasCause(fault);
        in.close();
    }
}
