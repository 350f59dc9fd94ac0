package simpleray.scene;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

class RayStatsTest {
    private static RayStats counts(int factor, int level) {
        RayStats stats = new RayStats();
        stats.primary = factor;
        stats.reflected = 10 * factor;
        stats.refracted = 100 * factor;
        stats.shadow = 1000 * factor;
        stats.tests = 5 * factor;
        stats.steps = 7 * factor;
        for (int i = 0; i < factor; i++) {
            stats.ray(level);
        }
        return stats;
    }

    @Test
    void allRaysAreCounted() {
        assertThat(counts(3, 0).rays()).isEqualTo(3333);
    }

    @Test
    void aRayIsCountedAtItsLevel() {
        assertThat(counts(3, 2).depths).containsExactly(0, 0, 3);
        assertThat(counts(1, 0).depths).containsExactly(1);
    }

    @Test
    void theCountsOfTwoThreadsAreAdded() {
        RayStats sum = counts(3, 0);
        sum.add(counts(2, 1));
        sum.add(counts(1, 0));

        assertThat(sum).extracting("primary", "reflected", "refracted", "shadow", "tests", "steps")
            .containsExactly(6L, 60L, 600L, 6000L, 30L, 42L);
        assertThat(sum.depths).containsExactly(4, 2);
    }
}
