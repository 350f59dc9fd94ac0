package simpleray.scene;

import simpleray.math.Point;
import simpleray.math.Ray;

/**
 * The viewer: a centre of projection on the z axis and a viewport window on the XY plane (thesis, chapter 5).
 * <em>Mutable</em> while one thread sets it up; then any thread may ask for rays.
 *
 * <p>The defaults are a resolution of 200 × 200, the centre of projection at z = 2 and the window [-2,2] × [-2,2]. Setters may be
 * called in any order. Unless a window was set, the default one grows about its centre along the longer side of the picture, so
 * that pixels are square.
 */
public final class SimpleCamera implements Camera {
    /** The width and the height of the picture in pixels, unless set. */
    public static final int DEFAULT_RESOLUTION = 200;
    /** The z of the centre of projection, unless set. */
    public static final double DEFAULT_COP = 2;
    /** Half the side of the window, unless set. */
    private static final double DEFAULT_HALF = 2;

    private int width;
    private int height;
    private double cop;
    private boolean windowSet;
    private double xmin;
    private double xmax;
    private double ymin;
    private double ymax;

    /** Creates a camera with a resolution of 200 by 200. */
    public SimpleCamera() {
        initBasic(DEFAULT_RESOLUTION, DEFAULT_RESOLUTION);
    }

    /**
     * Creates a camera.
     *
     * @param a the width in pixels, 1 or more
     * @param b the height in pixels, 1 or more
     */
    public SimpleCamera(int a, int b) {
        initBasic(a, b);
    }

    /**
     * Sets a resolution, and everything else to the defaults.
     *
     * @param a the width in pixels, 1 or more
     * @param b the height in pixels, 1 or more
     */
    public void initBasic(int a, int b) {
        windowSet = false;
        setCOP(DEFAULT_COP);
        setResolution(a, b);
    }

    /**
     * Sets the centre of projection to (0, 0, cent).
     *
     * @param cent its z, above 0 and finite
     * @throws IllegalArgumentException if it is not
     */
    public void setCOP(double cent) {
        if (!(cent > 0 && cent < Double.POSITIVE_INFINITY)) {
            throw new IllegalArgumentException("the centre of projection must be above 0, and is " + cent);
        }
        cop = cent;
    }

    /**
     * Sets the number of rays to cast.
     *
     * @param x the width in pixels, 1 or more
     * @param y the height in pixels, 1 or more
     * @throws IllegalArgumentException if one is less
     */
    public void setResolution(int x, int y) {
        if (x < 1 || y < 1) {
            throw new IllegalArgumentException("the resolution must be 1x1 or more, and is " + x + 'x' + y);
        }
        width = x;
        height = y;
        if (!windowSet) {
            xmax = x > y ? DEFAULT_HALF * x / y : DEFAULT_HALF;
            ymax = y > x ? DEFAULT_HALF * y / x : DEFAULT_HALF;
            xmin = -xmax;
            ymin = -ymax;
        }
    }

    /**
     * Sets the viewport window on the XY plane. It is stretched over the picture.
     *
     * @param xmin the left edge
     * @param xmax the right edge, above xmin
     * @param ymin the lower edge
     * @param ymax the upper edge, above ymin
     * @throws IllegalArgumentException if the window is empty or not finite
     */
    public void setVPWindow(double xmin, double xmax, double ymin, double ymax) {
        if (!(xmin < xmax && ymin < ymax && Double.isFinite(xmax - xmin) && Double.isFinite(ymax - ymin))) {
            throw new IllegalArgumentException("the window must have xmin < xmax and ymin < ymax, and is "
                + xmin + ',' + xmax + ',' + ymin + ',' + ymax);
        }
        windowSet = true;
        this.xmin = xmin;
        this.xmax = xmax;
        this.ymin = ymin;
        this.ymax = ymax;
    }

    /**
     * Returns the ray through the centre of a pixel.
     *
     * @param x the column, 0 at the left
     * @param y the row, 0 at the top
     * @return a new ray from the centre of projection, of unit direction
     */
    public Ray ray(int x, int y) {
        return through(x + 0.5, y + 0.5);
    }

    @Override
    public void through(double px, double py, Ray ray) {
        double wx = xmin + px * (xmax - xmin) / width;
        double wy = ymax - py * (ymax - ymin) / height;
        ray.origin.set(0, 0, cop);
        ray.direction.set(wx, wy, -cop);
        ray.direction.normalise();
    }

    /** {@return the viewport window} */
    public SceneSettings.Window window() {
        return new SceneSettings.Window(xmin, xmax, ymin, ymax);
    }

    @Override
    public Point eye() {
        return new Point(0, 0, cop);
    }

    @Override
    public int width() {
        return width;
    }

    @Override
    public int height() {
        return height;
    }
}
