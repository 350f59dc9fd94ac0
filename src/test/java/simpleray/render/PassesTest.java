package simpleray.render;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** The order in which a picture is rendered for a window. */
class PassesTest {
    @ParameterizedTest
    @CsvSource({"1, 1", "8, 8", "9, 7", "40, 17", "3, 100"})
    void everyPixelComesOnce(int width, int height) {
        assertThat(times(new Passes(width, height, null, false, false), width, height)).containsOnly(1);
    }

    @ParameterizedTest
    @CsvSource({"0, 0, 40, 17", "0, 0, 1, 1", "39, 16, 1, 1", "5, 3, 20, 9", "8, 8, 8, 8", "0, 4, 40, 2"})
    void everyPixelComesOnceAlsoWhereARegionComesFirst(int x, int y, int width, int height) {
        assertThat(times(new Passes(40, 17, new Region(x, y, width, height), false, false), 40, 17)).containsOnly(1);
    }

    @Test
    void aRegionAloneIsAllThatComes() {
        int[] times = times(new Passes(40, 17, new Region(5, 3, 20, 9), true, false), 40, 17);

        for (int i = 0; i < times.length; i++) {
            boolean inside = i % 40 >= 5 && i % 40 < 25 && i / 40 >= 3 && i / 40 < 12;
            assertThat(times[i]).as("pixel " + i % 40 + ", " + i / 40).isEqualTo(inside ? 1 : 0);
        }
    }

    @Test
    void theFirstPassCoversTheWholeWithBlocks() {
        Passes passes = new Passes(40, 17, null, false, false);
        boolean[] covered = new boolean[40 * 17];
        int parts = 0;
        boolean over = false;
        while (!over) {
            Part part = passes.next();
            assertThat(part.size()).isEqualTo(8);
            for (int x = part.x(); x < part.end(); x += part.step()) {
                for (int i = 0; i < 64; i++) {
                    if (x + i % 8 < 40 && part.y() + i / 8 < 17) {
                        covered[(part.y() + i / 8) * 40 + x + i % 8] = true;
                    }
                }
            }
            parts++;
            over = passes.finished(part);
        }
        assertThat(parts).isEqualTo(3);
        assertThat(covered).containsOnly(true);
    }

    @Test
    void aRegionsPixelsComeBeforeAllOthers() {
        Passes passes = new Passes(40, 17, new Region(5, 3, 20, 9), false, false);
        for (int pixels = 0; pixels < 20 * 9;) {
            Part part = passes.next();
            passes.finished(part);
            assertThat(part.y()).isBetween(3, 11);
            assertThat(part.x()).isGreaterThanOrEqualTo(5);
            assertThat(part.end()).isLessThanOrEqualTo(25);
            pixels += part.count();
        }
        assertThat(passes.next().y()).isZero();
    }

    @Test
    void eachPixelHasItsPreviewAndThoseOfItsNeighboursBeforeItComes() {
        for (Region first : new Region[] {null, new Region(5, 3, 20, 9)}) {
            Passes passes = new Passes(40, 17, first, false, true);
            int[] previews = new int[40 * 17];
            int[] times = new int[40 * 17];
            for (Part part = passes.next(); part != null; part = passes.next()) {
                for (int x = part.x(); x < part.end(); x += part.step()) {
                    if (part.preview()) {
                        previews[part.y() * 40 + x]++;
                        continue;
                    }
                    times[part.y() * 40 + x]++;
                    for (int ny = Math.max(0, part.y() - 1); ny <= Math.min(16, part.y() + 1); ny++) {
                        for (int nx = Math.max(0, x - 1); nx <= Math.min(39, x + 1); nx++) {
                            assertThat(previews[ny * 40 + nx]).as("preview of " + nx + ", " + ny).isEqualTo(1);
                        }
                    }
                }
                passes.finished(part);
            }
            assertThat(previews).containsOnly(1);
            assertThat(times).containsOnly(1);
        }
    }

    @Test
    void toStopLeavesNothingToDo() {
        Passes passes = new Passes(40, 17, null, false, false);
        passes.next();
        passes.stop();

        assertThat(passes.next()).isNull();
    }

    private static int[] times(Passes passes, int width, int height) {
        int[] times = new int[width * height];
        for (Part part = passes.next(); part != null; part = passes.next()) {
            int count = 0;
            for (int x = part.x(); x < part.end(); x += part.step()) {
                times[part.y() * width + x]++;
                count++;
            }
            assertThat(part.count()).isEqualTo(count);
            passes.finished(part);
        }
        return times;
    }
}
