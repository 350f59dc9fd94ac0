package simpleray.scene;

import java.io.IOException;
import simpleray.math.Point;
import simpleray.math.Vector;
import simpleray.text.SceneReader;
import simpleray.text.SceneWriter;

/**
 * A light in the shape of a parallelogram, and so with soft shadows: point lights in the centres of its n × n equal cells share its colour
 * (Cook, Porter and Carpenter, "Distributed Ray Tracing", 1984, without their noise). No ray hits it.
 */
public final class AreaLight extends Light {
    /** The most points along an edge. */
    public static final int MAX_SIDE = 64;

    /** A corner. */
    public Point corner;
    /** The edge that leads from the corner along a row of cells. */
    public Vector u;
    /** The other edge at the corner, along a column of cells; not parallel to u. */
    public Vector v;
    /** The number of points along each edge, n, from 1 to {@link #MAX_SIDE}. */
    public int side;

    /** Creates a white light of 1 point, a square of size 1 about the origin that is level. */
    public AreaLight() {
        this(new Point(-0.5, 0, -0.5), new Vector(1, 0, 0), new Vector(0, 0, 1), 1);
    }

    /**
     * Creates a white light.
     *
     * @param p a corner, referenced
     * @param alongRow an edge at the corner, referenced
     * @param alongColumn the other edge, referenced; not parallel to it
     * @param n the number of points along each edge, from 1 to {@link #MAX_SIDE}
     */
    public AreaLight(Point p, Vector alongRow, Vector alongColumn, int n) {
        corner = p;
        u = alongRow;
        v = alongColumn;
        side = n;
    }

    /** {@return the number of points, n²} */
    public int points() {
        return side * side;
    }

    /**
     * Computes one of the points. They are numbered row by row: first along u, then along v.
     *
     * @param i its number, from 0
     * @param lamp becomes the point light there, its colour this one's divided by n²
     */
    public void point(int i, PointLight lamp) {
        double alongU = (i % side + 0.5) / side;
        int row = i / side;
        double alongV = (row + 0.5) / side;
        lamp.origin.set(corner.x + alongU * u.x + alongV * v.x, corner.y + alongU * u.y + alongV * v.y,
            corner.z + alongU * u.z + alongV * v.z);
        int all = points();
        lamp.intensity.r = intensity.r / all;
        lamp.intensity.g = intensity.g / all;
        lamp.intensity.b = intensity.b / all;
    }

    /** {@inheritDoc} Of an area light it is the middle that counts. */
    @Override
    public double towards(Point p, Vector l) {
        l.set(corner.x + (u.x + v.x) / 2 - p.x, corner.y + (u.y + v.y) / 2 - p.y, corner.z + (u.z + v.z) / 2 - p.z);
        return l.measureAndNormalise();
    }

    /** {@return null: its rays start from many points} */
    @Override
    public Point origin() {
        return null;
    }

    @Override
    public Light moved(Vector t) {
        AreaLight light = new AreaLight(Lengths.moved(corner, t), u, v, side);
        light.intensity = intensity;
        return light;
    }

    @Override
    public void print(SceneWriter os) throws IOException {
        os.writeString("Area light with colour: ");
        intensity.print(os);
        os.writeString(" and corner: ");
        corner.print(os);
        os.writeString(" and edges: ");
        u.print(os);
        os.writeString(" and ");
        v.print(os);
        os.writeString(" and points along each: " + side);
    }

    @Override
    public void read(SceneReader is) throws IOException {
        readIntensity(is);
        is.group();
        corner = Lengths.readPoint(is, "corner");
        Lengths.check(is, "corner", corner.x, corner.y, corner.z);
        is.group();
        u = readEdge(is, "edge u");
        v = readEdge(is, "edge v");
        if (new Triangle(null, new Point(), new Point(u.x, u.y, u.z), new Point(v.x, v.y, v.z)).isFlat()) {
            is.rejectGroup("edges u and v that span an area");
        }
        Lengths.check(is, "edges", u.x, u.y, u.z, v.x, v.y, v.z);
        side = is.readInt("number of points along each edge from 1 to " + MAX_SIDE, 1, MAX_SIDE);
    }

    private static Vector readEdge(SceneReader is, String name) throws IOException {
        Vector edge = new Vector();
        is.enter(name);
        edge.read(is);
        is.leave();
        return edge;
    }

    @Override
    public void write(SceneWriter os) throws IOException {
        intensity.write(os);
        os.writeString("  ");
        corner.write(os);
        os.writeString("  ");
        u.write(os);
        os.writeString("  ");
        v.write(os);
        os.writeString("  ");
        os.writeInt(side);
    }
}
