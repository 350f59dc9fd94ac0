package simpleray.ui.picture;

import java.math.BigDecimal;
import java.math.RoundingMode;
import java.util.Arrays;
import simpleray.math.Point;
import simpleray.math.Ray;
import simpleray.math.Vector;
import simpleray.scene.PerspectiveCamera;
import simpleray.scene.PerspectiveCamera.Pose;

/** Finds the shortest numbers for a camera. */
final class ShortView {
    /** How far what is seen may move, in pixels. */
    static final double MAX_SHIFT = 0.001;

    /** Where things are that must not move farther: shares of the distance to the look-at point. */
    private static final double[] DISTANCES = {0.1, 1, 1000};
    private static final double[] PLACES = {0, 0.5, 1};       // shares of the picture's width and height
    private static final int COUNT = 7;
    private static final int MAX_DECIMALS = 17;

    private ShortView() {
    }

    /**
     * Returns the camera with the fewest decimals that shows what is at least a tenth as far away as the look-at point within
     * {@link #MAX_SHIFT} of where it is.
     *
     * @param pose the camera
     * @param width the width of its picture in pixels
     * @param height the height of its picture in pixels
     * @return the camera with rounded numbers
     */
    static Pose of(Pose pose, int width, int height) {
        double[] exact = {pose.ex(), pose.ey(), pose.ez(), pose.lx(), pose.ly(), pose.lz(), pose.fov()};
        int[] decimals = new int[COUNT];
        int all = -1;
        do {
            all++;
            Arrays.fill(decimals, all);
        } while (all < MAX_DECIMALS && !isNear(pose, rounded(exact, decimals), width, height));
        for (int i = 0; i < COUNT; i++) {
            while (decimals[i] > 0) {
                decimals[i]--;
                if (!isNear(pose, rounded(exact, decimals), width, height)) {
                    decimals[i]++;
                    break;
                }
            }
        }
        Pose found = rounded(exact, decimals);
        return isNear(pose, found, width, height) ? found : pose;
    }

    private static Pose rounded(double[] exact, int[] decimals) {
        double[] n = new double[COUNT];
        for (int i = 0; i < COUNT; i++) {
            n[i] = BigDecimal.valueOf(exact[i]).setScale(decimals[i], RoundingMode.HALF_EVEN).doubleValue();
        }
        return new Pose(n[0], n[1], n[2], n[3], n[4], n[5], n[6]);
    }

    private static boolean isNear(Pose exact, Pose other, int width, int height) {
        return other.fault() == null && shift(exact, other, width, height) <= MAX_SHIFT;
    }

    /** {@return how far a point that one camera sees moves in the picture of the other, at most, in pixels; NaN if it is not seen} */
    static double shift(Pose exact, Pose other, int width, int height) {
        PerspectiveCamera one = new PerspectiveCamera(exact, width, height);
        PerspectiveCamera two = new PerspectiveCamera(other, width, height);
        double length = Vector.subtract(new Point(exact.lx(), exact.ly(), exact.lz()), one.eye()).norm();
        double most = 0;
        for (double x : PLACES) {
            for (double y : PLACES) {
                Ray ray = one.through(x * width, y * height);
                for (double share : DISTANCES) {
                    Point seen = new Point(one.eye());
                    seen.x += ray.direction.x * share * length;
                    seen.y += ray.direction.y * share * length;
                    seen.z += ray.direction.z * share * length;
                    most = Math.max(most, StrictMath.hypot(across(two, two.right(), seen) * width - (x - 0.5) * width,
                        across(two, two.up(), seen) * height - (0.5 - y) * height));
                }
            }
        }
        return most;
    }

    /** {@return how far a point is from the middle of the picture, along an axis; 1 is the picture's width or height} */
    private static double across(PerspectiveCamera camera, Vector axis, Point p) {
        Vector towards = Vector.subtract(p, camera.eye());
        double depth = towards.dot(camera.forward());
        return depth > 0 ? towards.dot(axis) / (depth * axis.dot(axis)) : Double.NaN;
    }
}
