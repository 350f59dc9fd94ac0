package simpleray.scene;

import java.io.IOException;
import simpleray.math.Colour;
import simpleray.math.Point;
import simpleray.math.Vector;
import simpleray.text.SceneReader;
import simpleray.text.SceneWriter;

/** What each kind of light extends (thesis, chapter 5). */
public abstract class Light implements SceneElement {
    /** The colour of the light, LC; it does not fall off with distance. */
    public Colour intensity = new Colour(1, 1, 1);

    /** Creates a white light. */
    public Light() {
    }

    /**
     * Finds where the light is, seen from a point. Any thread may call.
     *
     * @param p the point
     * @param l gets the unit vector towards the light; zero if the light is at the very point
     * @return the distance to the light, infinite if it comes from infinitely far
     */
    public abstract double towards(Point p, Vector l);

    /**
     * Finds where all rays of the light start, so that what lies in each direction from there can be listed once for all of them.
     *
     * @return the point itself, not a copy; null if there is no such point: then shadow rays find their way through the scene one by one
     */
    public abstract Point origin();

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
     * @throws IOException if it is not there or makes no light
     */
    @Override
    public abstract void read(SceneReader is) throws IOException;

    /**
     * Writes the light, so that {@link #read} gets an equal one.
     *
     * @param os where to
     * @throws IOException if it cannot be written
     */
    @Override
    public abstract void write(SceneWriter os) throws IOException;

    /**
     * Reads the colour, with which each kind of light begins.
     *
     * @param is where from
     * @throws IOException if it is not there
     */
    protected final void readIntensity(SceneReader is) throws IOException {
        is.enter("colour");
        intensity.read(is);
        is.leave();
    }
}
