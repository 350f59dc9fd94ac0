package simpleray.render;

import simpleray.math.Colour;

/** Takes the mean of n × n points of a pixel, the centres of its sub-cells, each clamped; if n is 1, its centre, not clamped. */
final class GridSampler implements Sampler {
    private final Tracer tracer;
    private final int n;

    GridSampler(Tracer tracer, int n) {
        this.tracer = tracer;
        this.n = n;
    }

    @Override
    public double pixel(int x, int y, Colour colour) {
        if (n == 1) {
            return tracer.trace(x + 0.5, y + 0.5, colour) ? 1 : 0;
        }
        Colour sample = new Colour();
        colour.reset();
        int count = 0;
        for (int j = 0; j < n; j++) {
            for (int i = 0; i < n; i++) {
                count += tracer.trace(x + (i + 0.5) / n, y + (j + 0.5) / n, sample) ? 1 : 0;
                sample.clamp();
                colour.add(sample);                           // a point that does not count is black
            }
        }
        return Sampler.mean(colour, count, n * n);
    }

    @Override
    public double[] points(int x, int y) {
        double[] points = new double[2 * n * n];
        for (int j = 0, k = 0; j < n; j++) {
            for (int i = 0; i < n; i++) {
                points[k++] = x + (i + 0.5) / n;
                points[k++] = y + (j + 0.5) / n;
            }
        }
        return points;
    }
}
