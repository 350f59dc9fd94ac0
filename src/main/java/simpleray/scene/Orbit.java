package simpleray.scene;

import simpleray.math.Ray;
import simpleray.scene.PerspectiveCamera.Pose;

/**
 * A free camera by its position relative to its look-at point, the pivot, in the terms of moving it. <em>Constant.</em>
 *
 * <p>The eye lies at pivot + distance (sin yaw cos pitch, sin pitch, cos yaw cos pitch). The poles are never crossed, so that up
 * stays up: a turned camera keeps {@link #NEAREST_POLE} away from them. A scene's camera may look straight down or up
 * until it is turned.
 *
 * @param x x of the pivot
 * @param y y of the pivot
 * @param z z of the pivot
 * @param yaw degrees round the y axis, from +z (0) towards +x (90), -180 to 180
 * @param pitch degrees above the pivot, -90 to 90
 * @param distance the distance from the pivot to the eye, above 0
 * @param fov the vertical field of view in degrees
 */
public record Orbit(double x, double y, double z, double yaw, double pitch, double distance, double fov) {
    /** The least angle of a turned camera from straight down or up, in degrees. */
    public static final double NEAREST_POLE = 0.1;

    private static final double POLE = 90;
    private static final double FULL_TURN = 360;
    /** The least distance after a dolly, in scene units; rays do not hit objects that are much nearer. */
    private static final double NEAREST = 1e-6;
    /** The least distance as a share of the coordinates, so that the eye's differ from the pivot's. */
    private static final double NEAREST_SHARE = 1e-9;
    /** The largest factor by which a new pivot may be nearer or farther than the old one. */
    private static final double SOUND = 1000;

    /**
     * Returns the orbit of a camera round its look-at point.
     *
     * @param pose the camera, without {@link Pose#fault fault}
     * @return the same camera
     */
    public static Orbit of(Pose pose) {
        double dx = pose.ex() - pose.lx();
        double dy = pose.ey() - pose.ly();
        double dz = pose.ez() - pose.lz();
        double across = StrictMath.hypot(dx, dz);
        // straight down or up, the camera has -z as its up: it is in front of that, or behind it
        double yaw = across > 0 ? StrictMath.toDegrees(StrictMath.atan2(dx, dz)) : dy > 0 ? 0 : FULL_TURN / 2;
        double pitch = across > 0 ? StrictMath.toDegrees(StrictMath.atan2(dy, across)) : Math.copySign(POLE, dy);
        return new Orbit(pose.lx(), pose.ly(), pose.lz(), yaw, pitch, StrictMath.hypot(across, dy), pose.fov());
    }

    /** {@return the same camera by its eye and its look-at point} */
    public Pose pose() {
        return new Pose(x + distance * sin(yaw) * cos(pitch), y + distance * sin(pitch), z + distance * cos(yaw) * cos(pitch),
            x, y, z, fov);
    }

    /**
     * Turns the camera round its pivot.
     *
     * @param right degrees to its right
     * @param up degrees up, limited by the poles
     * @return the turned camera
     */
    public Orbit turned(double right, double up) {
        double limit = POLE - NEAREST_POLE;
        return sound(x, y, z, Math.IEEEremainder(yaw + right, FULL_TURN), Math.max(-limit, Math.min(limit, pitch + up)), distance);
    }

    /**
     * Moves the camera and its pivot sideways.
     *
     * @param right the distance to its right, in heights of the picture at the pivot's distance
     * @param up the distance to its top, likewise
     * @return the moved camera
     */
    public Orbit panned(double right, double up) {
        double height = 2 * distance * StrictMath.tan(StrictMath.toRadians(fov) / 2);
        double r = right * height;
        double u = up * height;
        return sound(x + r * cos(yaw) - u * sin(yaw) * sin(pitch), y + u * cos(pitch), z - r * sin(yaw) - u * cos(yaw) * sin(pitch),
            yaw, pitch, distance);
    }

    /**
     * Moves the camera towards its pivot, which it never reaches, or away from it.
     *
     * @param factor the factor of the distance, above 0
     * @return the moved camera
     */
    public Orbit dollied(double factor) {
        double least = Math.max(NEAREST, NEAREST_SHARE * Math.max(Math.abs(x), Math.max(Math.abs(y), Math.abs(z))));
        return sound(x, y, z, yaw, pitch, Math.max(distance * factor, Math.min(distance, least)));
    }

    /**
     * Moves the pivot to the point in the middle of the picture. The picture does not change.
     *
     * @param scene the scene
     * @return the same camera with that pivot; this one if the middle shows no object, or one that is much too near or too far
     */
    public Orbit aimed(Scene scene) {
        Ray ray = new PerspectiveCamera(pose(), 1, 1).through(0.5, 0.5);
        double nearest = Double.POSITIVE_INFINITY;
        for (int i = 0; i < scene.getNumberObjects(); i++) {
            double t = scene.getObject(i).intersect(ray);
            nearest = t >= 0 ? Math.min(nearest, t) : nearest;
        }
        double ahead = distance - nearest;                    // from the new pivot to the old one
        return nearest > distance / SOUND && nearest < distance * SOUND ? sound(x + ahead * sin(yaw) * cos(pitch),
            y + ahead * sin(pitch), z + ahead * cos(yaw) * cos(pitch), yaw, pitch, nearest) : this;
    }

    /** {@return the camera with these values; this one if its pose would not be finite} */
    private Orbit sound(double newX, double newY, double newZ, double newYaw, double newPitch, double newDistance) {
        Orbit other = new Orbit(newX, newY, newZ, newYaw, newPitch, newDistance, fov);
        Pose pose = other.pose();
        boolean finite = Double.isFinite(pose.ex() + pose.ey() + pose.ez()) && Double.isFinite(newX + newY + newZ);
        return finite && pose.fault() == null ? other : this;
    }

    private static double sin(double degrees) {
        return StrictMath.sin(StrictMath.toRadians(degrees));
    }

    /** {@return the cosine, exactly 0 at a pole, since only there the view is along y} */
    private static double cos(double degrees) {
        return Math.abs(degrees) == POLE ? 0 : StrictMath.cos(StrictMath.toRadians(degrees));
    }
}
