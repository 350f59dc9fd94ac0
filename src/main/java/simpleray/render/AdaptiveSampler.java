package simpleray.render;

import java.util.concurrent.atomic.AtomicReferenceArray;
import java.util.stream.DoubleStream;
import simpleray.math.Colour;

/**
 * Four by four points where a pixel shows an edge, one elsewhere (Whitted 1980: more rays where their colours differ). Each pixel has
 * first one of its sixteen points traced; where that differs from one of the eight neighbours' by more than a few levels, the other fifteen
 * are too. Whether they do depends on the scene alone, so that the picture does not depend on the order of rows.
 */
final class AdaptiveSampler implements Sampler {
    private static final int SIDE = 4;
    /** A difference of a component that two neighbours may have without being taken for an edge. */
    private static final double SAME = 24.0 / 255;
    /** First points are kept of so many rows, which is more than threads that go side by side look at. Others are found again. */
    private static final int ROWS = 8;
    private static final int ROWS_A_THREAD = 2;
    private static final int NONE = -1;

    private final Tracer tracer;
    private final int left;                                   // the columns whose first points are found
    private final int right;
    private final int height;
    private final AtomicReferenceArray<Row> first;            // shared with all other threads; null if all are found already
    private final double[][] found;
    private final double[][] near = new double[3][];          // the first points of the row asked for last, between its neighbours'
    private int asked = NONE;

    /** The colours of the first points of a row. */
    record Row(int y, double[] rgb) {
    }

    /**
     * Makes what the samplers of all threads share.
     *
     * @param height the picture's height
     * @param threads how many threads there are
     * @return places for rows of first points, each at its number modulo how many there are
     */
    static AtomicReferenceArray<Row> rows(int height, int threads) {
        return new AtomicReferenceArray<>(Math.min(height, ROWS_A_THREAD * threads + ROWS));
    }

    /** Makes a sampler for a region of a picture, which looks at the region's neighbours, too. */
    AdaptiveSampler(Tracer tracer, int width, int height, Region region, AtomicReferenceArray<Row> first) {
        this(tracer, region.grown(width, height), height, first, null);
    }

    /** Makes a sampler for what all {@linkplain #first first points} were found of already, row by row. */
    AdaptiveSampler(Tracer tracer, int width, int height, double[][] found) {
        this(tracer, Region.whole(width, height), height, null, found);
    }

    private AdaptiveSampler(Tracer tracer, Region area, int height, AtomicReferenceArray<Row> first, double[][] found) {
        this.tracer = tracer;
        left = area.x();
        right = area.right();
        this.height = height;
        this.first = first;
        this.found = found;
    }

    @Override
    public void pixel(int x, int y, Colour colour) {
        if (y != asked) {
            for (int i = 0; i < near.length; i++) {
                near[i] = firsts(y - 1 + i);
            }
            asked = y;
        }
        double[] own = near[1];
        int at = 3 * (x - left);
        colour.r = own[at];
        colour.g = own[at + 1];
        colour.b = own[at + 2];
        if (!isEdge(x)) {
            return;
        }
        Colour sample = new Colour();
        for (int j = 0; j < SIDE; j++) {
            for (int i = 0; i < SIDE; i++) {
                if (i != firstColumn(x, y) || j != firstRow(y)) {
                    trace(x, y, i, j, sample);
                    colour.add(sample);
                }
            }
        }
        colour.scale(1.0 / (SIDE * SIDE));
    }

    @Override
    public double[] points(int x, int y) {
        for (int i = 0; i < near.length; i++) {               // rows of which only three pixels are asked for
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
                for (int c = 0; c < 3; c++) {
                    if (Math.abs(row[3 * (nx - left) + c] - near[1][3 * (x - left) + c]) > SAME) {
                        return true;
                    }
                }
            }
        }
        return false;
    }

    /** {@return the first points of a row; null above and below the picture} Two threads may find the same at once, and alike. */
    private double[] firsts(int y) {
        if (y < 0 || y >= height) {
            return null;
        }
        if (found != null) {
            return found[y];
        }
        Row there = first.get(y % first.length());
        if (there != null && there.y == y) {
            return there.rgb;
        }
        double[] rgb = firsts(y, left, right);
        first.set(y % first.length(), new Row(y, rgb));
        return rgb;
    }

    /** {@return a row with the first points from one column to before another; null above and below the picture} */
    private double[] firsts(int y, int from, int end) {
        if (y < 0 || y >= height) {
            return null;
        }
        double[] rgb = new double[3 * (right - left)];
        Colour sample = new Colour();
        for (int x = from, i = 3 * (from - left); x < end; x++, i += 3) {
            first(x, y, sample);
            rgb[i] = sample.r;
            rgb[i + 1] = sample.g;
            rgb[i + 2] = sample.b;
        }
        return rgb;
    }

    /** Finds the colour at a pixel's first point. */
    void first(int x, int y, Colour sample) {
        trace(x, y, firstColumn(x, y), firstRow(y), sample);
    }

    private void trace(int x, int y, int i, int j, Colour sample) {
        tracer.trace(x + (i + 0.5) / SIDE, y + (j + 0.5) / SIDE, sample);
        sample.clamp();
    }

    /** One of the four points around the pixel's centre, another for each pixel of a block of four. */
    private static int firstColumn(int x, int y) {
        return 1 + (x + y & 1);
    }

    private static int firstRow(int y) {
        return 1 + (y & 1);
    }
}
