package simpleray.scene;

import java.io.IOException;
import simpleray.math.Point;
import simpleray.math.Vector;
import simpleray.text.SceneReader;
import simpleray.text.SceneWriter;

/** A light whose rays are parallel, from infinitely far (thesis, chapter 5). */
public final class DirectionalLight extends Light {
    /** The direction in which the light travels; need not be of unit length, must not be zero. */
    public Vector direction;

    private final UnitVector unit = new UnitVector();

    /** Creates a white light that shines straight down. */
    public DirectionalLight() {
        this(new Vector(0, -1, 0));
    }

    /**
     * Creates a white light.
     *
     * @param v the direction in which it travels, referenced; not zero
     */
    public DirectionalLight(Vector v) {
        direction = v;
    }

    @Override
    public double towards(Point p, Vector l) {
        unit.of(direction, l);
        l.negate();
        return Double.POSITIVE_INFINITY;
    }

    @Override
    public Point origin() {
        return null;
    }

    @Override
    public Light moved(Vector t) {
        DirectionalLight light = new DirectionalLight(direction);
        light.intensity = intensity;
        return light;
    }

    @Override
    public boolean isDistant() {
        return true;
    }

    @Override
    public void print(SceneWriter os) throws IOException {
        os.writeString("Directional light with colour: ");
        intensity.print(os);
        os.writeString(" and direction: ");
        direction.print(os);
    }

    @Override
    public void read(SceneReader is) throws IOException {
        readIntensity(is);
        direction = new Vector();
        Directions.read(is, "direction", direction);
    }

    @Override
    public void write(SceneWriter os) throws IOException {
        intensity.write(os);
        os.writeString("  ");
        direction.write(os);
    }
}
