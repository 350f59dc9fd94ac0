package simpleray.accel;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Random;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Compares the nearest hit and the occlusion that a traversal finds with those found by testing each box. */
abstract class TraversalTest {
    static final double INFINITY = Double.POSITIVE_INFINITY;

    final long seed;
    double[][] boxes;
    BoxIntersector walked;
    private BoxIntersector looped;

    TraversalTest(long seed) {
        this.seed = seed;
    }

    /** Builds the structure, and a traversal of it that tests its boxes by {@link #walked}. */
    abstract void build(PrimitiveBounds bounds, Pool pool);

    abstract void traverseClosest(double[] ray, double limit);

    abstract boolean traverseOccluded(double[] ray, double distance);

    final void build(double[]... newBoxes) {
        boxes = newBoxes;
        try (Pool pool = new Pool(1)) {
            PrimitiveBounds bounds = Boxes.bounds(boxes, pool);
            walked = new BoxIntersector(boxes, bounds.ids());
            looped = new BoxIntersector(boxes, bounds.ids());
            build(bounds, pool);                              // which orders the ids
        }
    }

    final void closest(double[] ray, double limit) {
        walked.start(ray, limit);
        traverseClosest(ray, limit);
    }

    final boolean occluded(double[] ray, double distance) {
        walked.start(ray, distance);
        return traverseOccluded(ray, distance);
    }

    /** Compares the traversal with the loop; returns whether the ray hits. */
    final boolean compared(double[] ray, String where) {
        looped.start(ray, INFINITY);
        looped.closestOfAll();
        double t = looped.t;
        closest(ray, INFINITY);
        assertThat(walked.id).as(where).isEqualTo(looped.id);
        assertThat(walked.t).as(where).isEqualTo(t);
        assertThat(occluded(ray, t)).as(where + ": before the nearest").isFalse();
        assertThat(occluded(ray, Math.nextUp(t))).as(where + ": up to the nearest").isEqualTo(t < INFINITY);
        assertThat(occluded(ray, INFINITY)).as(where + ": anywhere").isEqualTo(t < INFINITY);
        return t < INFINITY;
    }

    @ParameterizedTest
    @CsvSource({"1, 1", "2, 1", "9, 0.5", "30, 3", "300, 0.3", "2000, 0.1", "300, 0"})
    void theTraversalFindsTheSameAsATestOfEachBox(int count, double size) {
        Random random = new Random(seed);
        build(Boxes.withTwins(random, count, size));
        int hits = 0;
        for (int i = 0; i < 5000; i++) {
            hits += compared(Boxes.ray(random, boxes), "seed " + seed + ", ray " + i) ? 1 : 0;
        }
        assertThat(hits).as("rays that hit").isBetween(1250, 4999);
    }
}
