package simpleray.scene;

import simpleray.scene.PerspectiveCamera.Pose;
import simpleray.scene.SceneSettings.Window;

/** Finds the free camera with the view of given settings. */
public final class FreeView {
    private static final double ROUNDING = 1e-9;
    private static final double WIDEST = 179.9;
    private static final int NEIGHBOURS = 8;

    private FreeView() {
    }

    /**
     * Returns the free camera for settings alone: their own, with what is up in its picture, or that of the same view.
     *
     * @param settings the settings, as {@link SceneSettings#newCamera} takes them
     * @return new settings with a camera or a parallel one, and nothing else but up
     */
    public static SceneSettings alone(SceneSettings settings) {
        SceneSettings free = new SceneSettings();
        if (settings.isFree()) {
            free.setCamera(settings);
        } else {
            free.camera = of(settings);
        }
        return free;
    }

    /**
     * Returns the perspective camera for settings, which must not have a parallel one.
     *
     * <p>The simple camera stands at (0, 0, cop) and sees a window on the plane z = 0. If the window's middle is (0, 0) and pixels are
     * square, the free camera at (0, 0, cop) that looks at (0, 0, 0) sees the same: half the window's height over cop is the tangent of
     * half its field of view. {@link PerspectiveCamera} computes in the simple camera's order, so that the rays are equal to the
     * last bit for the thesis's 90 degrees, and up to rounding for others. No free camera has its look-at point beside the middle of its
     * picture, or pixels that are not square; for such windows this one looks at the window's middle, and sees its height and width.
     *
     * @param settings the settings, as {@link SceneSettings#newCamera} takes them
     * @return the free camera
     */
    public static Pose of(SceneSettings settings) {
        if (settings.camera != null) {
            return settings.camera;
        }
        SimpleCamera camera = (SimpleCamera) settings.newCamera();
        Window w = camera.window();
        double cop = camera.eye().z;
        double mx = w.xmin() / 2 + w.xmax() / 2;
        double my = w.ymin() / 2 + w.ymax() / 2;
        double half = w.ymax() / 2 - w.ymin() / 2;
        if (!isSquare(camera)) {
            half = Math.max(half, (w.xmax() / 2 - w.xmin() / 2) * camera.height() / camera.width());
        }
        double distance = StrictMath.hypot(StrictMath.hypot(mx, my), cop);
        return new Pose(0, 0, cop, mx, my, 0, Math.min(WIDEST, fov(half, distance)));
    }

    /** {@return the field of view: of the nearest doubles, the one that gives this half height best} */
    private static double fov(double half, double distance) {
        double fov = StrictMath.toDegrees(2 * StrictMath.atan(half / distance));
        double best = fov;
        for (int i = -NEIGHBOURS; i <= NEIGHBOURS; i++) {
            double other = fov + i * Math.ulp(fov);
            if (Math.abs(PerspectiveCamera.halfHeight(distance, other) - half)
                < Math.abs(PerspectiveCamera.halfHeight(distance, best) - half)) {
                best = other;
            }
        }
        return best;
    }

    /**
     * Tests whether the free camera shows the same picture.
     *
     * @param settings the settings
     * @return false if its picture is only similar
     */
    public static boolean isExact(SceneSettings settings) {
        if (settings.isFree()) {
            return true;
        }
        SimpleCamera camera = (SimpleCamera) settings.newCamera();
        Window w = camera.window();
        return w.xmin() == -w.xmax() && w.ymin() == -w.ymax() && isSquare(camera);
    }

    private static boolean isSquare(SimpleCamera camera) {
        Window w = camera.window();
        double across = (w.xmax() - w.xmin()) / camera.width();
        double down = (w.ymax() - w.ymin()) / camera.height();
        return Math.abs(across - down) <= ROUNDING * down;
    }
}
