package simpleray.scene;

import java.io.IOException;
import java.util.Set;
import simpleray.math.Colour;
import simpleray.text.SceneReader;
import simpleray.text.SceneWriter;

/**
 * The optical properties of a surface: ambient, diffuse and specular colour and shininess (thesis, chapters 4 and 5), transmission
 * (Whitted 1980), and a mirror image that may differ from the highlight.
 */
public final class Material {
    private static final String MIRROR = "mirror";
    private static final Set<String> KEYWORDS = Set.of(MIRROR, "transmit");
    private static final String MTL = "mtl";
    private static final Set<String> ONLY_MTL = Set.of(MTL);
    private static final Set<String> MESH_KEYWORDS = Set.of(MIRROR, "transmit", MTL);

    /** The share of the scene's ambient light that the surface reflects, Ka. */
    public Colour ambient = new Colour(1, 1, 1);
    /** The share of a light that it scatters evenly, Kd. */
    public Colour diffuse = new Colour(1, 1, 1);
    /** The exponent of the highlight, 0 or more; its whole part is also the most reflections after a hit. */
    public double shininess = 2;
    /** The share of a light in its highlight, Ks; unless {@link #mirror} is given, also that of the mirror ray's colour. */
    public Colour specular = new Colour();
    /** The share of the mirror ray's colour; null for Ks. */
    public Colour mirror;

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
        mirror = m.mirror == null ? null : new Colour(m.mirror);
        shininess = m.shininess;
        transmission = new Colour(m.transmission);
        index = m.index;
    }

    /** {@return the share of the mirror ray's colour: the one given, or else Ks} Not a copy. */
    public Colour mirrored() {
        return mirror == null ? specular : mirror;
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
        if (mirror != null) {
            os.writeString(" mirror ");
            mirror.print(os);
        }
        if (transmits()) {
            os.writeString(" transmission ");
            transmission.print(os);
            os.writeString(" index ");
            os.writeDouble(index);
        }
    }

    /**
     * Reads the three colours and the shininess, and the mirror ray's share and the transmission where they are given; without these
     * Ks is the share, and nothing passes through.
     *
     * @param is where from
     * @throws IOException if one is missing or below 0
     */
    public void read(SceneReader is) throws IOException {
        read(is, KEYWORDS);
    }

    /** Reads the material of a mesh. {@return whether the word {@code mtl} comes after it} */
    boolean readOfMesh(SceneReader is) throws IOException {
        boolean mtl = read(is, MESH_KEYWORDS) != null;
        while (mtl && is.takeKeyword(ONLY_MTL) != null) {
            onlyOnce(is, MTL);
        }
        return mtl;
    }

    /** Reads a material. {@return the keyword after it, which is none of a material; null if there is none} */
    private String read(SceneReader is, Set<String> keywords) throws IOException {
        readColour(is, "ambient", ambient);
        readColour(is, "diffuse", diffuse);
        readColour(is, "specular", specular);
        shininess = is.readDouble("shininess");
        if (shininess < 0) {
            is.reject("shininess of 0 or more");
        }
        mirror = null;
        transmission.reset();
        index = 1;
        boolean transmits = false;
        String word = is.takeKeyword(keywords);
        for (; word != null && !word.equals(MTL); word = is.takeKeyword(keywords)) {
            if (word.equals(MIRROR) ? mirror != null : transmits) {
                onlyOnce(is, word);
            }
            if (word.equals(MIRROR)) {
                mirror = new Colour();
                readColour(is, "mirrored", mirror);
            } else {
                transmits = true;
                readTransmission(is);
            }
        }
        return word;
    }

    private static void onlyOnce(SceneReader is, String keyword) throws IOException {
        is.reject("keyword " + keyword + " only once");
    }

    private void readTransmission(SceneReader is) throws IOException {
        readColour(is, "transmitted", transmission);
        index = is.readDouble("refractive index");
        if (index < 1) {
            is.reject("refractive index of 1 or more (a bubble in glass: docs/pictures.md)");
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
        if (mirror != null) {
            os.writeString("  mirror ");
            mirror.write(os);
        }
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
            && (mirror == null ? m.mirror == null : m.mirror != null && isSame(mirror, m.mirror))
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
