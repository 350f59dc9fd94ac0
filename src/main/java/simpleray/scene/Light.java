package simpleray.scene;

import java.io.IOException;
import simpleray.math.Colour;
import simpleray.math.Point;
import simpleray.math.Vector;
import simpleray.text.SceneReader;
import simpleray.text.SceneWriter;

/** A light: the superclass of each kind (thesis, chapter 5). */
public abstract class Light implements SceneElement {
    /** The colour of the light, LC; it does not fade with distance. */
    public Colour intensity = new Colour(1, 1, 1);

    private static final Vector NOWHERE = new Vector(-0.0, -0.0, -0.0);   // which changes no number, not even -0.0

    /** Creates a white light. */
    public Light() {
    }

    /**
     * Computes the direction and the distance of the light from a point. Any thread may call.
     *
     * @param p the point
     * @param l gets the unit vector towards the light; zero if the light is at the point
     * @return the distance to the light, infinite if it comes from infinitely far
     */
    public abstract double towards(Point p, Vector l);

    /**
     * Returns the point from which all rays of the light start, for a light buffer.
     *
     * @return the point itself, not a copy; null if there is none, and so no light buffer
     */
    public abstract Point origin();

    /**
     * Returns this light in another place. Any thread may call.
     *
     * @param t the offset from where it is; without effect on a light that is infinitely far
     * @return a new light, of the same colour
     * @throws IllegalArgumentException if no scene may have it there; the message says what is expected
     */
    public abstract Light moved(Vector t);

    /**
     * Returns this light in another colour. Any thread may call.
     *
     * @param colour the colour, referenced
     * @return a new light, in the same place
     */
    public final Light coloured(Colour colour) {
        Light light = moved(NOWHERE);
        light.intensity = colour;
        return light;
    }

    /** {@return whether it is infinitely far, and so cannot be moved} */
    public boolean isDistant() {
        return false;
    }

    /**
     * Prints the light as the thesis's Interpretation does, one line without its line break.
     *
     * @param os where to
     * @throws IOException if it cannot be written
     */
    @Override
    public abstract void print(SceneWriter os) throws IOException;

    /**
     * Reads the light, all but the code of its kind.
     *
     * @param is where from
     * @throws IOException if it is missing or is no light
     */
    @Override
    public abstract void read(SceneReader is) throws IOException;

    /**
     * Writes the light in the form that {@link #read} reads.
     *
     * @param os where to
     * @throws IOException if it cannot be written
     */
    @Override
    public abstract void write(SceneWriter os) throws IOException;

    /**
     * Reads the colour, the first value of each kind of light.
     *
     * @param is where from
     * @throws IOException if it is missing
     */
    protected final void readIntensity(SceneReader is) throws IOException {
        is.enter("colour");
        intensity.read(is);
        is.leave();
    }
}
