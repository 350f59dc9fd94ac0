package simpleray.render;

import java.util.concurrent.atomic.AtomicReferenceArray;
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

    private final Tracer tracer;
    private final int width;
    private final int height;
    private final AtomicReferenceArray<double[]> first;       // rows of first points; found twice at worst, and alike

    AdaptiveSampler(Tracer tracer, int width, int height) {
        this.tracer = tracer;
        this.width = width;
        this.height = height;
        first = new AtomicReferenceArray<>(height);
    }

    @Override
    public void pixel(int x, int y, Colour colour) {
        double[] own = firsts(y);
        colour.copy(new Colour(own[3 * x], own[3 * x + 1], own[3 * x + 2]));
        if (!isEdge(x, y)) {
            return;
        }
        Colour sample = new Colour();
        for (int j = 0; j < SIDE; j++) {
            for (int i = 0; i < SIDE; i++) {
                if (i != firstColumn(x, y) || j != firstRow(x, y)) {
                    trace(x, y, i, j, sample);
                    colour.add(sample);
                }
            }
        }
        colour.scale(1.0 / (SIDE * SIDE));
    }

    private boolean isEdge(int x, int y) {
        double[] own = firsts(y);
        for (int ny = Math.max(0, y - 1); ny <= Math.min(height - 1, y + 1); ny++) {
            double[] row = firsts(ny);
            for (int nx = Math.max(0, x - 1); nx <= Math.min(width - 1, x + 1); nx++) {
                for (int c = 0; c < 3; c++) {
                    if (Math.abs(row[3 * nx + c] - own[3 * x + c]) > SAME) {
                        return true;
                    }
                }
            }
        }
        return false;
    }

    private double[] firsts(int y) {
        double[] row = first.get(y);
        if (row == null) {
            row = new double[3 * width];
            Colour sample = new Colour();
            for (int x = 0; x < width; x++) {
                trace(x, y, firstColumn(x, y), firstRow(x, y), sample);
                row[3 * x] = sample.r;
                row[3 * x + 1] = sample.g;
                row[3 * x + 2] = sample.b;
            }
            first.set(y, row);
        }
        return row;
    }

    private void trace(int x, int y, int i, int j, Colour sample) {
        tracer.trace(x + (i + 0.5) / SIDE, y + (j + 0.5) / SIDE, sample);
        sample.clamp();
    }

    /** One of the four points around the pixel's centre, another for each pixel of a block of four. */
    private static int firstColumn(int x, int y) {
        return 1 + (x + y & 1);
    }

    private static int firstRow(int x, int y) {
        return 1 + (y & 1);
    }
}
