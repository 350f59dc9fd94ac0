package simpleray.accel;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

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
    void eachItemOfARangeIsProcessedOnce(int threads) {
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
    void tasksMayBeAwaitedInAnyOrder() {
        try (Pool pool = new Pool(1)) {
            Pool.Task<String> first = pool.begin(() -> "first");
            Pool.Task<String> second = pool.begin(() -> "second");

            assertThat(pool.await(second)).isEqualTo("second");
            assertThat(pool.await(first)).isEqualTo("first");
        }
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 2, 7})
    void anExceptionInAPartOfARangeIsThrownToTheCaller(int threads) {
        OutOfMemoryError full = new OutOfMemoryError("made up");

        try (Pool pool = new Pool(threads)) {
            assertThatThrownBy(() -> pool.ranges(MANY, (from, to) -> {
                if (from <= MANY / 3 && MANY / 3 < to) {
                    throw full;
                }
            })).isSameAs(full);
        }
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 2, 7})
    void anExceptionOfATaskIsThrownToTheThreadThatAwaitsIt(int threads) {
        IllegalStateException fault = new IllegalStateException("made up");

        try (Pool pool = new Pool(threads)) {
            Pool.Task<String> faulty = pool.begin(() -> {
                throw fault;
            });
            Pool.Task<String> other = pool.begin(() -> "the other");

            assertThatThrownBy(() -> pool.await(faulty)).isSameAs(fault);
            assertThat(pool.await(other)).isEqualTo("the other");
            assertThatThrownBy(() -> pool.await(faulty)).isSameAs(fault);
        }
    }

    /** As when the threads have died, or never started, because there was no memory. */
    @Test
    void aTaskThatNoThreadTakesIsRunByTheThreadThatAwaitsIt() throws InterruptedException {
        CountDownLatch atWork = new CountDownLatch(1);

        try (Pool pool = new Pool(2)) {
            pool.begin(() -> {
                atWork.countDown();
                return never();
            });
            atWork.await();

            assertThat(pool.await(pool.begin(Thread::currentThread))).isSameAs(Thread.currentThread());
        }
    }

    @Test
    void aThreadThatAwaitsATaskRunsOthersMeanwhile() {
        CountDownLatch done = new CountDownLatch(1);

        try (Pool pool = new Pool(2)) {
            CountDownLatch atWork = new CountDownLatch(1);
            Pool.Task<Boolean> first = pool.begin(() -> {
                atWork.countDown();
                return arrives(done);
            });
            assertThat(arrives(atWork)).isTrue();
            Pool.Task<Thread> second = pool.begin(() -> {
                done.countDown();
                return Thread.currentThread();
            });

            assertThat(pool.await(first)).isTrue();
            assertThat(pool.await(second)).isSameAs(Thread.currentThread());
        }
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 2, 7})
    void tasksMayBeginTasks(int threads) {
        try (Pool pool = new Pool(threads)) {
            assertThat(sum(pool, 0, 1000)).isEqualTo(499_500);
        }
    }

    private static int sum(Pool pool, int from, int to) {
        if (to - from == 1) {
            return from;
        }
        int middle = (from + to) / 2;
        Pool.Task<Integer> high = pool.begin(() -> sum(pool, middle, to));
        return sum(pool, from, middle) + pool.await(high);
    }

    @Test
    void aTaskAwaitedAfterClosingIsStillRun() {
        Pool pool = new Pool(2);
        pool.await(pool.begin(() -> "first"));
        pool.close();

        assertThat(pool.await(pool.begin(() -> "second"))).isEqualTo("second");
    }

    /** So that their memory is free when the message is printed. */
    @Test
    void closingWaitsForRunningTasks() {
        AtomicBoolean ended = new AtomicBoolean();
        CountDownLatch atWork = new CountDownLatch(1);

        try (Pool pool = new Pool(2)) {
            pool.begin(() -> {
                atWork.countDown();
                never();                                      // until the thread is interrupted
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
    void anInterruptIsKeptAndTheTaskStillDone() {
        try (Pool pool = new Pool(1)) {
            Thread.currentThread().interrupt();

            assertThat(pool.await(pool.begin(() -> "done"))).isEqualTo("done");
            assertThat(Thread.interrupted()).isTrue();
        }
    }

    private static boolean arrives(CountDownLatch latch) {
        try {
            return latch.await(1, TimeUnit.MINUTES);
        } catch (InterruptedException e) {
            return false;
        }
    }

    /** Waits until its thread is interrupted. */
    private static Object never() {
        try {
            return new CountDownLatch(1).await(1, TimeUnit.MINUTES);
        } catch (InterruptedException e) {
            return null;
        }
    }
}
