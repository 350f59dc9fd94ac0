package simpleray.scene;

import java.io.IOException;
import simpleray.math.Point;
import simpleray.math.Vector;
import simpleray.text.SceneReader;
import simpleray.text.SceneWriter;

/** A light that shines from one point in all directions (thesis, chapter 5). */
public final class PointLight extends Light {
    /** The position of the light. */
    public Point origin;

    /** Creates a white light at the origin. */
    public PointLight() {
        this(new Point());
    }

    /**
     * Creates a white light.
     *
     * @param p its position, referenced
     */
    public PointLight(Point p) {
        origin = p;
    }

    @Override
    public double towards(Point p, Vector l) {
        Vector.subtract(l, origin, p);
        return l.measureAndNormalise();
    }

    @Override
    public Point origin() {
        return origin;
    }

    @Override
    public Light moved(Vector t) {
        Point p = Point.add(origin, t);
        if (!Double.isFinite(p.x) || !Double.isFinite(p.y) || !Double.isFinite(p.z)) {
            throw new IllegalArgumentException(Lengths.FINITE);
        }
        PointLight light = new PointLight(p);
        light.intensity = intensity;
        return light;
    }

    @Override
    public void print(SceneWriter os) throws IOException {
        os.writeString("Point light with colour: ");
        intensity.print(os);
        os.writeString(" and origin: ");
        origin.print(os);
    }

    @Override
    public void read(SceneReader is) throws IOException {
        readIntensity(is);
        origin = Lengths.readPoint(is, "origin");
    }

    @Override
    public void write(SceneWriter os) throws IOException {
        intensity.write(os);
        os.writeString("  ");
        origin.write(os);
    }
}
