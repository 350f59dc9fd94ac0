package simpleray.pov;

import java.io.IOException;
import simpleray.math.Colour;
import simpleray.math.Point;
import simpleray.math.Vector;
import simpleray.scene.AreaLight;
import simpleray.scene.Camera;
import simpleray.scene.Cone;
import simpleray.scene.Cylinder;
import simpleray.scene.DirectionalLight;
import simpleray.scene.Light;
import simpleray.scene.Mesh;
import simpleray.scene.Object;
import simpleray.scene.ParallelCamera;
import simpleray.scene.PerspectiveCamera;
import simpleray.scene.Plane;
import simpleray.scene.PointLight;
import simpleray.scene.SceneSettings;
import simpleray.scene.SimpleCamera;
import simpleray.scene.Sphere;
import simpleray.scene.Triangle;
import simpleray.text.SceneWriter;

/**
 * Writes cameras, lights and shapes in POV-Ray's scene language. Vectors are written unchanged, so that POV-Ray has our right-handed
 * axes. Other kinds are refused.
 */
final class PovWriter {
    /** The distance of a directional light in POV-Ray, which has no infinity. */
    private static final double DISTANCE = 1e6;
    /** The most points along a side of a block of an area light. */
    private static final int MAX_BLOCK = 4;

    private PovWriter() {
    }

    /** Writes a number after some text. */
    static void value(SceneWriter os, String before, double value) throws IOException {
        os.writeString(before);
        os.writeDouble(value);
    }

    /** Writes a colour after some text. */
    static void colour(SceneWriter os, String before, Colour c) throws IOException {
        triple(os, before + "rgb <", c.r, c.g, c.b);
    }

    private static void point(SceneWriter os, String before, Point p) throws IOException {
        triple(os, before + '<', p.x, p.y, p.z);
    }

    private static void vector(SceneWriter os, String before, Vector v) throws IOException {
        triple(os, before + '<', v.x, v.y, v.z);
    }

    private static void triple(SceneWriter os, String before, double x, double y, double z) throws IOException {
        value(os, before, x + 0.0);                           // -0.0 becomes 0.0
        value(os, ",", y + 0.0);
        value(os, ",", z + 0.0);
        os.writeChar('>');
    }

    /** Writes a camera. */
    static void camera(SceneWriter os, Camera camera) throws IOException {
        if (camera instanceof SimpleCamera simple) {
            SceneSettings.Window w = simple.window();
            Vector direction = new Vector((w.xmin() + w.xmax()) / 2, (w.ymin() + w.ymax()) / 2, -camera.eye().z);
            camera(os, "perspective", camera.eye(), direction, new Vector(w.xmax() - w.xmin(), 0, 0),
                new Vector(0, w.ymax() - w.ymin(), 0));
        } else if (camera instanceof PerspectiveCamera perspective) {
            camera(os, "perspective", camera.eye(), perspective.forward(), perspective.right(), perspective.up());
        } else if (camera instanceof ParallelCamera parallel) {
            camera(os, "orthographic", parallel.middle(), parallel.forward(), parallel.right(), parallel.up());
        } else {
            throw unknown("", camera);
        }
    }

    private static void camera(SceneWriter os, String kind, Point eye, Vector direction, Vector right, Vector up) throws IOException {
        point(os, "camera { " + kind + " location ", eye);
        vector(os, " direction ", direction);
        vector(os, " right ", right);
        vector(os, " up ", up);
        os.writeString(" }\n");
    }

    /**
     * Writes a light.
     *
     * @param light the light
     * @param place its index in the scene, for the message if POV-Ray has no such light
     * @param colour the colour to write in place of its own
     */
    static void light(SceneWriter os, Light light, int place, Colour colour) throws IOException {
        if (light instanceof PointLight lamp) {
            point(os, "light_source { ", lamp.origin);
            colour(os, ", ", colour);
            os.writeString(" }\n");
        } else if (light instanceof DirectionalLight sun) {
            vector(os, "light_source { ", Vector.scale(sun.direction.normalised(), -DISTANCE));
            colour(os, ", ", colour);
            os.writeString(" parallel point_at <0,0,0> }\n");
        } else if (light instanceof AreaLight area) {
            area(os, area, colour);
        } else {
            throw unknown("light " + (place + 1) + ": ", light);
        }
    }

    /**
     * Writes an area light in square blocks of 1, 2 or 4 points a side. POV-Ray multiplies the mean shadow of its points by their mean
     * light, which is right for points that are close together, and weighs them alike only if their number along a side is a power of
     * two. Its points lie from edge to edge of its area, and not in the middles of cells.
     */
    private static void area(SceneWriter os, AreaLight area, Colour colour) throws IOException {
        int n = area.side;
        PointLight first = new PointLight();
        PointLight last = new PointLight();
        for (int row = 0, height; row < n; row += height) {
            height = block(n, n - row);
            for (int column = 0, width; column < n; column += width) {
                width = Math.min(height, block(n, n - column));
                for (int top = row; top < row + height; top += width) {
                    area.point(top * n + column, first);
                    area.point((top + width - 1) * n + column + width - 1, last);
                    Vector across = Vector.subtract(last.origin, first.origin);
                    point(os, "light_source { ", Point.add(first.origin, Vector.scale(across, 0.5)));
                    colour(os, ", ", Colour.scale(colour, (double) width * width / (n * n)));
                    if (width > 1) {
                        vector(os, " area_light ", Vector.scale(area.u, (width - 1.0) / n));
                        vector(os, ", ", Vector.scale(area.v, (width - 1.0) / n));
                        os.writeString(", " + width + ", " + width + " area_illumination on");
                    }
                    os.writeString(" }\n");
                }
            }
        }
    }

    /** {@return the side of a block of an area light of n points a side, so many of them left} A power of two, at most a fourth of n. */
    private static int block(int n, int left) {
        return Integer.highestOneBit(Math.max(1, Math.min(left, Math.min(n / 4, MAX_BLOCK))));
    }

    /**
     * Writes a shape without its material and without the closing brace. The vertices of a triangle are written in reverse order, since
     * its normal in POV-Ray points the other way.
     *
     * @param object the shape
     * @param place its index in the scene, for the message if POV-Ray has no such shape
     */
    static void shape(SceneWriter os, Object object, int place) throws IOException {
        if (object instanceof Sphere sphere) {
            point(os, "sphere { ", sphere.centre);
            value(os, ", ", sphere.radius);
        } else if (object instanceof Plane plane) {           // POV-Ray has the same side inside
            vector(os, "plane { ", plane.normal.normalised());
            value(os, ", ", plane.constant / plane.normal.norm());
        } else if (object instanceof Triangle triangle) {
            point(os, "triangle { ", triangle.a);
            point(os, ", ", triangle.c);
            point(os, ", ", triangle.b);
        } else if (object instanceof Cylinder cylinder) {
            point(os, "cylinder { ", cylinder.start);
            point(os, ", ", cylinder.end);
            value(os, ", ", cylinder.radius);
        } else if (object instanceof Cone cone) {
            point(os, "cone { ", cone.start);
            value(os, ", ", cone.startRadius);
            point(os, ", ", cone.end);
            value(os, ", ", cone.endRadius);
            os.writeString(" open");
        } else if (object instanceof Mesh mesh) {
            mesh(os, mesh);
        } else {
            throw unknown("object " + (place + 1) + ": ", object);
        }
    }

    private static void mesh(SceneWriter os, Mesh mesh) throws IOException {
        os.writeString("mesh {\n");
        for (int i = 0; i < mesh.size(); i++) {
            boolean smooth = mesh.vertexNormal(i, 0) != null;
            String before = smooth ? "smooth_triangle { " : "triangle { ";
            for (int corner : new int[] {0, 2, 1}) {
                point(os, before, mesh.vertex(i, corner));
                if (smooth) {
                    vector(os, ", ", mesh.vertexNormal(i, corner));
                }
                before = ", ";
            }
            os.writeString(" }\n");
        }
        os.writeString("inside_vector <0.1, 0.2, 1>");
    }

    private static UnsupportedOperationException unknown(String where, java.lang.Object thing) {
        return new UnsupportedOperationException(where + "no form for POV-Ray is known of a " + thing.getClass().getSimpleName());
    }
}
