package simpleray.render;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.catchThrowable;

import java.io.IOException;
import java.util.concurrent.ExecutionException;
import org.junit.jupiter.api.Test;

class OutOfMemoryTest {
    private static final OutOfMemoryError FULL = new OutOfMemoryError("made up");

    @Test
    void itIsBehindItselfAndWhatItCauses() {
        assertThat(OutOfMemory.isBehind(FULL)).isTrue();
        assertThat(OutOfMemory.isBehind(new IllegalStateException(new ExecutionException(FULL)))).isTrue();
        assertThat(OutOfMemory.isBehind(new ExceptionInInitializerError(FULL))).isTrue();
    }

    /** The machine may throw one and the same error twice, which cannot be added to itself. */
    @Test
    void itIsBehindAResourceThatCannotBeClosedForTheSameReason() {
        Throwable thrown = catchThrowable(() -> FULL.addSuppressed(FULL));

        assertThat(thrown).isInstanceOf(IllegalArgumentException.class);
        assertThat(OutOfMemory.isBehind(thrown)).isTrue();
    }

    @Test
    void itIsNotBehindOtherFaults() {
        assertThat(OutOfMemory.isBehind(new IllegalStateException(new IOException("of a disk")))).isFalse();
        assertThat(OutOfMemory.isBehind(new StackOverflowError())).isFalse();
    }
}
