package simpleray.accel;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.HashMap;
import java.util.Map;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Each primitive that a ray from the point can hit is in the list of the ray's direction. */
class LightBufferTest {
    private static final long SEED = 1986;

    private static double[] unit(double x, double y, double z) {
        double length = Math.sqrt(x * x + y * y + z * z);
        return new double[] {x / length, y / length, z / length};
    }

    /** {@return the lower bounds of the distances in the list of a direction} Checks that the list is sorted. */
    private static Map<Integer, Double> list(LightBuffer buffer, double[] d) {
        int cell = buffer.cell(d[0], d[1], d[2]);
        Map<Integer, Double> list = new HashMap<>();
        double near = 0;
        for (int k = buffer.start(cell); k < buffer.start(cell + 1); k++) {
            assertThat(buffer.near(k)).as("the nearest come first").isGreaterThanOrEqualTo(near);
            near = buffer.near(k);
            assertThat(list.put(buffer.primitive(k), near)).as("each stands there once").isNull();
        }
        return list;
    }

    @ParameterizedTest
    @CsvSource({"20, 0.5, 0, 0, 0", "300, 1, 0, 0, 0", "300, 1, 5, 1, 2", "300, 1, -3, 0.5, 40", "2000, 0.2, 0.1, 0.2, 0.3", "300, 0, 1, 1, 1",
        "300, 0.5, 5000, 100, 3", "9, 30, 0, 1, 2"})
    void whatARayFromThePointHitsIsListed(int count, double size, double x, double y, double z) {
        Random random = new Random(SEED);
        double[][] boxes = Boxes.random(random, count, size);
        LightBuffer buffer = LightBuffer.of(Boxes.bounds(boxes), x, y, z);
        int hits = 0;
        long listed = 0;
        for (int i = 0; i < 5000; i++) {
            double[] box = boxes[i % count];
            double[] aim = new double[3];
            for (int axis = 0; axis < 3; axis++) {            // some at a corner or an edge
                aim[axis] = box[axis] + (box[axis + 3] - box[axis]) * (random.nextInt(4) == 0 ? random.nextInt(2) : random.nextDouble());
            }
            double[] d = i % 10 == 0 ? unit(random.nextGaussian(), random.nextGaussian(), random.nextGaussian())
                : i % 10 == 1 ? unit(i % 3 == 0 ? 1 : 0, i % 3 == 1 ? -1 : 0, i % 3 == 2 ? 1 : 0)
                : unit(aim[0] - x, aim[1] - y, aim[2] - z);
            Map<Integer, Double> list = list(buffer, d);
            listed += list.size();
            for (int k = 0; k < count; k++) {
                double t = Boxes.entry(boxes[k], new double[] {x, y, z, d[0], d[1], d[2]});
                if (t >= 0) {
                    hits++;
                    assertThat(list).as("seed %d, ray %d", SEED, i).containsKey(k);
                    assertThat(list.get(k)).isLessThanOrEqualTo(t);
                }
            }
        }
        assertThat(hits).isGreaterThan(count == 300 && size == 0 ? 0 : 2000);
        assertThat(listed).as("few others are listed").isLessThan(5000L * Math.max(9, count / 4));
    }

    /** As from a lamp, a small tree on a wide ground: nearly all lists have the ground alone, and a few have the tree. */
    @Test
    void aCrowdInFewDirectionsHasNoLists() {
        double[][] boxes = Boxes.random(new Random(SEED), 2000, 0.01);
        double[][] withGround = Arrays.copyOf(boxes, boxes.length + 1);
        withGround[boxes.length] = new double[] {-300, -2, -300, 300, -1, 300};

        assertThat(LightBuffer.of(Boxes.bounds(withGround), -50, 50, 500)).isNull();
        assertThat(LightBuffer.of(Boxes.bounds(boxes), -50, 50, 500)).isNotNull();
    }

    /** A box from 3 to 4 along x, and from 4 to 5 along y. */
    @Test
    void theDistanceOfAPrimitiveIsThatOfItsNearestCorner() {
        LightBuffer buffer = LightBuffer.of(Boxes.bounds(new double[] {3, 4, -1, 4, 5, 1}, new double[] {-1, -1, -1, 1, 1, 1}), 0, 0, 0);

        assertThat(list(buffer, unit(3, 4, 0)).get(0)).isBetween(5 - 1e-4, 5.0);
        assertThat(list(buffer, unit(1, 2, 3))).containsExactly(Map.entry(1, 0.0));
    }

    @Test
    void listsAreSortedByDistance() {
        double[][] row = new double[12][];
        Arrays.setAll(row, i -> new double[] {i * 7 % 12 + 1, -1, -1, i * 7 % 12 + 1.5, 1, 1});
        LightBuffer buffer = LightBuffer.of(Boxes.bounds(row), 0, 0, 0);

        int cell = buffer.cell(1, 0, 0);
        assertThat(buffer.start(cell + 1) - buffer.start(cell)).isEqualTo(12);
        for (int i = 0; i < 12; i++) {
            assertThat(row[buffer.primitive(buffer.start(cell) + i)][0]).isEqualTo(i + 1);
        }
    }

    @Test
    void aDirectionWithoutPrimitivesHasAnEmptyList() {
        LightBuffer buffer = LightBuffer.of(Boxes.bounds(new double[] {3, 4, -1, 4, 5, 1}), 0, 0, 0);

        for (double[] d : new double[][] {{-1, 0, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}, {1, 0, 0}}) {
            assertThat(list(buffer, d)).isEmpty();
        }
    }

    @Test
    void aRayToThePointMayStartAMillionExtentsAway() {
        PrimitiveBounds bounds = Boxes.bounds(new double[] {-2, -2, -2, 2, 2, 2});

        assertThat(LightBuffer.of(bounds, 0, 0, 1).reach()).isEqualTo(bounds.reach());
    }

    @Test
    void aPointFarAwayHasNoBuffer() {
        PrimitiveBounds bounds = Boxes.bounds(new double[] {-1, -1, -1, 1, 1, 1});

        assertThat(LightBuffer.of(bounds, 9999, 0, 0)).isNotNull();
        for (double[] p : new double[][] {{10_001, 0, 0}, {0, -10_001, 0}, {0, 0, 10_001}, {Double.NaN, 0, 0}}) {
            assertThat(LightBuffer.of(bounds, p[0], p[1], p[2])).isNull();
        }
    }

    /** Each of a hundred thousand boxes is visible in all directions. */
    @Test
    void longListsMakeNoBuffer() {
        double[][] boxes = new double[100_000][];
        Arrays.fill(boxes, new double[] {-1, -1, -1, 1, 1, 1});

        assertThat(LightBuffer.of(Boxes.bounds(boxes), 0, 0, 0)).isNull();
    }

    /** The sample has every 25th box: these are small, and all others are large. */
    @Test
    void longListsThatTheSampleMissesMakeNoBuffer() {
        double[][] boxes = new double[100_000][];
        for (int i = 0; i < boxes.length; i++) {
            double half = i % 25 == 0 ? 1e-3 : 1;
            boxes[i] = new double[] {-half, -half, 2 - half, half, half, 2 + half};
        }

        assertThat(LightBuffer.of(Boxes.bounds(boxes), 0, 0, 0)).isNull();
    }
}
