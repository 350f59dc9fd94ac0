package simpleray.accel;

import java.util.Random;
import java.util.stream.IntStream;

/** Boxes as primitives, each xmin, ymin, zmin, xmax, ymax, zmax, and rays, each an origin and a direction. */
final class Boxes {
    private static final double MISS = -1;

    private Boxes() {
    }

    /** {@return the bounds of boxes, numbered from 0} */
    static PrimitiveBounds bounds(double[][] boxes, Pool pool) {
        return new PrimitiveBounds(IntStream.range(0, boxes.length).toArray(),
            (i, box) -> System.arraycopy(boxes[i], 0, box, 0, PrimitiveBounds.SIDES), pool);
    }

    /** {@return the bounds of boxes, made by one thread} */
    static PrimitiveBounds bounds(double[]... boxes) {
        try (Pool pool = new Pool(1)) {
            return bounds(boxes, pool);
        }
    }

    /** {@return boxes about the origin, three times as far along z as along x, with sides of up to this size} */
    static double[][] random(Random random, int count, double size) {
        double[][] boxes = new double[count][PrimitiveBounds.SIDES];
        for (double[] box : boxes) {
            for (int axis = 0; axis < 3; axis++) {
                box[axis] = random.nextGaussian() * (1 + axis);
                box[axis + 3] = box[axis] + random.nextDouble() * size;
            }
        }
        return boxes;
    }

    /** {@return such boxes, of which every fourth equals the one before it} */
    static double[][] withTwins(Random random, int count, double size) {
        double[][] boxes = random(random, count, size);
        for (int i = 3; i < count; i += 4) {
            boxes[i] = boxes[i - 1].clone();
        }
        return boxes;
    }

    /** {@return t of a ray's entry into a box; 0 if it starts inside or on a side, negative if it misses} */
    static double entry(double[] box, double[] ray) {
        double near = 0;
        double far = Double.POSITIVE_INFINITY;
        for (int axis = 0; axis < 3; axis++) {
            double o = ray[axis];
            double d = ray[axis + 3];
            if (d == 0) {
                if (o < box[axis] || o > box[axis + 3]) {
                    return MISS;
                }
            } else {
                double one = (box[axis] - o) / d;
                double other = (box[axis + 3] - o) / d;
                near = Math.max(near, Math.min(one, other));
                far = Math.min(far, Math.max(one, other));
            }
        }
        return near <= far ? near : MISS;
    }

    /** {@return a random ray}: along an axis or not, from inside, a side, near or far away, past the boxes or towards one. */
    static double[] ray(Random random, double[][] boxes) {
        double[] box = boxes[random.nextInt(boxes.length)];
        double[] ray = new double[6];
        int kind = random.nextInt(8);
        double distance = kind == 0 ? 0 : kind == 1 ? Math.pow(10, 2 + random.nextInt(10)) : 10;
        for (int axis = 0; axis < 3; axis++) {
            double inside = box[axis] + (box[axis + 3] - box[axis]) * (random.nextInt(4) == 0 ? random.nextInt(2) : random.nextDouble());
            double from = distance * random.nextGaussian();
            boolean still = kind == 2 || random.nextInt(5) == 0;
            ray[axis] = kind == 0 || still ? inside : from;
            ray[axis + 3] = still ? random.nextBoolean() ? 0.0 : -0.0 : kind == 0 ? random.nextGaussian() : inside - from;
        }
        if (kind == 2 || ray[3] == 0 && ray[4] == 0 && ray[5] == 0) {
            int axis = random.nextInt(3);
            ray[axis] -= distance;
            ray[axis + 3] = 1;
        }
        if (kind == 3) {                                      // anywhere
            for (int axis = 3; axis < 6; axis++) {
                ray[axis] = random.nextGaussian();
            }
        }
        return ray;
    }

    /** {@return a ray in the same direction, of another length} */
    static double[] scaled(double[] ray, double by) {
        return new double[] {ray[0], ray[1], ray[2], ray[3] * by, ray[4] * by, ray[5] * by};
    }
}
