package simpleray.image;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.ClosedChannelException;
import java.nio.charset.StandardCharsets;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.Map;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import simpleray.io.FileInUseException;

/** Rows come back from a checkpoint as they were put in, or not at all. */
class CheckpointTest {
    private static final int WIDTH = 2;
    private static final int HEIGHT = 5;
    private static final int ROW = 3 * WIDTH;
    /** A row's number, its levels, its sum. */
    private static final int RECORD = 4 + ROW + 4;

    @TempDir
    Path folder;
    private Path path;
    private Map<String, String> identity;

    @BeforeEach
    void name() {
        path = folder.resolve("picture.part");
        identity = new LinkedHashMap<>();
        identity.put("version", "1.2");
        identity.put("window", "a: b, ö");
    }

    private static byte[] row(int y) {
        byte[] levels = new byte[ROW];
        for (int i = 0; i < ROW; i++) {
            levels[i] = (byte) (100 * y + 7 * i);
        }
        return levels;
    }

    private Checkpoint create() throws IOException {
        return Checkpoint.create(path, identity, ROW, HEIGHT);
    }

    private Checkpoint open() throws IOException {
        return Checkpoint.open(path, identity, ROW, HEIGHT);
    }

    /** Makes a checkpoint of the rows 3, 0 and 4. */
    private byte[] three() throws IOException {
        try (Checkpoint checkpoint = create()) {
            for (int y : new int[] {3, 0, 4}) {
                checkpoint.put(y, row(y), 0);
            }
        }
        return Files.readAllBytes(path);
    }

    private void assertHolds(int... rows) throws IOException {
        try (Checkpoint checkpoint = open()) {
            assertHolds(checkpoint, rows);
        }
    }

    private static void assertHolds(Checkpoint checkpoint, int... rows) throws IOException {
        for (int y = 0; y < HEIGHT; y++) {
            int number = y;
            boolean kept = Arrays.stream(rows).anyMatch(row -> row == number);
            assertThat(checkpoint.levels(y)).as("row " + y).isEqualTo(kept ? row(y) : null);
        }
        assertThat(checkpoint.count()).isEqualTo(rows.length);
    }

    @Test
    void rowsComeBackInAnyOrder() throws IOException {
        three();

        assertThat(Checkpoint.identity(path)).containsExactlyEntriesOf(identity);
        assertHolds(0, 3, 4);
    }

    @Test
    void moreRowsAreAppended() throws IOException {
        three();
        try (Checkpoint checkpoint = open()) {
            checkpoint.put(2, row(2), 0);
            assertHolds(checkpoint, 0, 2, 3, 4);
        }

        assertHolds(0, 2, 3, 4);
    }

    @Test
    void aClosedOrRemovedOneTakesNoMoreRows() throws IOException {
        Checkpoint closed = create();
        closed.close();
        assertThatThrownBy(() -> closed.put(1, row(1), 0)).isInstanceOf(ClosedChannelException.class);
        Checkpoint removed = open();
        removed.remove();
        assertThatThrownBy(() -> removed.put(1, row(1), 0)).isInstanceOf(ClosedChannelException.class);
        assertThat(path).doesNotExist();
    }

    @ParameterizedTest
    @ValueSource(ints = {-1, Integer.MIN_VALUE, Integer.MAX_VALUE, 65537})
    void aHeadWhoseTextHasNoSuchLengthTellsNothing(int length) throws IOException {
        byte[] bytes = three();
        int at = "SimpleRay checkpoint 1\n".length();
        Files.write(path, ByteBuffer.wrap(bytes).putInt(at, length).array());

        assertThat(Checkpoint.identity(path)).isNull();
    }

    @Test
    void levelsMayBeginAnywhereInTheirArray() throws IOException {
        byte[] levels = new byte[1 + ROW + 2];
        System.arraycopy(row(1), 0, levels, 1, ROW);
        try (Checkpoint checkpoint = create()) {
            checkpoint.put(1, levels, 1);
        }

        assertHolds(1);
    }

    @Test
    void aRowThatIsKeptStaysAsItIs() throws IOException {
        try (Checkpoint checkpoint = create()) {
            checkpoint.put(1, row(1), 0);
            checkpoint.put(1, row(2), 0);
            assertThat(checkpoint.count()).isEqualTo(1);
        }

        assertHolds(1);
    }

    @Test
    void aTornTailIsCutOff() throws IOException {
        byte[] whole = three();
        int begin = whole.length - 3 * RECORD;
        for (int length = begin; length <= whole.length; length++) {
            Files.write(path, Arrays.copyOf(whole, length));
            int records = (length - begin) / RECORD;

            assertHolds(Arrays.copyOf(new int[] {3, 0, 4}, records));
            assertThat(path).hasSize(begin + records * RECORD);
            try (Checkpoint checkpoint = open()) {
                checkpoint.put(1, row(1), 0);
            }
            try (Checkpoint checkpoint = open()) {
                assertThat(checkpoint.levels(1)).isEqualTo(row(1));
                assertThat(checkpoint.count()).isEqualTo(records + 1);
            }
        }
    }

    @Test
    void aHeadThatIsNotWholeHasNoRows() throws IOException {
        byte[] whole = three();
        int begin = whole.length - 3 * RECORD;
        for (int length = 0; length < begin; length++) {
            Files.write(path, Arrays.copyOf(whole, length));

            assertThat(Checkpoint.identity(path)).as(length + " bytes").isNull();
        }
    }

    @Test
    void aRecordWithAnyByteChangedIsNone() throws IOException {
        byte[] whole = three();
        int begin = whole.length - 3 * RECORD;
        for (int i = 0; i < RECORD; i++) {
            byte[] changed = whole.clone();
            changed[begin + RECORD + i] ^= 1 << i % 8;
            Files.write(path, changed);

            assertHolds(3, 4);
        }
    }

    @Test
    void aHeadWithAnyByteChangedIsNoneOfOurs() throws IOException {
        byte[] whole = three();
        for (int i = 0; i < whole.length - 3 * RECORD; i++) {
            byte[] changed = whole.clone();
            changed[i] ^= 1;
            Files.write(path, changed);
            if (i < "SimpleRay checkpoint 1\n".length()) {
                assertThatThrownBy(() -> Checkpoint.identity(path)).isInstanceOf(FileSystemException.class)
                    .hasMessageEndingWith(": is no checkpoint");
            } else {
                assertThat(Checkpoint.identity(path)).as("byte " + i).isNull();
            }
        }
    }

    @Test
    void whatALossOfPowerLeftEmptyIsNoRow() throws IOException {
        byte[] whole = three();
        Arrays.fill(whole, whole.length - 2 * RECORD, whole.length, (byte) 0);
        Files.write(path, whole);

        assertHolds(3);
    }

    @Test
    void aRowThatThePictureDoesNotHaveIsNone() throws IOException {
        try (Checkpoint checkpoint = Checkpoint.create(path, identity, ROW, HEIGHT + 1)) {
            checkpoint.put(HEIGHT, row(HEIGHT), 0);
            checkpoint.put(0, row(0), 0);
        }

        assertHolds(0);
    }

    @Test
    void aRowThatIsChangedInTheFileMeanwhileIsFoundOut() throws IOException {
        byte[] whole = three();
        try (Checkpoint checkpoint = open()) {
            whole[whole.length - 1]++;
            Files.write(path, whole);

            assertHolds(checkpoint, 0, 3);
            checkpoint.put(4, row(4), 0);
        }
        assertHolds(0, 3, 4);
    }

    @ParameterizedTest
    @ValueSource(strings = {"x", "SimpleRay checkpoint 2\n", "simpleray checkpoint 1\n0000000000000"})
    void anotherFileIsNoCheckpointAndIsNotRemoved(String text) throws IOException {
        Files.writeString(path, text, StandardCharsets.US_ASCII);

        assertThatThrownBy(() -> Checkpoint.identity(path)).isInstanceOf(FileSystemException.class)
            .hasMessage(path + ": is no checkpoint");
        assertThatThrownBy(() -> Checkpoint.delete(path)).isInstanceOf(FileSystemException.class)
            .hasMessage(path + ": is no checkpoint");
        assertThat(path).hasContent(text);
    }

    @Test
    void aFolderIsNoCheckpoint() {
        assertThatThrownBy(() -> Checkpoint.identity(folder)).isInstanceOf(FileSystemException.class).hasMessage(folder + ": is a folder");
    }

    @Test
    void onlyOneRenderingHasACheckpoint() throws IOException {
        try (Checkpoint checkpoint = create()) {
            String busy = path + ": is being written by another run of SimpleRay: wait until it has ended, or choose another name";
            assertThatThrownBy(this::open).isInstanceOf(FileInUseException.class).hasMessage(busy);
            assertThatThrownBy(this::create).isInstanceOf(FileInUseException.class).hasMessage(busy);
            assertThatThrownBy(() -> Checkpoint.delete(path)).isInstanceOf(FileInUseException.class).hasMessage(busy);
            checkpoint.put(0, row(0), 0);
        }

        assertHolds(0);
    }

    @Test
    void rowsThatWereKeptSinceSomebodyLookedAreNotLost() throws IOException {
        three();

        assertThatThrownBy(this::create).isInstanceOf(FileInUseException.class);

        assertHolds(0, 3, 4);
    }

    @Test
    void whatIsAnotherPicturesNowOrNoPicturesIsNotOpened() throws IOException {
        three();
        Map<String, String> before = Map.of("version", "1.1");
        assertThatThrownBy(() -> Checkpoint.open(path, before, ROW, HEIGHT)).isInstanceOf(FileInUseException.class);
        assertHolds(0, 3, 4);

        Files.delete(path);
        assertThatThrownBy(this::open).isInstanceOf(FileInUseException.class);
        assertThat(folder).isEmptyDirectory();
    }

    @Test
    void itIsRemovedByWhoHasItAndThenFree() throws IOException {
        Checkpoint first = create();
        first.put(0, row(0), 0);
        first.remove();
        assertThat(folder).isEmptyDirectory();

        three();
        assertHolds(0, 3, 4);
    }

    @Test
    void whatIsRemovedAlreadyIsRemoved() throws IOException {
        Checkpoint.delete(path);

        assertThat(folder).isEmptyDirectory();
    }

    @Test
    void nothingIsLeftBesideAFileThatIsNone() throws IOException {
        Files.writeString(path, "x");
        assertThatThrownBy(() -> Checkpoint.delete(path)).isInstanceOf(FileSystemException.class);

        assertThat(folder).isDirectoryContaining(path::equals).isDirectoryNotContaining(file -> !file.equals(path));
    }

    @Test
    void aFolderThatIsNotThereIsNamed() {
        path = folder.resolve("none").resolve("rows");

        assertThatThrownBy(this::create).isInstanceOf(FileSystemException.class).hasMessage(path + ": there is no folder "
            + folder.resolve("none"));
    }

    @Test
    void aCheckpointIsRemoved() throws IOException {
        three();
        Checkpoint.delete(path);

        assertThat(path).doesNotExist();
    }
}
