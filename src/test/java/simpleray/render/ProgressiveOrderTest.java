package simpleray.render;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.concurrent.CompletableFuture;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** The order in which a picture is rendered for a window. */
@Timeout(value = 60, threadMode = Timeout.ThreadMode.SEPARATE_THREAD)
class ProgressiveOrderTest {
    @ParameterizedTest
    @CsvSource({"1, 1", "8, 8", "9, 7", "40, 17", "3, 100"})
    void everyPixelComesOnce(int width, int height) {
        assertThat(times(new ProgressiveOrder(width, height, null, false, false), width, height)).containsOnly(1);
    }

    @ParameterizedTest
    @CsvSource({"0, 0, 40, 17", "0, 0, 1, 1", "39, 16, 1, 1", "5, 3, 20, 9", "8, 8, 8, 8", "0, 4, 40, 2"})
    void everyPixelComesOnceIfARegionComesFirst(int x, int y, int width, int height) {
        assertThat(times(new ProgressiveOrder(40, 17, new Region(x, y, width, height), false, false), 40, 17)).containsOnly(1);
    }

    @Test
    void aRegionAloneIsTheOnlyPartThatComes() {
        int[] times = times(new ProgressiveOrder(40, 17, new Region(5, 3, 20, 9), true, false), 40, 17);

        for (int i = 0; i < times.length; i++) {
            boolean inside = i % 40 >= 5 && i % 40 < 25 && i / 40 >= 3 && i / 40 < 12;
            assertThat(times[i]).as("pixel " + i % 40 + ", " + i / 40).isEqualTo(inside ? 1 : 0);
        }
    }

    @Test
    void theFirstPassCoversTheWholeWithBlocks() {
        ProgressiveOrder passes = new ProgressiveOrder(40, 17, null, false, false);
        boolean[] covered = new boolean[40 * 17];
        int runs = 0;
        boolean over = false;
        while (!over) {
            PixelRun run = passes.next();
            assertThat(run.size()).isEqualTo(8);
            for (int x = run.x(); x < run.end(); x += run.step()) {
                for (int i = 0; i < 64; i++) {
                    if (x + i % 8 < 40 && run.y() + i / 8 < 17) {
                        covered[(run.y() + i / 8) * 40 + x + i % 8] = true;
                    }
                }
            }
            runs++;
            over = passes.finished(run);
        }
        assertThat(runs).isEqualTo(3);
        assertThat(covered).containsOnly(true);
    }

    @Test
    void aRegionsPixelsComeBeforeAllOthers() {
        ProgressiveOrder passes = new ProgressiveOrder(40, 17, new Region(5, 3, 20, 9), false, false);
        for (int pixels = 0; pixels < 20 * 9;) {
            PixelRun run = passes.next();
            passes.finished(run);
            assertThat(run.y()).isBetween(3, 11);
            assertThat(run.x()).isGreaterThanOrEqualTo(5);
            assertThat(run.end()).isLessThanOrEqualTo(25);
            pixels += run.count();
        }
        assertThat(passes.next().y()).isZero();
    }

    @Test
    void eachPixelHasItsPreviewAndThoseOfItsNeighboursBeforeItComes() {
        for (Region first : new Region[] {null, new Region(5, 3, 20, 9)}) {
            ProgressiveOrder passes = new ProgressiveOrder(40, 17, first, false, true);
            int[] previews = new int[40 * 17];
            int[] times = new int[40 * 17];
            for (PixelRun run = passes.next(); run != null; run = passes.next()) {
                for (int x = run.x(); x < run.end(); x += run.step()) {
                    if (run.preview()) {
                        previews[run.y() * 40 + x]++;
                        continue;
                    }
                    times[run.y() * 40 + x]++;
                    for (int ny = Math.max(0, run.y() - 1); ny <= Math.min(16, run.y() + 1); ny++) {
                        for (int nx = Math.max(0, x - 1); nx <= Math.min(39, x + 1); nx++) {
                            assertThat(previews[ny * 40 + nx]).as("preview of " + nx + ", " + ny).isEqualTo(1);
                        }
                    }
                }
                passes.finished(run);
            }
            assertThat(previews).containsOnly(1);
            assertThat(times).containsOnly(1);
        }
    }

    @Test
    void afterStopNoRunIsHandedOut() {
        ProgressiveOrder passes = new ProgressiveOrder(40, 17, null, false, false);
        passes.next();
        passes.stop();

        assertThat(passes.next()).isNull();
    }

    @Test
    void aPassThatNeedsPreviewsWaitsUntilAllAreFinished() throws Exception {
        ProgressiveOrder passes = new ProgressiveOrder(1, 1, null, false, true);
        PixelRun preview = passes.next();
        CompletableFuture<PixelRun> next = ScanlineQueueTest.waiting(passes::next);
        assertThat(next).isNotDone();

        passes.finished(preview);

        assertThat(next.get()).isEqualTo(new PixelRun(0, 0, 1, 1, 1, false));
    }

    @Test
    void stopEndsTheWaiting() throws Exception {
        ProgressiveOrder passes = new ProgressiveOrder(1, 1, null, false, true);
        passes.next();
        CompletableFuture<PixelRun> next = ScanlineQueueTest.waiting(passes::next);

        passes.stop();
        passes.stop();

        assertThat(next.get()).isNull();
    }

    private static int[] times(ProgressiveOrder passes, int width, int height) {
        int[] times = new int[width * height];
        for (PixelRun run = passes.next(); run != null; run = passes.next()) {
            int count = 0;
            for (int x = run.x(); x < run.end(); x += run.step()) {
                times[run.y() * width + x]++;
                count++;
            }
            assertThat(run.count()).isEqualTo(count);
            passes.finished(run);
        }
        return times;
    }
}
