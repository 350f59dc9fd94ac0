package simpleray.ui.film;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Dimension;
import java.awt.image.BufferedImage;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import simpleray.ui.film.PlayPlan.Choice;

class PlayPlanTest {
    private static final Dimension SIZE = new Dimension(240, 120);
    private static final long MANY = 1L << 30;
    private static final long PIXEL = 1000;                   // nanoseconds for a pixel, 28.8 ms for a whole frame

    private static void keep(FrameCache cache, PlayPlan plan, Choice choice) {
        Dimension sides = plan.sides(choice.divisor());
        cache.put(choice.frame(), new FrameCache.Kept(new BufferedImage(sides.width, sides.height, BufferedImage.TYPE_INT_RGB),
            choice.divisor()), frame -> frame);
    }

    private static void measure(PlayPlan plan, int divisor, long perPixel) {
        Dimension sides = plan.sides(divisor);
        plan.took(perPixel * sides.width * sides.height, divisor);
    }

    @Test
    void theFirstFrameIsTheCoarsestAndTellsHowFineTheOthersMayBe() {
        FrameCache cache = new FrameCache(MANY);
        PlayPlan plan = new PlayPlan(48, 24, SIZE, cache);

        assertThat(plan.next(5, true)).isEqualTo(new Choice(5, 8));
        measure(plan, 8, PIXEL);

        assertThat(plan.next(5, true)).as("28.8 ms of 41.7 ms").isEqualTo(new Choice(5, 1));
        measure(plan, 1, 7 * PIXEL);
        assertThat(plan.next(5, true)).as("4000 ns a pixel: 28.8 ms at half the size").isEqualTo(new Choice(5, 2));
    }

    @Test
    void framesThatAreShownWhileOneIsRenderedAreSkipped() {
        PlayPlan plan = new PlayPlan(48, 24, SIZE, new FrameCache(MANY));
        measure(plan, 8, 400 * PIXEL);                        // 180 ms at the coarsest: four frames pass

        assertThat(plan.next(0, true)).isEqualTo(new Choice(4, 8));
        assertThat(plan.next(46, true)).isEqualTo(new Choice(2, 8));
        assertThat(plan.next(40, false)).isEqualTo(new Choice(44, 8));
        assertThat(plan.next(46, false)).isEqualTo(new Choice(46, 8));
    }

    @Test
    void everyFrameComesOnceAndThenEachAgainAsFineAsFits() {
        FrameCache cache = new FrameCache(10 * 4 * 120 * 60);  // ten frames of half the size
        PlayPlan plan = new PlayPlan(10, 25, SIZE, cache);
        measure(plan, 1, 30 * PIXEL);                         // 31 ms at a sixth of the size
        List<Integer> coarse = new ArrayList<>();
        List<Integer> fine = new ArrayList<>();
        for (Choice next = plan.next(3, true); next != null; next = plan.next(3, true)) {
            assertThat(next.divisor()).isIn(2, 6);
            (next.divisor() == 6 ? coarse : fine).add(next.frame());
            keep(cache, plan, next);
        }

        assertThat(coarse).containsExactlyInAnyOrder(0, 1, 2, 3, 4, 5, 6, 7, 8, 9);
        assertThat(fine).containsExactly(3, 4, 5, 6, 7, 8, 9, 0, 1, 2);
    }

    @Test
    void ofAFilmThatDoesNotFitOnlyWhatComesNextIsRendered() {
        FrameCache cache = new FrameCache(5 * 4 * 30 * 15);   // five frames of an eighth of the size
        PlayPlan plan = new PlayPlan(1_000_000, 25, SIZE, cache);
        measure(plan, 8, 50 * PIXEL);
        int rendered = 0;
        for (Choice next = plan.next(100, true); next != null; next = plan.next(100, true)) {
            assertThat(next.frame()).isBetween(100, 105);
            keep(cache, plan, next);
            rendered++;
        }

        assertThat(rendered).isBetween(1, 5);
        assertThat(plan.next(101, true)).isNotNull();
    }
}
