package simpleray.convert;

import simpleray.math.Colour;
import simpleray.math.Point;
import simpleray.math.Vector;
import simpleray.scene.Cone;
import simpleray.scene.Cylinder;
import simpleray.scene.Material;
import simpleray.scene.Plane;
import simpleray.scene.PerspectiveCamera.Pose;
import simpleray.scene.SceneSettings;
import simpleray.scene.Sphere;
import simpleray.scene.Triangle;
import simpleray.text.SceneFormatException;

/**
 * Reads the scenes of miniRT, a course project of the schools of 42. A line is a thing; three numbers with commas between them are a point,
 * a direction or a colour from 0 to 255:
 * <pre>
 * R width height                                   the picture's size (in older scenes)
 * A ratio colour                                   the ambient light
 * C point direction angle      (or c)              the camera, and its view from left to right in degrees
 * L point brightness [colour]  (or l)              a light
 * sp point diameter colour                         a sphere
 * pl point normal colour                           a plane
 * cy point axis diameter height colour             a cylinder about its middle; in older scenes the colour before the diameter
 * tr point point point colour                      a triangle (in older scenes)
 * co point axis diameter height colour             a cone: programs differ
 * </pre>
 * <em>Mutable,</em> for one thread.
 */
final class RtReader {
    private static final String[] AXES = {"x", "y", "z"};
    private static final String[] CHANNELS = {"red from 0 to 255", "green from 0 to 255", "blue from 0 to 255"};
    private static final double MAX_LEVEL = 255;
    private static final double HALF_TURN = 180;
    /** A direction that is shorter than this share of the eye's coordinates is scaled. */
    private static final double SHORT = 1e-3;
    private static final String ANGLE = "the view's angle above 0 and below 180 degrees";

    private final ForeignText text;
    private final SceneBuilder scene = new SceneBuilder();
    private ForeignText.Place place;                          // of the line that is read
    private boolean hasAmbient;
    private ForeignText.Place view;                           // of the camera
    private double angle;                                     // from left to right

    RtReader(ForeignText text) {
        this.text = text;
    }

    ImportedScene read() throws SceneFormatException {
        while (text.next()) {
            place = text.here();
            String word = text.takeWord();
            switch (word) {
                case "R" -> readSize();
                case "A" -> readAmbient();
                case "C", "c" -> readCamera();
                case "L", "l" -> readLight();
                case "sp" -> readSphere();
                case "pl" -> readPlane();
                case "cy" -> readCylinder();
                case "tr" -> readTriangle();
                case "co" -> readCone();
                case "sq" -> leaveOut("its line does not tell how a square is turned about its normal");
                default -> readOther(word);
            }
        }
        if (scene.settings.camera == null) {
            throw text.error(text.here(), "a camera: C", "the end of the file");
        }
        if (!hasAmbient) {
            text.warn(text.here(), "without ambient light, since the file has no line A");
        }
        scene.settings.camera = withHeight(scene.settings.camera);
        return scene.build(text, view);
    }

    /** Leaves out a line of a dialect. */
    private void readOther(String word) throws SceneFormatException {
        if (!word.matches("[A-Za-z_]\\w*") || text.isLineEnd()) {
            throw text.expected("A, C, L, sp, pl or cy");
        }
        leaveOut("miniRT has no " + word + ", and programs that have it differ");
    }

    private void leaveOut(String why) {
        text.takeLine();
        text.warn(place, "left out: " + why);
    }

    /** Ends a line: more words are of a dialect. */
    private void end() {
        if (!text.isLineEnd()) {
            ForeignText.Place rest = text.here();
            text.takeLine();
            text.warn(rest, "left out: what stands here is not in miniRT, and programs that have it differ");
        }
    }

    private Point point(String what) throws SceneFormatException {
        double[] xyz = text.takeTriple(what, -ForeignText.MAX_NUMBER, ForeignText.MAX_NUMBER, AXES);
        return new Point(xyz[0], xyz[1], xyz[2]);
    }

    private Vector direction(String what) throws SceneFormatException {
        ForeignText.Place at = text.here();
        Point p = point(what);
        if (p.x == 0 && p.y == 0 && p.z == 0) {
            throw text.error(at, what + " other than zero", "zero");
        }
        return new Vector(p.x, p.y, p.z);
    }

    /** {@return a colour, from 0 to 1} */
    private Colour colour(String what) throws SceneFormatException {
        double[] rgb = text.takeTriple(what, 0, MAX_LEVEL, CHANNELS);
        return new Colour(rgb[0] / MAX_LEVEL, rgb[1] / MAX_LEVEL, rgb[2] / MAX_LEVEL);
    }

    private double length(String what) throws SceneFormatException {
        double length = text.takeNumber(what);
        if (length <= 0) {
            throw text.expected(what + " above 0");
        }
        return length;
    }

    /** {@return what a colour makes of a surface: it scatters that of all light, and mirrors nothing} */
    private static Material material(Colour colour) {
        Material material = new Material();
        material.ambient = colour;
        material.diffuse = colour;
        material.mirror = new Colour();
        return material;
    }

    private void readSize() throws SceneFormatException {
        int width = side("width");
        int height = side("height");
        end();
        if (scene.settings.resolution != null) {
            text.warn(place, "left out: a scene has one size, the first");
            return;
        }
        scene.settings.resolution = new SceneSettings.Resolution(width, height);
    }

    private int side(String what) throws SceneFormatException {
        return text.takeInteger("the picture's " + what + " from 1 to " + SceneSettings.MAX_RESOLUTION, 1, SceneSettings.MAX_RESOLUTION);
    }

    private void readAmbient() throws SceneFormatException {
        double ratio = text.takeNumber("the ambient light's ratio of 0 or more", 0, Double.MAX_VALUE);
        Colour colour = colour("the ambient light's");
        end();
        if (hasAmbient) {
            text.warn(place, "left out: a scene has one ambient light, the first");
            return;
        }
        colour.scale(ratio);
        scene.ambient = colour;
        hasAmbient = true;
    }

    private void readCamera() throws SceneFormatException {
        Point eye = point("the camera's");
        Vector to = direction("the camera's direction");
        double far = largest(eye.x, eye.y, eye.z);
        if (largest(to.x, to.y, to.z) < SHORT * Math.max(1, far)) {      // or it would lose digits beside the eye
            to.normalise();
            to.scale(Math.max(1, far));
        }
        double degrees = text.takeNumber(ANGLE, 0, HALF_TURN);
        if (degrees == 0 || degrees == HALF_TURN) {
            throw text.expected(ANGLE);
        }
        end();
        if (scene.settings.camera != null) {
            text.warn(place, "left out: a scene has one camera, the first");
            return;
        }
        scene.settings.camera = new Pose(eye.x, eye.y, eye.z, eye.x + to.x, eye.y + to.y, eye.z + to.z, degrees);
        view = place;
        angle = degrees;
    }

    /** {@return the camera with the angle from bottom to top that belongs to its angle from left to right, in a picture of the scene's size} */
    private Pose withHeight(Pose c) {
        SceneSettings.Resolution size = scene.settings.resolution;
        if (size == null || size.width() == size.height()) {
            return c;
        }
        double half = StrictMath.tan(StrictMath.toRadians(angle / 2)) * size.height() / size.width();
        return new Pose(c.ex(), c.ey(), c.ez(), c.lx(), c.ly(), c.lz(), 2 * StrictMath.toDegrees(StrictMath.atan(half)));
    }

    private static double largest(double x, double y, double z) {
        return Math.max(Math.max(Math.abs(x), Math.abs(y)), Math.abs(z));
    }

    private void readLight() throws SceneFormatException {
        Point origin = point("the light's");
        double brightness = text.takeNumber("the light's brightness of 0 or more", 0, Double.MAX_VALUE);
        Colour colour = text.isTripleNext() ? colour("the light's") : new Colour(1, 1, 1);
        end();
        colour.scale(brightness);
        scene.addLight(place, origin, colour);
    }

    private void readSphere() throws SceneFormatException {
        Point centre = point("the sphere's");
        double diameter = length("the sphere's diameter");
        scene.add(place, new Sphere(material(colour("the sphere's")), centre, diameter / 2));
        end();
    }

    private void readPlane() throws SceneFormatException {
        Point p = point("the plane's");
        Vector normal = direction("the plane's normal");
        double constant = p.x * normal.x + p.y * normal.y + p.z * normal.z;
        scene.add(place, new Plane(material(colour("the plane's")), normal, constant));
        end();
    }

    private void readCylinder() throws SceneFormatException {
        Point middle = point("the cylinder's");
        Vector axis = direction("the cylinder's axis");
        Colour before = text.isTripleNext() ? colour("the cylinder's") : null;
        double diameter = length("the cylinder's diameter");
        double height = length("the cylinder's height");
        Colour colour = before == null ? colour("the cylinder's") : before;
        axis.measureAndNormalise();
        Point start = along(middle, axis, -height / 2);
        Point end = along(middle, axis, height / 2);
        requireHeight(start, end);
        scene.add(place, new Cylinder(material(colour), start, end, diameter / 2));
        end();
    }

    private static Point along(Point p, Vector axis, double length) {
        return Point.add(p, Vector.scale(axis, length));
    }

    private void requireHeight(Point start, Point end) throws SceneFormatException {
        if (start.x == end.x && start.y == end.y && start.z == end.z) {
            throw text.error(place, "a height that is not lost beside the point", "a smaller one");
        }
    }

    private void readTriangle() throws SceneFormatException {
        Point a = point("the first vertex");
        Point b = point("the second vertex");
        Point c = point("the third vertex");
        Triangle triangle = new Triangle(material(colour("the triangle's")), a, b, c);
        end();
        if (triangle.isFlat()) {
            text.warn(place, "left out: a triangle without area");
            return;
        }
        scene.add(place, triangle);
    }

    /** Reads a cone, which programs have with other meanings; the warning tells which is taken. */
    private void readCone() throws SceneFormatException {
        Point base = point("the cone's");
        Vector axis = direction("the cone's axis");
        double diameter = length("the cone's diameter");
        double height = length("the cone's height");
        Colour colour = colour("the cone's");
        axis.measureAndNormalise();
        Point apex = along(base, axis, height);
        requireHeight(base, apex);
        scene.add(place, new Cone(material(colour), base, diameter / 2, apex, 0));
        text.warn(place, "programs differ: taken as the middle of the base, the direction to the apex, the base's diameter, the height and the colour");
        end();
    }
}
