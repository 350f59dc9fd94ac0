package simpleray.scene;

import simpleray.math.Point;
import simpleray.math.Ray;
import simpleray.math.Vector;

/** A camera at any point with any direction. <em>Constant.</em> */
public final class PerspectiveCamera implements Camera {
    private static final double HALF_TURN = 180;
    private static final double FAR = 1e100;

    private final Point eye;
    private final int width;
    private final int height;
    private final Vector forward;                             // from the eye to the middle of the window
    private final Vector right;
    private final Vector up;
    private final double halfWidth;                           // of the window, which is at the look-at point
    private final double halfHeight;

    /**
     * Creates a camera for which up is +y, or -z if the view is along y.
     *
     * @param pose its eye, look-at point and field of view
     * @param width the width in pixels, 1 or more
     * @param height the height in pixels, 1 or more
     */
    public PerspectiveCamera(Pose pose, int width, int height) {
        this(pose, null, width, height);
    }

    /**
     * Creates a camera. Pixels are square: the horizontal field of view follows from the vertical one.
     *
     * @param pose its eye, look-at point and field of view
     * @param up what is up in the picture, of any length, not {@link Pose#isAlong along the view}; null for +y, or -z if the view is along y
     * @param width the width in pixels, 1 or more
     * @param height the height in pixels, 1 or more
     */
    public PerspectiveCamera(Pose pose, Vector up, int width, int height) {
        this.width = width;
        this.height = height;
        eye = pose.eye();
        ViewAxes axes = ViewAxes.of(eye, pose.lookAt(), up);
        forward = axes.forward();
        right = axes.right();
        this.up = axes.up();
        double distance = pose.distance();
        double scale = distance > 1 / FAR && distance < FAR ? distance : 1;
        forward.scale(scale);
        halfHeight = halfHeight(scale, pose.fov());
        halfWidth = halfHeight * width / height;
    }

    /**
     * {@return half the height of the view at a distance} The tangent of the half angle is computed so that it is exactly 1 for 90 degrees,
     * unlike the tangent of a rounded quarter of pi.
     */
    static double halfHeight(double distance, double fov) {
        double angle = StrictMath.toRadians(fov);
        double sin = StrictMath.sin(angle);
        double cos = StrictMath.cos(angle);
        return distance * (cos >= 0 ? sin / (1 + cos) : (1 - cos) / sin);
    }

    /**
     * The eye, the look-at point and the field of view of a camera. <em>Constant.</em>
     *
     * @param ex x of the eye
     * @param ey y of the eye
     * @param ez z of the eye
     * @param lx x of the point it looks at, which is not the eye
     * @param ly y of the point it looks at
     * @param lz z of the point it looks at
     * @param fov the vertical field of view in degrees, above 0 and below 180
     */
    public record Pose(double ex, double ey, double ez, double lx, double ly, double lz, double fov) {
        /** The range of a field of view, for messages. */
        static final String FOV = "field of view above 0 and below 180 degrees";
        /** The condition on a look-at point, for messages. */
        static final String LOOK_AT = "look-at point other than the eye";

        /** {@return the fault of the pose; null if there is none} */
        public String fault() {
            if (!(fov > 0 && fov < HALF_TURN)) {
                return FOV;
            }
            return ex == lx && ey == ly && ez == lz ? LOOK_AT : null;
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

        /** {@return the distance from the eye to the look-at point} */
        double distance() {
            return StrictMath.hypot(StrictMath.hypot(lx - ex, ly - ey), lz - ez);
        }
    }

    /** {@return a new vector of unit length, from the eye to the middle of the picture} */
    public Vector forward() {
        return Vector.scale(forward, 1 / forward.norm());
    }

    /** {@return a new vector from the left edge of the picture to the right one, where it is 1 from the eye} */
    public Vector right() {
        return Vector.scale(right, 2 * halfWidth * (1 / forward.norm()));
    }

    /** {@return a new vector from the lower edge of the picture to the upper one, where it is 1 from the eye} */
    public Vector up() {
        return Vector.scale(up, 2 * halfHeight * (1 / forward.norm()));
    }

    @Override
    public Point eye() {
        return new Point(eye);
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
        // in the order of SimpleCamera: looking along -z from the z axis gives the same rays, bit for bit
        double x = -halfWidth + px * (2 * halfWidth) / width;
        double y = halfHeight - py * (2 * halfHeight) / height;
        ray.origin.copy(eye);
        ray.direction.set(right.x * x + up.x * y + forward.x, right.y * x + up.y * y + forward.y, right.z * x + up.z * y + forward.z);
        ray.direction.normalise();
    }
}
