package simpleray.convert;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.DoubleStream;
import simpleray.math.Bounds;
import simpleray.math.Colour;
import simpleray.math.Point;
import simpleray.math.Vector;
import simpleray.scene.Cone;
import simpleray.scene.Light;
import simpleray.scene.Material;
import simpleray.scene.PerspectiveCamera;
import simpleray.scene.PerspectiveCamera.Pose;
import simpleray.scene.SceneSettings;
import simpleray.scene.Sphere;
import simpleray.scene.Triangle;
import simpleray.text.SceneFormatException;

/**
 * Reads Eric Haines' Neutral File Format, that of the Standard Procedural Databases. Words may be parted by any white space; the colour
 * of a light stands on its line:
 * <pre>
 * v from x y z  at x y z  up x y z  angle a  hither h  resolution w h      the view
 * b r g b                                                                  the background
 * l x y z [r g b]                                                          a light
 * f r g b Kd Ks Shine T index                                              the material of what follows
 * s x y z r                                                                a sphere
 * c x y z r  x y z r                                                       a cone or cylinder, open
 * p n  x y z …                                                             a polygon
 * pp n  x y z nx ny nz …                                                   a polygon with normals
 * </pre>
 * <em>Mutable,</em> for one thread.
 */
final class NffReader {
    private static final String[] AXES = {" x", " y", " z"};
    private static final String[] CHANNELS = {" red", " green", " blue"};
    private static final String OR_MORE = " of 0 or more";
    private static final int MIN_CORNERS = 3;
    private static final double MAX = Double.MAX_VALUE;
    private static final double HALF_TURN = 180;
    /** An exponent that grants as many reflections as a ray can have by default. */
    private static final int CLEAR = SceneSettings.DEFAULT_DEPTH;

    private final ForeignText text;
    private final SceneBuilder scene = new SceneBuilder();
    private final Map<List<Double>, Material> materials = new HashMap<>();
    private final List<Light> uncoloured = new ArrayList<>();
    private Material material;                                // null before the first f
    private ForeignText.Place viewAt;
    private double hither;
    private ForeignText.Place hitherAt;
    private ForeignText.Place place;                          // of the thing that is read

    NffReader(ForeignText text) {
        this.text = text;
    }

    ImportedScene read() throws SceneFormatException {
        while (text.next()) {
            place = text.here();
            String word = text.takeWord();
            switch (word) {
                case "v" -> readView();
                case "b" -> readBackground();
                case "l" -> readLight();
                case "f" -> readMaterial();
                case "s" -> readSphere();
                case "c" -> readCone();
                case "p" -> readPolygon(false);
                case "pp" -> readPolygon(true);
                default -> throw text.expected("v, b, l, f, s, c, p or pp");
            }
        }
        if (scene.settings.camera == null) {
            throw text.error(text.here(), "a view: v", "the end of the file");
        }
        for (Light light : uncoloured) {                      // the format leaves it to the lights to share the light
            double share = 1 / Math.sqrt(scene.lights.size());
            light.intensity = new Colour(share, share, share);
        }
        if (hither > 0) {
            findCut();
        }
        return scene.build(text, viewAt);
    }

    private double number(String what) throws SceneFormatException {
        text.next();
        return text.takeNumber(what);
    }

    private double number(String what, double max) throws SceneFormatException {
        text.next();
        return text.takeNumber(what, 0, max);
    }

    private double[] numbers(String what, String[] names) throws SceneFormatException {
        double[] numbers = new double[names.length];
        for (int i = 0; i < names.length; i++) {
            numbers[i] = number(what + names[i]);
        }
        return numbers;
    }

    private Point point(String what) throws SceneFormatException {
        double[] xyz = numbers(what, AXES);
        return new Point(xyz[0], xyz[1], xyz[2]);
    }

    private Colour colour(String what) throws SceneFormatException {
        double[] rgb = new double[CHANNELS.length];
        for (int i = 0; i < CHANNELS.length; i++) {
            rgb[i] = number(what + CHANNELS[i] + OR_MORE, MAX);
        }
        return new Colour(rgb[0], rgb[1], rgb[2]);
    }

    private boolean isWord(String word) {
        if (!text.next() || !text.isNext(word)) {
            return false;
        }
        text.takeWord();
        return true;
    }

    private void require(String word) throws SceneFormatException {
        if (!isWord(word)) {
            text.takeWord();
            throw text.expected("the view's " + word);
        }
    }

    private void readView() throws SceneFormatException {
        boolean again = scene.settings.camera != null;
        ForeignText.Place view = place;
        require("from");
        Point from = point("the eye's");
        require("at");
        text.next();
        ForeignText.Place atAt = text.here();
        Point at = point("the look-at point's");
        require("up");
        text.next();
        ForeignText.Place upAt = text.here();
        double[] up = numbers("up's", AXES);
        require("angle");
        double angle = number("an angle above 0 and below 180 degrees", HALF_TURN);
        if (angle == 0 || angle == HALF_TURN) {
            throw text.expected("an angle above 0 and below 180 degrees");
        }
        text.next();
        ForeignText.Place before = text.here();
        double near = isWord("hither") ? number("hither") : 0;
        SceneSettings.Resolution size = isWord("resolution") ? new SceneSettings.Resolution(side("width"), side("height")) : null;
        Pose pose = new Pose(from.x, from.y, from.z, at.x, at.y, at.z, angle);
        Vector upwards = new Vector(up[0], up[1], up[2]);
        if (pose.fault() != null) {
            throw text.error(atAt, "a " + pose.fault(), "the eye");
        }
        if (up[0] == 0 && up[1] == 0 && up[2] == 0 || pose.isAlong(upwards)) {
            throw text.error(upAt, "up that is not along the view", "one that is");
        }
        if (again) {
            text.warn(view, "left out: a scene has one view, the first");
            return;
        }
        viewAt = view;
        if (near < 0) {
            text.warn(before, "left out: hither, since rays see from the eye on and nothing behind it");
        }
        hither = near;
        hitherAt = before;
        scene.settings.camera = pose;
        scene.settings.up = upwards;
        scene.settings.resolution = size;
        if (size != null && size.width() != size.height()) {
            text.warn(view, "changed: the angle is that from bottom to top, since pixels are square");
        }
    }

    private int side(String what) throws SceneFormatException {
        text.next();
        return text.takeInteger("the picture's " + what + " from 1 to " + SceneSettings.MAX_RESOLUTION, 1, SceneSettings.MAX_RESOLUTION);
    }

    private void readBackground() throws SceneFormatException {
        Colour background = colour("the background's");
        if (scene.settings.background != null) {
            text.warn(place, "left out: a scene has one background, the first");
            return;
        }
        scene.settings.background = background;
    }

    private void readLight() throws SceneFormatException {
        Point origin = point("the light's");
        boolean plain = text.isLineEnd();
        Light light = scene.addLight(place, origin, plain ? new Colour() : colour("the light's"));
        if (plain) {
            uncoloured.add(light);
        }
    }

    private void readMaterial() throws SceneFormatException {
        Colour fill = colour("the material's");
        double diffuse = number("Kd" + OR_MORE, MAX);
        double specular = number("Ks" + OR_MORE, MAX);
        double shine = number("Shine" + OR_MORE, MAX);
        double passing = number("T from 0 to 1", 1);
        double index = number("the index of refraction");
        if (passing > 0 && index < 1) {
            text.warn(place, "changed: index of refraction 1, since ours are 1 or more");
            index = 1;
        }
        if (passing > 0 && specular == 0 && shine < 1) {
            text.warn(place, "changed: Shine " + CLEAR + ", which no highlight shows; with less than 1 no light would pass through");
            shine = CLEAR;
        } else if ((passing > 0 || specular > 0) && shine < 1) {
            text.warn(place, "changed: no ray is mirrored or passes through, since Shine below 1 grants none");
        }
        double clear = passing > 0 ? index : 1;
        List<Double> key = DoubleStream.of(fill.r, fill.g, fill.b, diffuse, specular, shine, passing, clear).boxed().toList();
        material = materials.computeIfAbsent(key, values -> material(values.stream().mapToDouble(v -> v).toArray()));
    }

    /** {@return the material of red, green, blue, Kd, Ks, Shine, T and the index} The format has no ambient light. */
    private static Material material(double[] f) {
        Material made = new Material();
        made.diffuse = new Colour(f[0] * f[3], f[1] * f[3], f[2] * f[3]);
        made.ambient = new Colour(made.diffuse);
        made.specular = new Colour(f[4], f[4], f[4]);
        made.shininess = f[5];
        made.transmission = new Colour(f[6], f[6], f[6]);
        made.index = f[7];
        return made;
    }

    private Material required() throws SceneFormatException {
        if (material == null) {
            throw text.error(place, "a material before the first object: f", "the object");
        }
        return material;
    }

    private void readSphere() throws SceneFormatException {
        Material own = required();
        Point centre = point("the sphere's");
        double radius = number("the sphere's radius");
        if (radius == 0) {
            text.warn(place, "left out: a sphere of radius 0");
            return;
        }
        if (radius < 0) {
            text.warn(place, "changed: seen from both sides, not from inside alone");
        }
        scene.add(place, new Sphere(own, centre, Math.abs(radius)));
    }

    private void readCone() throws SceneFormatException {
        Material own = required();
        Point start = point("the base's");
        double startRadius = number("the radius at the base");
        Point end = point("the apex's");
        double endRadius = number("the radius at the apex");
        if (startRadius < 0 && endRadius > 0 || startRadius > 0 && endRadius < 0) {
            throw text.expected("a radius of the same sign as the other");
        }
        boolean flat = start.x == end.x && start.y == end.y && start.z == end.z;
        if (flat || startRadius == 0 && endRadius == 0) {
            text.warn(place, "left out: a cone without " + (flat ? "height" : "radius"));
            return;
        }
        if (startRadius < 0 || endRadius < 0) {
            text.warn(place, "changed: seen from both sides, not from inside alone");
        }
        scene.add(place, new Cone(own, start, Math.abs(startRadius), end, Math.abs(endRadius)));
    }

    private void readPolygon(boolean smooth) throws SceneFormatException {
        Material own = required();
        ForeignText.Place polygon = place;
        text.next();
        int count = text.takeInteger("the number of corners, 1 or more", 1, Integer.MAX_VALUE);
        double[] vertices = new double[3 * MIN_CORNERS];
        double[] normals = smooth ? new double[3 * MIN_CORNERS] : null;
        boolean aimless = false;
        for (int i = 0; i < count; i++) {
            if (3 * i == vertices.length) {
                vertices = Arrays.copyOf(vertices, 2 * vertices.length);
                normals = smooth ? Arrays.copyOf(normals, vertices.length) : null;
            }
            System.arraycopy(numbers("the corner's", AXES), 0, vertices, 3 * i, 3);
            if (smooth) {
                double[] normal = numbers("the normal's", AXES);
                aimless |= normal[0] == 0 && normal[1] == 0 && normal[2] == 0;
                System.arraycopy(normal, 0, normals, 3 * i, 3);
            }
        }
        if (count < MIN_CORNERS) {
            text.warn(polygon, "left out: a polygon of fewer than three corners");
            return;
        }
        if (aimless) {
            text.warn(polygon, "changed: without normals, since one of them is 0 0 0");
        }
        double[] kept = aimless || !smooth ? null : Arrays.copyOf(normals, 3 * count);
        List<Triangle> cut = scene.facets.add(own, Arrays.copyOf(vertices, 3 * count), kept,
            () -> text.warn(polygon, "changed: crosses itself, and so is the fan from its first corner"));
        if (cut.isEmpty()) {
            text.warn(polygon, "left out: a polygon without area");
        }
        cut.forEach(triangle -> scene.add(polygon, triangle));
    }

    /** Warns if something may lie before the hither plane, where the format's programs do not draw it: we see from the eye on. */
    private void findCut() {
        PerspectiveCamera camera = (PerspectiveCamera) scene.settings.newCamera();
        Point eye = camera.eye();
        Point[] corners = new Point[4];
        for (int i = 0; i < corners.length; i++) {
            Vector ray = camera.forward();
            ray.add(Vector.scale(camera.right(), i % 2 == 0 ? -0.5 : 0.5));
            ray.add(Vector.scale(camera.up(), i < 2 ? -0.5 : 0.5));
            corners[i] = Point.add(eye, Vector.scale(ray, hither));
        }
        Bounds near = Bounds.of(eye, corners);
        for (SceneBuilder.Thing thing : scene.things) {
            if (meet(near, thing.object().bounds())) {
                text.warn(hitherAt, "left out: hither, since rays see from the eye on; what is on line " + thing.place().line()
                    + " may lie nearer than it");
                return;
            }
        }
    }

    private static boolean meet(Bounds a, Bounds b) {
        return a.xmin() <= b.xmax() && b.xmin() <= a.xmax() && a.ymin() <= b.ymax() && b.ymin() <= a.ymax() && a.zmin() <= b.zmax()
            && b.zmin() <= a.zmax();
    }
}
