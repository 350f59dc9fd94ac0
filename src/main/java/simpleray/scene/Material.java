package simpleray.scene;

import java.io.IOException;
import java.util.Set;
import simpleray.math.Colour;
import simpleray.text.SceneReader;
import simpleray.text.SceneWriter;

/**
 * The optical properties of a surface: ambient, diffuse and specular colour and shininess (thesis, chapters 4 and 5), and transmission
 * (Whitted 1980).
 */
public final class Material {
    private static final Set<String> TRANSMIT = Set.of("transmit");

    /** The share of the scene's ambient light that the surface reflects, Ka. */
    public Colour ambient = new Colour(1, 1, 1);
    /** The share of a light that it scatters evenly, Kd. */
    public Colour diffuse = new Colour(1, 1, 1);
    /** The exponent of the highlight, 0 or more; its whole part is also the most reflections after a hit. */
    public double shininess = 2;
    /** The share of a light in its highlight, and of the mirror ray's colour, Ks. */
    public Colour specular = new Colour();

    /** The share of light that passes through, Kt. */
    public Colour transmission = new Colour();
    /** The refractive index of the inside, 1 or more. */
    public double index = 1;

    /** Creates the default material: white and matt, as the thesis's sphere 2. */
    public Material() {
    }

    /**
     * Creates a copy.
     *
     * @param m the material to copy
     */
    public Material(Material m) {
        ambient = new Colour(m.ambient);
        diffuse = new Colour(m.diffuse);
        specular = new Colour(m.specular);
        shininess = m.shininess;
        transmission = new Colour(m.transmission);
        index = m.index;
    }

    /** {@return the most reflections that follow a hit of this surface: "depends on the shininess" (thesis, chapter 7)} */
    public int reflections() {
        return (int) shininess;
    }

    /**
     * Prints the material as the thesis's Interpretation does, one line without its line break.
     *
     * @param os where to
     * @throws IOException if it cannot be written
     */
    public void print(SceneWriter os) throws IOException {
        os.writeString("Material: ambient ");
        ambient.print(os);
        os.writeString(" diffuse ");
        diffuse.print(os);
        os.writeString(" specular ");
        specular.print(os);
        os.writeString(" shininess ");
        os.writeDouble(shininess);
        if (transmits()) {
            os.writeString(" transmission ");
            transmission.print(os);
            os.writeString(" index ");
            os.writeDouble(index);
        }
    }

    /**
     * Reads the three colours and the shininess, and the transmission if there is one; without it nothing passes through.
     *
     * @param is where from
     * @throws IOException if one is missing or below 0
     */
    public void read(SceneReader is) throws IOException {
        readColour(is, "ambient", ambient);
        readColour(is, "diffuse", diffuse);
        readColour(is, "specular", specular);
        shininess = is.readDouble("shininess");
        if (shininess < 0) {
            is.reject("shininess of 0 or more");
        }
        transmission.reset();
        index = 1;
        if (is.takeKeyword(TRANSMIT) != null) {
            readColour(is, "transmitted", transmission);
            index = is.readDouble("refractive index");
            if (index < 1) {
                is.reject("refractive index of 1 or more");
            }
        }
    }

    /**
     * Writes the material in the form that {@link #read} reads.
     *
     * @param os where to
     * @throws IOException if it cannot be written
     */
    public void write(SceneWriter os) throws IOException {
        ambient.write(os);
        os.writeString("  ");
        diffuse.write(os);
        os.writeString("  ");
        specular.write(os);
        os.writeString("  ");
        os.writeDouble(shininess);
        if (transmits()) {
            os.writeString("  transmit ");
            transmission.write(os);
            os.writeString("  ");
            os.writeDouble(index);
        }
    }

    /** {@return whether another material is equal, bit for bit} */
    boolean isSame(Material m) {
        return isSame(ambient, m.ambient) && isSame(diffuse, m.diffuse) && isSame(specular, m.specular)
            && isSame(shininess, m.shininess) && isSame(transmission, m.transmission) && isSame(index, m.index);
    }

    private static boolean isSame(Colour c, Colour d) {
        return isSame(c.r, d.r) && isSame(c.g, d.g) && isSame(c.b, d.b);
    }

    private static boolean isSame(double c, double d) {
        return Double.doubleToRawLongBits(c) == Double.doubleToRawLongBits(d);
    }

    /** {@return whether the material has a transmission to write} */
    private boolean transmits() {
        return index != 1 || isSaid(transmission.r) || isSaid(transmission.g) || isSaid(transmission.b);
    }

    /** {@return whether a number differs from 0.0 in its bits, as -0.0 does} */
    private static boolean isSaid(double d) {
        return Double.doubleToRawLongBits(d) != 0;
    }

    private static void readColour(SceneReader is, String name, Colour colour) throws IOException {
        is.enter(name);
        colour.read(is);
        is.leave();
    }
}
