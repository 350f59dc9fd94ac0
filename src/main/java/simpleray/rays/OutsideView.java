package simpleray.rays;

import java.awt.image.BufferedImage;
import java.util.List;
import simpleray.image.Picture;
import simpleray.math.Bounds;
import simpleray.math.Point;
import simpleray.math.Vector;
import simpleray.render.Stage;
import simpleray.scene.Orbit;
import simpleray.scene.PerspectiveCamera;
import simpleray.scene.PerspectiveCamera.Pose;
import simpleray.scene.Scene;

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

    /** The image may have more or fewer pixels than the camera; it is stretched to its size. */
    OutsideView(PerspectiveCamera camera, BufferedImage image, double[] distances) {
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
        Pose behind = new Pose(middle.x - away * along.x, middle.y - away * along.y, middle.z - away * along.z,
            middle.x, middle.y, middle.z, FOV);
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
        return new OutsideScene(scene).view(inside, pose, width, height, 1, stage, samples);
    }

    static BufferedImage faded(Picture picture) {
        BufferedImage image = new BufferedImage(picture.width(), picture.height(), BufferedImage.TYPE_INT_RGB);
        for (int y = 0; y < image.getHeight(); y++) {
            int[] row = Picture.packed(Picture.levels(picture.over(y, 0)), Picture.RGB);
            for (int x = 0; x < image.getWidth(); x++) {
                int rgb = row[x];
                image.setRGB(x, y, faded(rgb >> 16 & 0xff) << 16 | faded(rgb >> 8 & 0xff) << 8 | faded(rgb & 0xff));
            }
        }
        return image;
    }

    private static int faded(int level) {
        return Math.round(KEPT * level + GREY);
    }

    /** {@return the distance of the surface at a place; infinite if there is none, also beyond the edges} */
    double distance(double px, double py) {
        int width = image.getWidth();
        int x = (int) Math.floor(px * width / camera.width());
        int y = (int) Math.floor(py * image.getHeight() / camera.height());
        boolean in = x >= 0 && y >= 0 && x < width && y < image.getHeight();
        return in ? distances[y * width + x] : Double.POSITIVE_INFINITY;
    }
}
