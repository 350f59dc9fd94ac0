package simpleray.scene;

import simpleray.math.Point;
import simpleray.math.Ray;
import simpleray.math.Vector;
import simpleray.scene.ParallelCamera.View;
import simpleray.scene.PerspectiveCamera.Pose;

/**
 * A free camera by its position relative to its look-at point, the pivot, in the terms of moving it. <em>Constant.</em>
 *
 * <p>The eye lies at pivot + distance (sin yaw cos pitch, sin pitch, cos yaw cos pitch), if y is up; else these are turned as y is to up.
 * The poles are never crossed, so that up stays up: a turned camera keeps {@link #NEAREST_POLE} away from them. A scene's
 * camera may look straight down or up until it is turned.
 *
 * @param x x of the pivot
 * @param y y of the pivot
 * @param z z of the pivot
 * @param yaw degrees round up: if y is up, from +z (0) towards +x (90), -180 to 180
 * @param pitch degrees above the pivot, -90 to 90
 * @param distance the distance from the pivot to the eye, above 0
 * @param fov the vertical field of view in degrees; 0 if rays are parallel
 * @param height the scene units from the bottom of the picture to its top if rays are parallel; else 0
 * @param up what is up in the picture, not to be changed; null for y
 */
public record Orbit(double x, double y, double z, double yaw, double pitch, double distance, double fov, double height, Vector up) {
    /** The least angle of a turned camera from straight down or up, in degrees. */
    public static final double NEAREST_POLE = 0.1;

    private static final double POLE = 90;
    /** The largest z of a unit vector that stands for y, for which z can stand for itself, as far as it is at right angles. */
    private static final double SLANTED = 0.9;
    private static final double FULL_TURN = 360;
    /** The least distance after a dolly, in scene units; rays do not hit objects that are much nearer. */
    private static final double NEAREST = 1e-6;
    /** The least distance as a share of the coordinates, so that the eye's differ from the pivot's. */
    private static final double NEAREST_SHARE = 1e-9;
    /** The largest factor by which a new pivot may be nearer or farther than the old one. */
    private static final double SOUND = 1000;

    /**
     * Creates the orbit of a perspective camera that has y up.
     *
     * @param x x of the pivot
     * @param y y of the pivot
     * @param z z of the pivot
     * @param yaw degrees round the y axis, from +z (0) towards +x (90), -180 to 180
     * @param pitch degrees above the pivot, -90 to 90
     * @param distance the distance from the pivot to the eye, above 0
     * @param fov the vertical field of view in degrees
     */
    public Orbit(double x, double y, double z, double yaw, double pitch, double distance, double fov) {
        this(x, y, z, yaw, pitch, distance, fov, 0, null);
    }

    /**
     * Returns the orbit of a perspective camera that has y up round its look-at point.
     *
     * @param pose the camera, without {@link Pose#fault fault}
     * @return the same camera
     */
    public static Orbit of(Pose pose) {
        SceneSettings settings = new SceneSettings();
        settings.camera = pose;
        return of(settings);
    }

    /**
     * Returns the orbit of a camera round its look-at point.
     *
     * @param free settings with a camera or a parallel one, as {@link FreeView#alone} makes them
     * @return the same camera
     */
    public static Orbit of(SceneSettings free) {
        View view = free.parallel;
        Pose pose = view == null ? free.camera : new Pose(view.ex(), view.ey(), view.ez(), view.lx(), view.ly(), view.lz(), 0);
        Vector back = new Vector(pose.ex() - pose.lx(), pose.ey() - pose.ly(), pose.ez() - pose.lz());
        if (free.up != null) {
            Vector[] axes = axes(free.up);
            back.set(back.dot(axes[0]), back.dot(axes[1]), back.dot(axes[2]));
        }
        double across = StrictMath.hypot(back.x, back.z);
        // straight down or up, the camera has -z as its up: it is in front of that, or behind it
        double yaw = across > 0 ? StrictMath.toDegrees(StrictMath.atan2(back.x, back.z)) : back.y > 0 ? 0 : FULL_TURN / 2;
        double pitch = across > 0 ? StrictMath.toDegrees(StrictMath.atan2(back.y, across)) : Math.copySign(POLE, back.y);
        return new Orbit(pose.lx(), pose.ly(), pose.lz(), yaw, pitch, StrictMath.hypot(across, back.y), pose.fov(),
            view == null ? 0 : view.height(), free.up);
    }

    /** {@return what x, y and z are turned to, as y is to up: unit vectors, of which only y's itself is up} */
    private static Vector[] axes(Vector up) {
        Vector y = up.normalised();
        Vector z = Math.abs(y.z) < SLANTED ? new Vector(0, 0, 1) : new Vector(0, -1, 0);
        Vector x = Vector.cross(y, z);
        x.normalise();
        return new Vector[] {x, y, Vector.cross(x, y)};
    }

    /** {@return the offset of a point, given if y were up} */
    private Vector turned(double right, double above, double front) {
        if (up == null) {
            return new Vector(right, above, front);
        }
        Vector[] axes = axes(up);
        Vector offset = Vector.scale(axes[0], right);
        offset.add(Vector.scale(axes[1], above));
        offset.add(Vector.scale(axes[2], front));
        return offset;
    }

    /** {@return the offset of a point that is so far behind the pivot as the camera sees it} */
    private Vector behind(double away) {
        return turned(away * sin(yaw) * cos(pitch), away * sin(pitch), away * cos(yaw) * cos(pitch));
    }

    /** {@return the same camera by its eye and its look-at point; its field of view is 0 if rays are parallel} */
    public Pose pose() {
        Vector behind = behind(distance);
        return new Pose(x + behind.x, y + behind.y, z + behind.z, x, y, z, fov);
    }

    /** {@return settings with this camera alone} */
    public SceneSettings settings() {
        SceneSettings settings = new SceneSettings();
        Pose pose = pose();
        if (isParallel()) {
            settings.parallel = new View(pose.ex(), pose.ey(), pose.ez(), x, y, z, height);
        } else {
            settings.camera = pose;
        }
        settings.up = up;
        return settings;
    }

    private boolean isParallel() {
        return height > 0;
    }

    /**
     * Turns the camera round its pivot.
     *
     * @param right degrees to its right
     * @param above degrees up, limited by the poles
     * @return the turned camera
     */
    public Orbit turned(double right, double above) {
        double limit = POLE - NEAREST_POLE;
        double turned = Math.max(-limit, Math.min(limit, pitch + above));
        return sound(new Orbit(x, y, z, Math.IEEEremainder(yaw + right, FULL_TURN), turned, distance, fov, height, up));
    }

    /**
     * Moves the camera and its pivot sideways.
     *
     * @param right the distance to its right, in heights of the picture at the pivot's distance
     * @param above the distance to its top, likewise
     * @return the moved camera
     */
    public Orbit panned(double right, double above) {
        double high = isParallel() ? height : 2 * distance * StrictMath.tan(StrictMath.toRadians(fov) / 2);
        double r = right * high;
        double u = above * high;
        Vector by = turned(r * cos(yaw) - u * sin(yaw) * sin(pitch), u * cos(pitch), -r * sin(yaw) - u * cos(yaw) * sin(pitch));
        return sound(moved(by, distance));
    }

    /**
     * Moves the camera towards its pivot, which it never reaches, or away from it; if rays are parallel, it stays, and sees less or more.
     *
     * @param factor the factor of the distance, or of the height if rays are parallel, above 0
     * @return the moved camera
     */
    public Orbit dollied(double factor) {
        if (isParallel()) {
            return sound(new Orbit(x, y, z, yaw, pitch, distance, fov, Math.max(height * factor, Math.min(height, NEAREST)), up));
        }
        double least = Math.max(NEAREST, NEAREST_SHARE * Math.max(Math.abs(x), Math.max(Math.abs(y), Math.abs(z))));
        return sound(moved(new Vector(), Math.max(distance * factor, Math.min(distance, least))));
    }

    /**
     * Moves the camera towards a point or away from it, which stays where it is in the picture, and changes the distance by the same factor.
     *
     * @param factor the factor of the distances, above 0
     * @param to the point
     * @return the moved camera
     */
    public Orbit dollied(double factor, Point to) {
        Orbit nearer = dollied(factor);
        Pose eye = pose();
        Pose after = nearer.pose();                           // which went straight to the pivot
        Vector by = new Vector(to.x - eye.ex(), to.y - eye.ey(), to.z - eye.ez());
        if (isParallel()) {
            Vector back = behind(1);
            by.add(Vector.scale(back, -by.dot(back)));        // sideways
            by.scale(1 - nearer.height / height);
        } else {
            by.scale(1 - nearer.distance / distance);
            by.add(new Vector(eye.ex() - after.ex(), eye.ey() - after.ey(), eye.ez() - after.ez()));
        }
        return nearer.sound(nearer.moved(by, nearer.distance));
    }

    /**
     * Stops the camera before a surface that is in its way from where it was, along which it slides.
     *
     * @param before the camera before it was moved to here
     * @param scene the scene
     * @return this camera; or one that looks the same way if only its place has changed, else at the same pivot
     */
    public Orbit stopped(Orbit before, Scene scene) {
        Pose from = before.pose();
        Pose to = pose();
        Point end = EyePath.end(scene, new Point(from.ex(), from.ey(), from.ez()), new Point(to.ex(), to.ey(), to.ez()),
            EyePath.MARGIN * before.distance);
        double dx = end.x - to.ex();
        double dy = end.y - to.ey();
        double dz = end.z - to.ez();
        if (dx == 0 && dy == 0 && dz == 0) {
            return this;
        }
        if (before.yaw == yaw && before.pitch == pitch) {
            return sound(moved(new Vector(dx, dy, dz), distance));
        }
        SceneSettings slid = settings();
        if (isParallel()) {
            slid.parallel = new View(end.x, end.y, end.z, x, y, z, height);
        } else {
            slid.camera = new Pose(end.x, end.y, end.z, x, y, z, fov);
        }
        return isFaultless(slid) ? of(slid) : before;
    }

    /**
     * Finds what a pixel shows.
     *
     * @param scene the scene
     * @param width the picture's width in pixels
     * @param height its height
     * @param px the place across, from the left, in pixels
     * @param py the place down, from the top
     * @return the point that is seen there; if that is no object, one as far away as the pivot
     */
    public Point seenAt(Scene scene, int width, int height, double px, double py) {
        SceneSettings sized = settings();
        sized.resolution = new SceneSettings.Resolution(width, height);
        Ray ray = sized.newCamera().through(px, py);
        Hit hit = new Hit();
        return ray.getPointAt(new BruteForceIntersector(scene).intersect(ray, hit) ? hit.t : distance);
    }

    /**
     * Moves the pivot to the point in the middle of the picture. The picture does not change.
     *
     * @param scene the scene
     * @return the same camera with that pivot; this one if the middle shows no object, or one that is much too near or too far
     */
    public Orbit aimed(Scene scene) {
        SceneSettings onePixel = settings();
        onePixel.resolution = new SceneSettings.Resolution(1, 1);
        Ray ray = onePixel.newCamera().through(0.5, 0.5);
        double nearest = Double.POSITIVE_INFINITY;
        for (int i = 0; i < scene.getNumberObjects(); i++) {
            double t = scene.getObject(i).intersect(ray);
            nearest = t >= 0 ? Math.min(nearest, t) : nearest;
        }
        double ahead = distance - nearest;                    // from the new pivot to the old one
        return nearest > distance / SOUND && nearest < distance * SOUND ? sound(moved(behind(ahead), nearest)) : this;
    }

    /**
     * Turns the camera until it looks at a point, its new pivot; a parallel one is moved instead.
     *
     * @param point the point
     * @return the turned camera; this one if it cannot look there
     */
    public Orbit lookingAt(Point point) {
        if (isParallel()) {
            return sound(new Orbit(point.x, point.y, point.z, yaw, pitch, distance, fov, height, up));
        }
        SceneSettings free = settings();
        Pose eye = free.camera;
        free.camera = new Pose(eye.ex(), eye.ey(), eye.ez(), point.x, point.y, point.z, fov);
        return free.camera.fault() == null && !free.camera.isAlong(up) ? sound(of(free)) : this;
    }

    private Orbit moved(Vector by, double newDistance) {
        return new Orbit(x + by.x, y + by.y, z + by.z, yaw, pitch, newDistance, fov, height, up);
    }

    /** {@return another camera; this one if its pose would not be finite} */
    private Orbit sound(Orbit other) {
        Pose pose = other.pose();
        boolean finite = Double.isFinite(pose.ex() + pose.ey() + pose.ez()) && Double.isFinite(other.x + other.y + other.z);
        return finite && isFaultless(other.settings()) ? other : this;
    }

    private static boolean isFaultless(SceneSettings free) {
        return (free.parallel == null ? free.camera.fault() : free.parallel.fault()) == null && !free.isUpAlongView();
    }

    private static double sin(double degrees) {
        return StrictMath.sin(StrictMath.toRadians(degrees));
    }

    /** {@return the cosine, exactly 0 at a pole, since only there the view is along y} */
    private static double cos(double degrees) {
        return Math.abs(degrees) == POLE ? 0 : StrictMath.cos(StrictMath.toRadians(degrees));
    }
}
