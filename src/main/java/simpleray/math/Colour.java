package simpleray.math;

import java.io.IOException;
import simpleray.text.SceneReader;
import simpleray.text.SceneWriter;

/**
 * A colour, or an amount of light, in linear RGB, nominally 0.0 to 1.0 (thesis, chapter 5). <em>Mutable.</em> Values above 1.0 are
 * allowed; they are clamped when a picture stores them.
 */
public final class Colour {
    /** The red component. */
    public double r;
    /** The green component. */
    public double g;
    /** The blue component. */
    public double b;

    /** Creates black. */
    public Colour() {
    }

    /**
     * Creates a copy.
     *
     * @param c the colour to copy
     */
    public Colour(Colour c) {
        copy(c);
    }

    /**
     * Creates a colour.
     *
     * @param r the red component
     * @param g the green component
     * @param b the blue component
     */
    public Colour(double r, double g, double b) {
        set(r, g, b);
    }

    /**
     * Makes this a copy.
     *
     * @param c the colour to copy
     */
    public void copy(Colour c) {
        set(c.r, c.g, c.b);
    }

    /** Makes this black. */
    public void reset() {
        set(0, 0, 0);
    }

    /**
     * Adds to this colour.
     *
     * @param c the colour to add
     */
    public void add(Colour c) {
        add(this, this, c);
    }

    /**
     * Adds two colours.
     *
     * @param c1 the first
     * @param c2 the second
     * @return a new colour, c1 + c2
     */
    public static Colour add(Colour c1, Colour c2) {
        Colour sum = new Colour();
        add(sum, c1, c2);
        return sum;
    }

    /**
     * Adds two colours.
     *
     * @param cd gets c1 + c2; may be one of them
     * @param c1 the first
     * @param c2 the second
     */
    public static void add(Colour cd, Colour c1, Colour c2) {
        cd.set(c1.r + c2.r, c1.g + c2.g, c1.b + c2.b);
    }

    /**
     * Multiplies this colour component by component, as light of colour c on a surface of this colour.
     *
     * @param c the other colour
     */
    public void mult(Colour c) {
        mult(this, this, c);
    }

    /**
     * Multiplies two colours, component by component.
     *
     * @param c1 the first
     * @param c2 the second
     * @return a new colour, c1 c2
     */
    public static Colour mult(Colour c1, Colour c2) {
        Colour product = new Colour();
        mult(product, c1, c2);
        return product;
    }

    /**
     * Multiplies two colours, component by component.
     *
     * @param cd gets c1 c2; may be one of them
     * @param c1 the first
     * @param c2 the second
     */
    public static void mult(Colour cd, Colour c1, Colour c2) {
        cd.set(c1.r * c2.r, c1.g * c2.g, c1.b * c2.b);
    }

    /**
     * Scales this colour.
     *
     * @param s the factor
     */
    public void scale(double s) {
        scale(this, this, s);
    }

    /**
     * Scales a colour.
     *
     * @param c1 the colour
     * @param s the factor
     * @return a new colour, s c1
     */
    public static Colour scale(Colour c1, double s) {
        Colour scaled = new Colour();
        scale(scaled, c1, s);
        return scaled;
    }

    /**
     * Scales a colour.
     *
     * @param cd gets s c1; may be c1
     * @param c1 the colour
     * @param s the factor
     */
    public static void scale(Colour cd, Colour c1, double s) {
        cd.set(c1.r * s, c1.g * s, c1.b * s);
    }

    /** Clamps each component to 0.0 to 1.0. */
    public void clamp() {
        set(clamp(r), clamp(g), clamp(b));
    }

    /** {@return whether all components are 0} */
    public boolean isBlack() {
        return r == 0 && g == 0 && b == 0;
    }

    /**
     * Reads the three components.
     *
     * @param is where from
     * @throws IOException if one is missing or below 0
     */
    public void read(SceneReader is) throws IOException {
        read(is, "red");
    }

    /**
     * Reads the three components, where something else could stand, too.
     *
     * @param is where from
     * @param wanted what could stand in place of red, for the message
     * @throws IOException if one is missing or below 0
     */
    public void read(SceneReader is, String wanted) throws IOException {
        set(component(is, "red", wanted), component(is, "green", "green"), component(is, "blue", "blue"));
    }

    /**
     * Writes the three components, in the form that {@link #read} reads.
     *
     * @param os where to
     * @throws IOException if they cannot be written
     */
    public void write(SceneWriter os) throws IOException {
        os.writeDouble(r);
        os.writeDouble(g);
        os.writeDouble(b);
    }

    /**
     * Prints the colour as {@code (r,g,b)}.
     *
     * @param os where to
     * @throws IOException if it cannot be written
     */
    public void print(SceneWriter os) throws IOException {
        os.writeChar('(');
        os.writeDouble(r);
        os.writeChar(',');
        os.writeDouble(g);
        os.writeChar(',');
        os.writeDouble(b);
        os.writeChar(')');
    }

    /** {@return the colour as {@code (r,g,b)}} */
    @Override
    public String toString() {
        return "(" + r + ',' + g + ',' + b + ')';
    }

    private void set(double red, double green, double blue) {
        r = red;
        g = green;
        b = blue;
    }

    private static double clamp(double c) {
        return Math.min(1, Math.max(0, c));
    }

    private static double component(SceneReader is, String field, String wanted) throws IOException {
        double value = is.readDouble(field, wanted);
        if (value < 0) {
            is.reject(field + " of 0 or more");
        }
        return value;
    }
}
