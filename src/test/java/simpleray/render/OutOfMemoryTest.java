package simpleray.render;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.catchThrowable;

import java.io.IOException;
import java.util.concurrent.ExecutionException;
import org.junit.jupiter.api.Test;

class OutOfMemoryTest {
    private static final OutOfMemoryError FULL = new OutOfMemoryError("made up");

    @Test
    void anOutOfMemoryErrorIsFoundAmongTheCauses() {
        assertThat(OutOfMemory.isBehind(FULL)).isTrue();
        assertThat(OutOfMemory.isBehind(new IllegalStateException(new ExecutionException(FULL)))).isTrue();
        assertThat(OutOfMemory.isBehind(new ExceptionInInitializerError(FULL))).isTrue();
    }

    /** The JVM may throw the same error object twice, and an exception cannot be added to itself as suppressed. */
    @Test
    void anOutOfMemoryErrorIsFoundInAResourceThatCannotBeClosed() {
        Throwable thrown = catchThrowable(() -> FULL.addSuppressed(FULL));

        assertThat(thrown).isInstanceOf(IllegalArgumentException.class);
        assertThat(OutOfMemory.isBehind(thrown)).isTrue();
    }

    @Test
    void otherExceptionsDoNotComeFromALackOfMemory() {
        assertThat(OutOfMemory.isBehind(new IllegalStateException(new IOException("of a disk")))).isFalse();
        assertThat(OutOfMemory.isBehind(new StackOverflowError())).isFalse();
    }
}
