package simpleray.ui.picture;

import java.math.BigDecimal;
import java.math.RoundingMode;
import java.util.Arrays;
import simpleray.math.Point;
import simpleray.math.Ray;
import simpleray.math.Vector;
import simpleray.scene.Camera;
import simpleray.scene.ParallelCamera;
import simpleray.scene.ParallelCamera.View;
import simpleray.scene.PerspectiveCamera;
import simpleray.scene.PerspectiveCamera.Pose;
import simpleray.scene.SceneSettings;

/** Finds the shortest numbers for a camera. */
final class ShortView {
    /** How far what is seen may move, in pixels. */
    static final double MAX_SHIFT = 0.001;

    /** Where things are that must not move farther: shares of the distance to the look-at point. */
    private static final double[] DISTANCES = {0.1, 1, 1000};
    private static final double[] PARALLEL_DISTANCES = {0, 1, 10};
    private static final double[] PLACES = {0, 0.5, 1};       // shares of the picture's width and height
    private static final int COUNT = 7;
    private static final int MAX_DECIMALS = 17;

    private ShortView() {
    }

    /**
     * Returns the camera with the fewest decimals that shows what is at least a tenth as far away as the look-at point within
     * {@link #MAX_SHIFT} of where it is; of parallel rays, all that is up to ten times as far away.
     *
     * @param free settings with a camera or a parallel one
     * @param width the width of its picture in pixels
     * @param height the height of its picture in pixels
     * @return settings with the camera of rounded numbers alone, and what is up in its picture as it was
     */
    static SceneSettings of(SceneSettings free, int width, int height) {
        double[] exact = numbers(free);
        int[] decimals = new int[COUNT];
        int all = -1;
        do {
            all++;
            Arrays.fill(decimals, all);
        } while (all < MAX_DECIMALS && !isNear(free, rounded(exact, decimals), width, height));
        for (int i = 0; i < COUNT; i++) {
            while (decimals[i] > 0) {
                decimals[i]--;
                if (!isNear(free, rounded(exact, decimals), width, height)) {
                    decimals[i]++;
                    break;
                }
            }
        }
        double[] found = rounded(exact, decimals);
        return camera(free, isNear(free, found, width, height) ? found : exact);
    }

    private static double[] numbers(SceneSettings free) {
        Pose pose = free.camera;
        View view = free.parallel;
        return view == null ? new double[] {pose.ex(), pose.ey(), pose.ez(), pose.lx(), pose.ly(), pose.lz(), pose.fov()}
            : new double[] {view.ex(), view.ey(), view.ez(), view.lx(), view.ly(), view.lz(), view.height()};
    }

    /** {@return a camera of the same kind, and with the same up, with other numbers} */
    private static SceneSettings camera(SceneSettings free, double[] n) {
        SceneSettings settings = new SceneSettings();
        if (free.parallel == null) {
            settings.camera = new Pose(n[0], n[1], n[2], n[3], n[4], n[5], n[6]);
        } else {
            settings.parallel = new View(n[0], n[1], n[2], n[3], n[4], n[5], n[6]);
        }
        settings.up = free.up;
        return settings;
    }

    private static double[] rounded(double[] exact, int[] decimals) {
        double[] n = new double[COUNT];
        for (int i = 0; i < COUNT; i++) {
            n[i] = BigDecimal.valueOf(exact[i]).setScale(decimals[i], RoundingMode.HALF_EVEN).doubleValue();
        }
        return n;
    }

    private static boolean isNear(SceneSettings free, double[] n, int width, int height) {
        SceneSettings other = camera(free, n);
        boolean sound = other.parallel == null ? other.camera.fault() == null && !other.camera.isAlong(other.up)
            : other.parallel.fault() == null && !other.parallel.isAlong(other.up);
        return sound && shift(free, other, width, height) <= MAX_SHIFT;
    }

    /** {@return how far a point that one camera sees moves in the picture of the other, at most, in pixels; NaN if it is not seen} */
    static double shift(SceneSettings exact, SceneSettings other, int width, int height) {
        Camera one = camera(exact, width, height);
        Camera two = camera(other, width, height);
        double[] n = numbers(exact);
        double length = Vector.subtract(new Point(n[3], n[4], n[5]), new Point(n[0], n[1], n[2])).norm();
        double most = 0;
        for (double x : PLACES) {
            for (double y : PLACES) {
                Ray ray = one.through(x * width, y * height);
                for (double share : exact.parallel == null ? DISTANCES : PARALLEL_DISTANCES) {
                    Point seen = new Point(ray.origin);
                    seen.x += ray.direction.x * share * length;
                    seen.y += ray.direction.y * share * length;
                    seen.z += ray.direction.z * share * length;
                    double[] place = place(two, seen);
                    most = Math.max(most, StrictMath.hypot((place[0] - (x - 0.5)) * width, (place[1] - (0.5 - y)) * height));
                }
            }
        }
        return most;
    }

    private static Camera camera(SceneSettings free, int width, int height) {
        return free.parallel == null ? new PerspectiveCamera(free.camera, free.up, width, height)
            : new ParallelCamera(free.parallel, free.up, width, height);
    }

    /** {@return how far right and up of the middle of the picture a point is seen; 1 is the picture's width or height; NaN if it is not} */
    private static double[] place(Camera camera, Point p) {
        if (camera instanceof ParallelCamera parallel) {
            Vector apart = Vector.subtract(p, parallel.middle());
            return new double[] {across(apart, parallel.right(), 1), across(apart, parallel.up(), 1)};
        }
        PerspectiveCamera perspective = (PerspectiveCamera) camera;
        Vector towards = Vector.subtract(p, perspective.eye());
        double depth = towards.dot(perspective.forward());
        return new double[] {across(towards, perspective.right(), depth), across(towards, perspective.up(), depth)};
    }

    private static double across(Vector towards, Vector axis, double depth) {
        return depth > 0 ? towards.dot(axis) / (depth * axis.dot(axis)) : Double.NaN;
    }
}
