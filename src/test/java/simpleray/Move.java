package simpleray;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Locale;
import simpleray.math.Point;
import simpleray.math.Ray;
import simpleray.math.Vector;
import simpleray.scene.AreaLight;
import simpleray.scene.Camera;
import simpleray.scene.Cone;
import simpleray.scene.Cylinder;
import simpleray.scene.DirectionalLight;
import simpleray.scene.Light;
import simpleray.scene.Mesh;
import simpleray.scene.Object;
import simpleray.scene.PerspectiveCamera;
import simpleray.scene.Plane;
import simpleray.scene.PointLight;
import simpleray.scene.Scene;
import simpleray.scene.Sphere;
import simpleray.scene.Triangle;

/**
 * A way to move all of a scene, with its lights and the camera, that changes no picture: turned or mirrored, then enlarged, then
 * shifted. <em>Constant.</em>
 *
 * @param x where the unit vector along x comes to point
 * @param y the same of y
 * @param z the same of z; the three are at right angles, and of unit length
 * @param scale how many times as large
 * @param shift how far it is shifted in the end
 */
record Move(Vector x, Vector y, Vector z, double scale, Vector shift) {
    /** Nothing is moved. */
    static final Move NONE = new Move(new Vector(1, 0, 0), new Vector(0, 1, 0), new Vector(0, 0, 1), 1, new Vector());

    /** {@return a turn by an angle in degrees about an axis of any length (Rodrigues' formula)} */
    static Move turned(Vector axis, double degrees) {
        Vector a = axis.normalised();
        double sin = StrictMath.sin(StrictMath.toRadians(degrees));
        double cos = StrictMath.cos(StrictMath.toRadians(degrees));
        Vector[] to = {new Vector(1, 0, 0), new Vector(0, 1, 0), new Vector(0, 0, 1)};
        for (int i = 0; i < to.length; i++) {
            Vector across = Vector.cross(a, to[i]);
            Vector along = Vector.scale(a, (1 - cos) * a.dot(to[i]));
            to[i] = Vector.add(Vector.add(Vector.scale(to[i], cos), Vector.scale(across, sin)), along);
        }
        return new Move(to[0], to[1], to[2], 1, new Vector());
    }

    /** {@return all this many times as large as here} */
    Move scaled(double factor) {
        return new Move(x, y, z, scale * factor, Vector.scale(shift, factor));
    }

    /** {@return all shifted so far from here} */
    Move shifted(double dx, double dy, double dz) {
        return new Move(x, y, z, scale, Vector.add(shift, new Vector(dx, dy, dz)));
    }

    /** {@return left and right exchanged, and then all else} */
    Move mirrored() {
        return new Move(Vector.negate(x), y, z, scale, shift);
    }

    private boolean mirrors() {
        return Vector.cross(x, y).dot(z) < 0;
    }

    /** {@return where a direction comes to point} */
    Vector direction(Vector v) {
        return Vector.add(Vector.add(Vector.scale(x, v.x), Vector.scale(y, v.y)), Vector.scale(z, v.z));
    }

    /** {@return where a point comes to lie} */
    Point point(Point p) {
        return Point.add(new Point(), Vector.add(Vector.scale(direction(new Vector(p)), scale), shift));
    }

    /** {@return the scene, moved; of the same materials} */
    Scene scene(Scene of, Path folder) throws IOException {
        Scene moved = new Scene();
        moved.ambient = of.ambient;
        moved.settings = of.settings;
        moved.setNumberObjects(of.getNumberObjects());
        for (int i = 0; i < of.getNumberObjects(); i++) {
            moved.setObject(i, object(of.getObject(i), folder));
        }
        moved.setNumberLights(of.getNumberLights());
        for (int i = 0; i < of.getNumberLights(); i++) {
            moved.setLight(i, light(of.getLight(i)));
        }
        return moved;
    }

    private Light light(Light of) {
        Light light = of instanceof PointLight p ? new PointLight(point(p.origin))
            : of instanceof AreaLight a
            ? new AreaLight(point(a.corner), Vector.scale(direction(a.u), scale), Vector.scale(direction(a.v), scale), a.side)
            : new DirectionalLight(direction(((DirectionalLight) of).direction));
        light.intensity = of.intensity;
        return light;
    }

    private Object object(Object of, Path folder) throws IOException {
        if (of instanceof Sphere s) {
            return new Sphere(s.surfaceMaterial, point(s.centre), scale * s.radius);
        }
        if (of instanceof Plane p) {
            Vector normal = direction(p.normal);
            return new Plane(p.surfaceMaterial, normal, scale * p.constant + normal.dot(shift));
        }
        if (of instanceof Triangle t) {                       // a mirror turns the order of its corners round
            return mirrors() ? new Triangle(t.surfaceMaterial, point(t.a), point(t.c), point(t.b))
                : new Triangle(t.surfaceMaterial, point(t.a), point(t.b), point(t.c));
        }
        if (of instanceof Cylinder c) {
            return new Cylinder(c.surfaceMaterial, point(c.start), point(c.end), scale * c.radius);
        }
        if (of instanceof Cone c) {
            return new Cone(c.surfaceMaterial, point(c.start), scale * c.startRadius, point(c.end), scale * c.endRadius);
        }
        Mesh m = (Mesh) of;
        Path turned = Files.createTempFile(folder, "turned", ".obj");
        Files.write(turned, Files.readAllLines(Path.of(m.file)).stream().map(this::objLine).toList());
        return new Mesh(m.surfaceMaterial, turned.toString(), point(m.offset), scale * m.scale);
    }

    /** {@return a line of an OBJ file, turned or mirrored; its size and place are the mesh's own} */
    private String objLine(String line) {
        List<String> words = new ArrayList<>(List.of(line.split(" ")));
        if (words.get(0).startsWith("v")) {
            Vector to = direction(new Vector(Double.parseDouble(words.get(1)), Double.parseDouble(words.get(2)),
                Double.parseDouble(words.get(3))));
            return String.format(Locale.ROOT, "%s %.17g %.17g %.17g", words.get(0), to.x, to.y, to.z);
        }
        if (words.get(0).equals("f") && mirrors()) {
            Collections.reverse(words.subList(2, words.size()));
        }
        return String.join(" ", words);
    }

    /** {@return a free camera's pose, moved; what is up in its picture stays up only if this turns about no other axis than y} */
    PerspectiveCamera.Pose pose(PerspectiveCamera.Pose of) {
        Point eye = point(new Point(of.ex(), of.ey(), of.ez()));
        Point at = point(new Point(of.lx(), of.ly(), of.lz()));
        return new PerspectiveCamera.Pose(eye.x, eye.y, eye.z, at.x, at.y, at.z, of.fov());
    }

    /** {@return a camera that sees moved scenes as another sees the others, however they are turned} */
    Camera camera(Camera of) {
        return new Camera() {
            @Override
            public int width() {
                return of.width();
            }

            @Override
            public int height() {
                return of.height();
            }

            @Override
            public Point eye() {
                return point(of.eye());
            }

            @Override
            public void through(double px, double py, Ray ray) {
                of.through(px, py, ray);
                ray.origin.copy(point(ray.origin));
                ray.direction.copy(direction(ray.direction));
                ray.direction.normalise();
            }
        };
    }
}
