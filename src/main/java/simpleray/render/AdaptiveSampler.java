package simpleray.render;

import java.util.concurrent.atomic.AtomicReferenceArray;
import java.util.stream.DoubleStream;
import simpleray.image.Picture;
import simpleray.math.Colour;

/**
 * Samples four by four points of a pixel at an edge, and one of others (Whitted 1980: more rays where colours differ). First one of a pixel's
 * sixteen points is traced; if its colour differs from that of one of the eight neighbours by more than a few levels, or one of the two is
 * transparent, the other fifteen are traced, too. This depends on the scene alone, so the picture does not depend on the order of rows.
 */
final class AdaptiveSampler implements Sampler {
    private static final int SIDE = 4;
    /** The largest difference of a component between two neighbours that does not count as an edge. */
    private static final double SAME = 24.0 / 255;
    /** The number of rows whose first points are kept: more than threads that work side by side need. Others are traced again. */
    private static final int ROWS = 8;
    private static final int ROWS_PER_THREAD = 2;
    private static final int NONE = -1;

    private final Tracer tracer;
    private final int left;                                   // the columns whose first points are traced
    private final int right;
    private final int height;
    private final int channels;                               // of a first point
    private final AtomicReferenceArray<Row> first;            // shared by all threads; null if all are traced already
    private final double[][] found;
    private final double[][] near = new double[3][];          // the first points of the current row, between its neighbours'
    private int asked = NONE;

    /** The colours of the first points of a row, and their alpha if the picture has any. */
    record Row(int y, double[] light) {
    }

    /**
     * Creates the store of first points that the samplers of all threads share.
     *
     * @param height the picture's height
     * @param threads the number of threads
     * @return an empty store, in which a row's place is its number modulo the length
     */
    static AtomicReferenceArray<Row> rows(int height, int threads) {
        return new AtomicReferenceArray<>(Math.min(height, ROWS_PER_THREAD * threads + ROWS));
    }

    /** Creates a sampler for a region of a picture and the pixels around it. */
    AdaptiveSampler(Tracer tracer, int width, int height, int channels, Region region, AtomicReferenceArray<Row> first) {
        this(tracer, region.grown(width, height), height, channels, first, null);
    }

    /** Creates a sampler for a picture whose {@linkplain #first first points} are all traced already. The last argument has their rows. */
    AdaptiveSampler(Tracer tracer, int width, int height, int channels, double[][] found) {
        this(tracer, Region.whole(width, height), height, channels, null, found);
    }

    private AdaptiveSampler(Tracer tracer, Region area, int height, int channels, AtomicReferenceArray<Row> first, double[][] found) {
        this.tracer = tracer;
        left = area.x();
        right = area.right();
        this.height = height;
        this.channels = channels;
        this.first = first;
        this.found = found;
    }

    @Override
    public double pixel(int x, int y, Colour colour) {
        if (y != asked) {
            for (int i = 0; i < near.length; i++) {
                near[i] = firsts(y - 1 + i);
            }
            asked = y;
        }
        double[] own = near[1];
        int at = channels * (x - left);
        colour.r = own[at];
        colour.g = own[at + 1];
        colour.b = own[at + 2];
        int count = channels == Picture.RGBA ? (int) own[at + Picture.RGB] : 1;
        if (!isEdge(x)) {
            return count;
        }
        Colour sample = new Colour();
        for (int j = 0; j < SIDE; j++) {
            for (int i = 0; i < SIDE; i++) {
                if (i != firstColumn(x, y) || j != firstRow(y)) {
                    count += trace(x, y, i, j, sample) ? 1 : 0;
                    colour.add(sample);
                }
            }
        }
        return Sampler.mean(colour, count, SIDE * SIDE);
    }

    @Override
    public double[] points(int x, int y) {
        for (int i = 0; i < near.length; i++) {               // rows of which only three pixels are needed
            near[i] = firsts(y - 1 + i, Math.max(left, x - 1), Math.min(right, x + 2));
        }
        asked = NONE;
        DoubleStream.Builder points = DoubleStream.builder();
        add(points, x, y, firstColumn(x, y), firstRow(y));
        for (int j = 0; j < SIDE && isEdge(x); j++) {
            for (int i = 0; i < SIDE; i++) {
                if (i != firstColumn(x, y) || j != firstRow(y)) {
                    add(points, x, y, i, j);
                }
            }
        }
        return points.build().toArray();
    }

    private static void add(DoubleStream.Builder points, int x, int y, int i, int j) {
        points.add(x + (i + 0.5) / SIDE);
        points.add(y + (j + 0.5) / SIDE);
    }

    private boolean isEdge(int x) {
        for (double[] row : near) {
            for (int nx = Math.max(left, x - 1); row != null && nx <= Math.min(right - 1, x + 1); nx++) {
                for (int c = 0; c < channels; c++) {
                    if (Math.abs(row[channels * (nx - left) + c] - near[1][channels * (x - left) + c]) > SAME) {
                        return true;
                    }
                }
            }
        }
        return false;
    }

    /** {@return the first points of a row; null above and below the picture} Two threads may trace the same row, with the same result. */
    private double[] firsts(int y) {
        if (y < 0 || y >= height) {
            return null;
        }
        if (found != null) {
            return found[y];
        }
        Row there = first.get(y % first.length());
        if (there != null && there.y == y) {
            return there.light;
        }
        double[] light = firsts(y, left, right);
        first.set(y % first.length(), new Row(y, light));
        return light;
    }

    /** {@return a row with the first points from one column to before another; null above and below the picture} */
    private double[] firsts(int y, int from, int end) {
        if (y < 0 || y >= height) {
            return null;
        }
        double[] light = new double[channels * (right - left)];
        Colour sample = new Colour();
        for (int x = from; x < end; x++) {
            Sampler.store(sample, first(x, y, sample), light, channels * (x - left), channels);
        }
        return light;
    }

    /** Traces a pixel's first point. {@return its alpha} */
    double first(int x, int y, Colour sample) {
        return trace(x, y, firstColumn(x, y), firstRow(y), sample) ? 1 : 0;
    }

    private boolean trace(int x, int y, int i, int j, Colour sample) {
        boolean counts = tracer.trace(x + (i + 0.5) / SIDE, y + (j + 0.5) / SIDE, sample);
        sample.clamp();
        return counts;
    }

    /** Chooses one of the four points around the pixel's centre, a different one for each pixel of a block of four. */
    private static int firstColumn(int x, int y) {
        return 1 + (x + y & 1);
    }

    private static int firstRow(int y) {
        return 1 + (y & 1);
    }
}
