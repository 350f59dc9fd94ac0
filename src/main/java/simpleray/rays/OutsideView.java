package simpleray.rays;

import java.awt.image.BufferedImage;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;
import simpleray.image.Picture;
import simpleray.math.Bounds;
import simpleray.math.Point;
import simpleray.math.Ray;
import simpleray.math.Vector;
import simpleray.render.Accel;
import simpleray.render.RenderSettings;
import simpleray.render.Renderer;
import simpleray.render.Stage;
import simpleray.scene.Hit;
import simpleray.scene.Intersector;
import simpleray.scene.Object;
import simpleray.scene.Orbit;
import simpleray.scene.PerspectiveCamera;
import simpleray.scene.PerspectiveCamera.Pose;
import simpleray.scene.Plane;
import simpleray.scene.RayStats;
import simpleray.scene.Scene;
import simpleray.trace.CompiledScene;

/**
 * A scene as an eye outside sees it, and how far each pixel's surface is away. <em>Constant.</em> Planes between that eye and the scene's
 * own eye are left out, so that one looks into a closed room as into a doll's house.
 */
public final class OutsideView {
    private static final double FOV = 40;
    /** Where the eye is unless it is given: so many degrees to the right and above, seen along the primary ray. */
    private static final double ASIDE = 50;
    private static final double ABOVE = 22;
    /** The distance of the eye from the middle of the rays, in radii of a sphere round them. */
    private static final double AWAY = 3.4;
    /** The share of the colour that is left, since rays are drawn over it, and the grey that is added. */
    private static final float KEPT = 0.6f;
    private static final float GREY = 24;

    final PerspectiveCamera camera;
    final BufferedImage image;
    private final double[] distances;                         // of each pixel's surface from the eye; infinite if there is none

    private OutsideView(PerspectiveCamera camera, BufferedImage image, double[] distances) {
        this.camera = camera;
        this.image = image;
        this.distances = distances;
    }

    /**
     * Returns a camera that sees all rays of a pixel.
     *
     * @param segments the rays
     * @param eye where it is; null for a place aside and above
     * @return the camera
     * @throws IllegalArgumentException if the eye is in the middle of the rays
     */
    public static Pose pose(List<RaySegment> segments, Point eye) {
        Bounds b = RaySegment.bounds(segments);
        Point middle = new Point(b.xmin() / 2 + b.xmax() / 2, b.ymin() / 2 + b.ymax() / 2, b.zmin() / 2 + b.zmax() / 2);
        if (eye != null) {
            Pose pose = new Pose(eye.x, eye.y, eye.z, middle.x, middle.y, middle.z, FOV);
            if (pose.fault() != null) {
                throw new IllegalArgumentException("an eye other than the middle of the rays");
            }
            return pose;
        }
        double radius = Math.hypot(Math.hypot(b.xmax() - b.xmin(), b.ymax() - b.ymin()), b.zmax() - b.zmin()) / 2;
        double away = AWAY * (radius > 0 ? radius : 1);
        Vector along = segments.get(0).ray().ray().direction;
        Pose behind = new Pose(middle.x - away * along.x, middle.y - away * along.y, middle.z - away * along.z, middle.x, middle.y, middle.z, FOV);
        return Orbit.of(behind).turned(ASIDE, ABOVE).pose();
    }

    /**
     * Returns a camera that sees the angles between the vectors at a hit as they are, since it looks at right angles to them.
     *
     * @param vectors segments at one hit, two or more
     * @return the camera; one aside of the first vector if all lie along one line
     */
    public static Pose across(List<RaySegment> vectors) {
        RaySegment last = vectors.get(vectors.size() - 1);
        RaySegment other = vectors.get(vectors.size() - 2);
        Point at = last.from();
        Vector along = Vector.subtract(last.to(), at);
        Vector middle = Vector.scale(along, 0.5);
        Vector aside = Vector.cross(Vector.subtract(other.to(), other.from()), along);
        double length = along.norm();
        if (aside.norm() <= 1e-6 * length * length) {
            aside = Vector.cross(Math.abs(along.y) < 0.9 * length ? new Vector(0, 1, 0) : new Vector(1, 0, 0), along);
        }
        aside.normalise();
        aside.scale(AWAY * length);
        Point eye = Point.add(Point.add(at, middle), aside);
        return new Pose(eye.x, eye.y, eye.z, at.x + middle.x, at.y + middle.y, at.z + middle.z, FOV);
    }

    /**
     * Renders a view.
     *
     * @param scene the scene
     * @param inside the scene's own eye
     * @param pose the camera outside
     * @param width the width in pixels, 1 or more
     * @param height the height in pixels, 1 or more
     * @param stage {@link Stage#FINAL}, or a simpler one for speed
     * @param samples the number of samples along each side of a pixel
     * @return the view
     * @throws java.util.concurrent.CancellationException if the calling thread was interrupted
     */
    public static OutsideView of(Scene scene, Point inside, Pose pose, int width, int height, Stage stage, int samples) {
        Scene opened = opened(scene, inside, new Point(pose.ex(), pose.ey(), pose.ez()));
        PerspectiveCamera camera = new PerspectiveCamera(pose, width, height);
        int threads = Runtime.getRuntime().availableProcessors();
        Picture picture = new Renderer(opened, camera, new RenderSettings(stage, 2, samples, Accel.AUTO, threads, null)).render(row -> { });
        return new OutsideView(camera, faded(picture), distances(opened, camera, threads));
    }

    /** {@return the scene without the planes between two points} */
    static Scene opened(Scene scene, Point inside, Point outside) {
        List<Object> kept = new ArrayList<>();
        for (int i = 0; i < scene.getNumberObjects(); i++) {
            Object object = scene.getObject(i);
            boolean between = object instanceof Plane plane
                && (plane.normal.dot(inside) - plane.constant) * (plane.normal.dot(outside) - plane.constant) < 0;
            if (!between) {
                kept.add(object);
            }
        }
        Scene opened = new Scene();
        opened.ambient = scene.ambient;
        opened.settings = scene.settings;
        opened.setNumberObjects(kept.size());
        for (int i = 0; i < kept.size(); i++) {
            opened.setObject(i, kept.get(i));
        }
        opened.setNumberLights(scene.getNumberLights());
        for (int i = 0; i < scene.getNumberLights(); i++) {
            opened.setLight(i, scene.getLight(i));
        }
        return opened;
    }

    private static BufferedImage faded(Picture picture) {
        BufferedImage image = picture.toBufferedImage();
        for (int y = 0; y < image.getHeight(); y++) {
            for (int x = 0; x < image.getWidth(); x++) {
                int rgb = image.getRGB(x, y);
                image.setRGB(x, y, faded(rgb >> 16 & 0xff) << 16 | faded(rgb >> 8 & 0xff) << 8 | faded(rgb & 0xff));
            }
        }
        return image;
    }

    private static int faded(int level) {
        return Math.round(KEPT * level + GREY);
    }

    private static double[] distances(Scene scene, PerspectiveCamera camera, int threads) {
        double[] distances = new double[camera.width() * camera.height()];
        CompiledScene compiled = new CompiledScene(scene, camera.eye(), threads, distances.length);
        IntStream.range(0, camera.height()).parallel().forEach(y -> {
            Intersector intersector = compiled.intersector(new RayStats());
            Hit hit = new Hit();
            Ray ray = new Ray();
            int at = y * camera.width();
            for (int x = 0; x < camera.width(); x++) {
                camera.through(x + 0.5, y + 0.5, ray);
                distances[at + x] = intersector.intersect(ray, hit) ? hit.t : Double.POSITIVE_INFINITY;
            }
        });
        return distances;
    }

    /** {@return the distance of the surface at a pixel; infinite if there is none, also beyond the edges} */
    double distance(double px, double py) {
        int x = (int) Math.floor(px);
        int y = (int) Math.floor(py);
        boolean in = x >= 0 && y >= 0 && x < camera.width() && y < camera.height();
        return in ? distances[y * camera.width() + x] : Double.POSITIVE_INFINITY;
    }
}
