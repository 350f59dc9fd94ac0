package simpleray.scene;

import java.io.IOException;
import simpleray.math.Point;
import simpleray.math.Ray;
import simpleray.math.Vector;
import simpleray.text.SceneWriter;

/** A viewer that stands anywhere and looks anywhere. <em>Constant.</em> Up is +y, or -z if the view is along y. */
public final class PerspectiveCamera implements Camera {
    private static final double FULL_TURN = 360;

    private final Point eye;
    private final int width;
    private final int height;
    private final Vector forward;
    private final Vector right;
    private final Vector down;

    /**
     * Creates a camera. Pixels are square: the horizontal field of view follows from the vertical one.
     *
     * @param pose where it stands, where to it looks, and how wide
     * @param width the width in pixels, 1 or more
     * @param height the height in pixels, 1 or more
     */
    public PerspectiveCamera(Pose pose, int width, int height) {
        this.width = width;
        this.height = height;
        eye = new Point(pose.ex(), pose.ey(), pose.ez());
        // halves, lest a difference overflow
        forward = new Vector(pose.lx() / 2 - pose.ex() / 2, pose.ly() / 2 - pose.ey() / 2, pose.lz() / 2 - pose.ez() / 2);
        forward.normalise();
        boolean alongY = forward.x == 0 && forward.z == 0;
        right = Vector.cross(forward, alongY ? new Vector(0, 0, -1) : new Vector(0, 1, 0));
        right.normalise();
        down = Vector.cross(forward, right);
        double pixel = 2 * StrictMath.tan(pose.fov() * StrictMath.PI / FULL_TURN) / height;   // at distance 1 of the eye
        right.scale(pixel);
        down.scale(pixel);
    }

    /**
     * Where a camera stands, where to it looks, and how wide. <em>Constant.</em>
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
        /** What a good field of view is. */
        static final String FOV = "field of view above 0 and below 180 degrees";
        /** What a good look-at point is. */
        static final String LOOK_AT = "look-at point other than the eye";

        /** {@return what is wrong with the pose; null if nothing is} */
        public String fault() {
            if (!(fov > 0 && fov < FULL_TURN / 2)) {
                return FOV;
            }
            return ex == lx && ey == ly && ez == lz ? LOOK_AT : null;
        }
    }

    @Override
    public void writePov(SceneWriter os) throws IOException {
        Pov.camera(os, eye, forward, Vector.scale(right, width), Vector.scale(down, -height));
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
    public Ray through(double px, double py) {
        Vector direction = Vector.scale(right, px - width / 2.0);
        direction.add(Vector.scale(down, py - height / 2.0));
        direction.add(forward);
        direction.normalise();
        return new Ray(new Point(eye), direction);
    }
}
