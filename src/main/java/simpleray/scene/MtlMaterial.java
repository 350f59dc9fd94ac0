package simpleray.scene;

import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import simpleray.math.Colour;
import simpleray.text.Diagnostic;
import simpleray.text.SceneFormatException;

/** A material of an MTL file. <em>Mutable</em> while the file is read, and then constant. */
final class MtlMaterial {
    /** What a file may say of a material. */
    enum Property {
        /** The ambient colour. */
        KA,
        /** The diffuse colour. */
        KD,
        /** The specular colour. */
        KS,
        /** The exponent of the highlight. */
        NS,
        /** The opacity, "dissolve". */
        D,
        /** The transparency, 1 - d. */
        TR,
        /** The colour of the light that passes through. */
        TF,
        /** The refractive index. */
        NI,
        /** The number of the illumination model. */
        ILLUM
    }

    /** The illumination models up to this one mirror nothing. */
    private static final int LAST_MATT = 2;

    final String name;
    final String file;
    final int line;
    private final Map<Property, double[]> values = new EnumMap<>(Property.class);
    private final Map<Property, SceneFormatException> problems = new EnumMap<>(Property.class);

    /**
     * Creates a material of which nothing is said yet.
     *
     * @param name its name
     * @param file the MTL file, for people
     * @param line the line on which it begins, from 1
     */
    MtlMaterial(String name, String file, int line) {
        this.name = name;
        this.file = file;
        this.line = line;
    }

    /** Sets what is said; the last word counts. */
    void set(Property property, double[] value) {
        values.put(property, value);
        problems.remove(property);
    }

    /** Notes that what is said is wrong: an error if the picture needs it. */
    void set(Property property, SceneFormatException problem) {
        values.remove(property);
        problems.put(property, problem);
    }

    /** {@return what is wrong} */
    List<Diagnostic> problems() {
        return problems.values().stream().flatMap(problem -> problem.problems().stream()).toList();
    }

    /** {@return whether nothing is wrong that a picture needs} */
    boolean isUsable() {
        try {
            material(new Material());
            return true;
        } catch (SceneFormatException e) {
            return false;
        }
    }

    /**
     * Makes the material.
     *
     * @param own the mesh's own, which gives what the file does not say of ambient, diffuse and specular colour and shininess
     * @return a new one
     * @throws SceneFormatException if something is wrong that it needs
     */
    Material material(Material own) throws SceneFormatException {
        Material made = new Material(own);
        made.ambient = colour(Property.KA, own.ambient);
        made.diffuse = colour(Property.KD, own.diffuse);
        made.specular = colour(Property.KS, own.specular);
        made.shininess = number(Property.NS, own.shininess);
        made.mirror = number(Property.ILLUM, Integer.MAX_VALUE) <= LAST_MATT ? new Colour() : null;
        made.transmission = new Colour();
        made.index = 1;
        double passing = 1 - number(Property.D, 1);
        if (!values.containsKey(Property.D)) {
            passing = number(Property.TR, 0);
        }
        if (passing > 0) {
            made.transmission = colour(Property.TF, new Colour(passing, passing, passing));
            made.index = number(Property.NI, 1);
        }
        return made;
    }

    private double number(Property property, double otherwise) throws SceneFormatException {
        double[] value = value(property);
        return value == null ? otherwise : value[0];
    }

    private Colour colour(Property property, Colour otherwise) throws SceneFormatException {
        double[] value = value(property);
        return value == null ? new Colour(otherwise) : new Colour(value[0], value[1], value[2]);
    }

    private double[] value(Property property) throws SceneFormatException {
        SceneFormatException problem = problems.get(property);
        if (problem != null) {
            throw problem;
        }
        return values.get(property);
    }
}
