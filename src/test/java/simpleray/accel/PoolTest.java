package simpleray.accel;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.concurrent.CancellationException;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicIntegerArray;
import java.util.concurrent.locks.LockSupport;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

@Timeout(value = 60, threadMode = Timeout.ThreadMode.SEPARATE_THREAD)
class PoolTest {
    private static final int MANY = 1_000_000;

    @ParameterizedTest
    @ValueSource(ints = {1, 2, 7})
    void everyThingOfARangeIsDoneOnce(int threads) {
        AtomicIntegerArray times = new AtomicIntegerArray(MANY);

        try (Pool pool = new Pool(threads)) {
            pool.ranges(MANY, (from, to) -> {
                for (int i = from; i < to; i++) {
                    times.incrementAndGet(i);
                }
            });
        }

        for (int i = 0; i < MANY; i++) {
            assertThat(times.get(i)).isEqualTo(1);
        }
    }

    @Test
    void whatIsBegunIsMadeWhileOneWaits() {
        try (Pool pool = new Pool(1)) {
            Pool.Task<String> first = pool.begin(() -> "first");
            Pool.Task<String> second = pool.begin(() -> "second");

            assertThat(pool.await(second)).isEqualTo("second");
            assertThat(pool.await(first)).isEqualTo("first");
        }
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 2, 7})
    void whatIsThrownInAPartOfARangeIsThrownWhereItIsWaitedFor(int threads) {
        OutOfMemoryError full = new OutOfMemoryError("made up");

        try (Pool pool = new Pool(threads)) {
            assertThatThrownBy(() -> pool.ranges(MANY, (from, to) -> {
                if (from <= MANY / 3 && MANY / 3 < to) {
                    throw full;
                }
            })).isSameAs(full);
        }
    }

    @Test
    void whatIsThrownInOneTaskIsThrownByWhoWaitsForAnother() {
        IllegalStateException fault = new IllegalStateException("made up");
        CountDownLatch thrown = new CountDownLatch(1);

        try (Pool pool = new Pool(1)) {
            pool.begin(() -> {
                thrown.countDown();
                throw fault;
            });
            Pool.Task<String> other = pool.begin(() -> "never waited for in vain");

            assertThatThrownBy(() -> {
                thrown.await();
                pool.await(other);
                pool.await(pool.begin(() -> "nor this"));
            }).isSameAs(fault);
        }
    }

    /** As when there is no memory even to look for the next task. */
    @Test
    void theDeathOfAThreadIsNotWaitedOutInVain() {
        OutOfMemoryError full = new OutOfMemoryError("made up");

        try (Pool pool = new Pool(2)) {
            Pool.Task<Object> task = pool.begin(() -> {
                Thread.currentThread().getUncaughtExceptionHandler().uncaughtException(Thread.currentThread(), full);
                return never();
            });

            assertThatThrownBy(() -> pool.await(task)).isSameAs(full);
        }
    }

    /** So the library tells those who wait for what a thread had taken when it died. */
    @Test
    void aTaskThatWentWithItsThreadIsAWantOfMemory() {
        try (Pool pool = new Pool(2)) {
            Pool.Task<Object> task = pool.begin(() -> {
                throw new CancellationException();
            });

            assertThatThrownBy(() -> pool.await(task)).isInstanceOf(OutOfMemoryError.class)
                .hasMessage("a thread that makes the scene ready has ended");
        }
    }

    /** Lest the memory be still short when the end of it is to be told. */
    @Test
    void closingWaitsForWhatIsStillAtWork() {
        AtomicBoolean ended = new AtomicBoolean();
        CountDownLatch atWork = new CountDownLatch(1);

        try (Pool pool = new Pool(2)) {
            pool.begin(() -> {
                atWork.countDown();
                never();                                      // until the threads are told to end
                LockSupport.parkNanos(TimeUnit.MILLISECONDS.toNanos(50));
                ended.set(true);
                return null;
            });
            assertThatThrownBy(() -> {
                atWork.await();
                pool.await(pool.begin(() -> {
                    throw new OutOfMemoryError("made up");
                }));
            }).isInstanceOf(OutOfMemoryError.class);
            assertThat(ended).isFalse();
        }

        assertThat(ended).isTrue();
    }

    @Test
    void anInterruptIsPassedOnAndTheWorkDoneAllTheSame() {
        try (Pool pool = new Pool(1)) {
            Thread.currentThread().interrupt();

            assertThat(pool.await(pool.begin(() -> "done"))).isEqualTo("done");
            assertThat(Thread.interrupted()).isTrue();
        }
    }

    /** Waits until its thread is told to end. */
    private static Object never() {
        try {
            return new CountDownLatch(1).await(1, TimeUnit.MINUTES);
        } catch (InterruptedException e) {
            return null;
        }
    }
}
