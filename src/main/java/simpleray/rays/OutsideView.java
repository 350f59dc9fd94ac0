package simpleray.rays;

import java.awt.image.BufferedImage;
import java.util.List;
import simpleray.image.Picture;
import simpleray.math.Bounds;
import simpleray.math.Point;
import simpleray.math.Vector;
import simpleray.render.Stage;
import simpleray.scene.Camera;
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
    /** The distance of the eye from the vectors at a hit, in lengths of one. */
    private static final double AWAY = 3.4;
    /** The share of the view's width and height that what is to be seen fills at most. */
    private static final double FRAMED = 0.88;
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
     * Returns a camera aside of the primary ray and above, as near as it can be to see the eye, the image plane and all rays of a pixel; of
     * what goes on without end, or to a light far away, only the beginning.
     *
     * @param segments the rays
     * @param inside the scene's own camera
     * @param width the view's width, 1 or more
     * @param height the view's height, 1 or more
     * @return the camera
     */
    public static Pose pose(List<RaySegment> segments, Camera inside, int width, int height) {
        Point middle = middle(segments, inside);
        Vector along = segments.get(0).ray().ray().direction;
        Pose behind = new Pose(middle.x - along.x, middle.y - along.y, middle.z - along.z, middle.x, middle.y, middle.z, FOV);
        PerspectiveCamera turned = new PerspectiveCamera(Orbit.of(behind).turned(ASIDE, ABOVE).pose(), width, height);
        Vector forward = turned.forward();
        double away = 0;
        for (Point p : framed(segments, inside)) {
            Vector v = Vector.subtract(p, middle);
            for (Vector side : new Vector[] {turned.right(), turned.up()}) {
                away = Math.max(away, 2 * Math.abs(v.dot(side)) / (side.squarednorm() * FRAMED) - v.dot(forward));
            }
        }
        away = away > 0 ? away : 1;
        return new Pose(middle.x - away * forward.x, middle.y - away * forward.y, middle.z - away * forward.z,
            middle.x, middle.y, middle.z, FOV);
    }

    /**
     * Returns a camera at a given place.
     *
     * @param segments the rays, at whose middle it looks
     * @param inside the scene's own camera
     * @param eye where it is
     * @return the camera
     * @throws IllegalArgumentException if the eye is in the middle of the rays
     */
    public static Pose pose(List<RaySegment> segments, Camera inside, Point eye) {
        Point middle = middle(segments, inside);
        Pose pose = new Pose(eye.x, eye.y, eye.z, middle.x, middle.y, middle.z, FOV);
        if (pose.fault() != null) {
            throw new IllegalArgumentException("an eye other than the middle of the rays");
        }
        return pose;
    }

    private static Point middle(List<RaySegment> segments, Camera inside) {
        List<Point> points = framed(segments, inside);
        Bounds b = Bounds.of(points.get(0), points.toArray(new Point[0]));
        return new Point(b.xmin() / 2 + b.xmax() / 2, b.ymin() / 2 + b.ymax() / 2, b.zmin() / 2 + b.zmax() / 2);
    }

    /** {@return what is to be seen: the ends of the rays and the corners of the image plane} */
    static List<Point> framed(List<RaySegment> segments, Camera inside) {
        List<Point> points = RaySegment.framed(segments);
        double away = RayDrawing.planeDistance(segments.get(0));
        for (double x : new double[] {0, inside.width()}) {
            for (double y : new double[] {0, inside.height()}) {
                points.add(RayDrawing.onPlane(inside, x, y, away));
                points.add(inside.through(x, y).origin);      // the eye, or a corner of the plane in which parallel rays start
            }
        }
        return points;
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
