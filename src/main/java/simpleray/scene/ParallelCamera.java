package simpleray.scene;

import simpleray.math.Point;
import simpleray.math.Ray;
import simpleray.math.Vector;

/**
 * A camera of parallel rays, which shows things in one size whatever their distance. <em>Constant.</em> Its rays start in the plane through
 * the eye at right angles to the view.
 */
public final class ParallelCamera implements Camera {
    private final Point eye;
    private final int width;
    private final int height;
    private final ViewAxes axes;
    private final double halfWidth;                           // of the picture in scene units
    private final double halfHeight;

    /**
     * Creates a camera. Pixels are square: the width of the view follows from its height.
     *
     * @param view its eye, look-at point and height
     * @param up what is up in the picture, of any length, not {@link View#isAlong along the view}; null for +y, or -z if the view is along y
     * @param width the width in pixels, 1 or more
     * @param height the height in pixels, 1 or more
     */
    public ParallelCamera(View view, Vector up, int width, int height) {
        this.width = width;
        this.height = height;
        eye = view.eye();
        axes = ViewAxes.of(eye, view.lookAt(), up);
        halfHeight = view.height() / 2;
        halfWidth = halfHeight * width / height;
    }

    /**
     * The eye, the look-at point and the height of a camera. <em>Constant.</em>
     *
     * @param ex x of the eye
     * @param ey y of the eye
     * @param ez z of the eye
     * @param lx x of the point it looks at, which is not the eye
     * @param ly y of the point it looks at
     * @param lz z of the point it looks at
     * @param height the scene units from the bottom of the picture to its top, above 0 and up to 1e100
     */
    public record View(double ex, double ey, double ez, double lx, double ly, double lz, double height) {
        /** The range of a height, for messages. */
        static final String HEIGHT = "height above 0 and up to 1e100";
        private static final double MAX_HEIGHT = 1e100;

        /** {@return the fault of the view; null if there is none} */
        public String fault() {
            if (!(height > 0 && height <= MAX_HEIGHT)) {
                return HEIGHT;
            }
            return ex == lx && ey == ly && ez == lz ? PerspectiveCamera.Pose.LOOK_AT : null;
        }

        /**
         * Tests whether a vector is along the view, so that it cannot be up.
         *
         * @param vector the vector; null for the default, which never is
         * @return whether it is, or points the other way, up to rounding
         */
        public boolean isAlong(Vector vector) {
            return vector != null && ViewAxes.isAlong(eye(), lookAt(), vector);
        }

        Point eye() {
            return new Point(ex, ey, ez);
        }

        Point lookAt() {
            return new Point(lx, ly, lz);
        }
    }

    /** {@return a new point, the eye: in the middle of where the rays start} */
    public Point middle() {
        return new Point(eye);
    }

    /** {@return a new vector of unit length, the direction of all rays} */
    public Vector forward() {
        return new Vector(axes.forward());
    }

    /** {@return a new vector from the left edge of the picture to the right one} */
    public Vector right() {
        return Vector.scale(axes.right(), 2 * halfWidth);
    }

    /** {@return a new vector from the lower edge of the picture to the upper one} */
    public Vector up() {
        return Vector.scale(axes.up(), 2 * halfHeight);
    }

    @Override
    public Point eye() {
        return null;
    }

    @Override
    public int width() {
        return width;
    }

    @Override
    public int height() {
        return height;
    }

    @Override
    public void through(double px, double py, Ray ray) {
        double x = -halfWidth + px * (2 * halfWidth) / width;
        double y = halfHeight - py * (2 * halfHeight) / height;
        Vector right = axes.right();
        Vector up = axes.up();
        ray.origin.set(eye.x + (right.x * x + up.x * y), eye.y + (right.y * x + up.y * y), eye.z + (right.z * x + up.z * y));
        ray.direction.copy(axes.forward());
    }
}
