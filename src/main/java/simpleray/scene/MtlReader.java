package simpleray.scene;

import java.io.IOException;
import java.io.InputStream;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import simpleray.scene.MtlMaterial.Property;
import simpleray.text.BadNumber;
import simpleray.text.Diagnostic;
import simpleray.text.NumberParser;
import simpleray.text.SceneFormatException;

/**
 * Reads the materials of an MTL file, which belongs to an OBJ. <em>Mutable,</em> for one thread.
 *
 * <p>Of the format (Wavefront, "Advanced Visualizer Manual", appendix B2) these lines are read, and all others are skipped:
 * <pre>
 * newmtl name                        a material; blanks within the name belong to it
 * Ka r g b    Kd    Ks    Tf         its colours; one number alone is a grey
 * Ns n                               the exponent of the highlight
 * d  n        Tr n                   how opaque it is, or how transparent; d counts if both are there
 * Ni n                               the refractive index
 * illum n                            the illumination model
 * </pre>
 */
final class MtlReader {
    private static final Map<String, Property> COLOURS = Map.of("ka", Property.KA, "kd", Property.KD, "ks", Property.KS, "tf", Property.TF);
    private static final Map<String, Property> NUMBERS = Map.of("ns", Property.NS, "d", Property.D, "tr", Property.TR, "ni", Property.NI,
        "illum", Property.ILLUM);
    private static final Set<String> TEXTURES = Set.of("bump", "disp", "decal", "refl", "norm");
    private static final Set<String> SPECTRA = Set.of("spectral", "xyz");
    private static final Set<String> KEYWORDS = Set.of("newmtl", "Ka", "Kd", "Ks", "Tf", "Ns", "d", "Tr", "Ni", "illum");
    private static final String[] AXES = {" red", " green", " blue"};
    private static final int MAX_MODEL = 10;

    private final LineReader lines;
    private final Skipped skipped;
    private final List<MtlMaterial> materials = new ArrayList<>();
    private final Set<String> names = new HashSet<>();
    private boolean named;                                    // whether a newmtl with a name is above, and none without behind it
    private int begin;                                        // of the latest word of the line
    private int at;                                           // after it

    /** What is passed over in all MTL files of an OBJ. */
    static final class Skipped {
        final PassedOver textures = new PassedOver("colours", "texture, which is passed over", "textures, which are passed over");
        final PassedOver spectra = new PassedOver("colours as red, green and blue", "as a spectrum or as xyz, which is passed over",
            "as spectra or as xyz, which are passed over");
        final PassedOver nameless = new PassedOver("newmtl with a name before a material's values", "value without, which is passed over",
            "values without, which are passed over");
        final PassedOver again = new PassedOver("a name of its own for each material", "that is there before, and of which the first counts",
            "that are there before, and of which the first count");
        final PassedOver joined = new PassedOver("a line of its own for each keyword", "line that the backslash before it joins to another",
            "lines that the backslash before them joins to others");

        List<PassedOver> all() {
            return List.of(textures, spectra, nameless, again, joined);
        }
    }

    private MtlReader(LineReader lines, Skipped skipped) {
        this.lines = lines;
        this.skipped = skipped;
    }

    /**
     * Reads the text of an MTL file.
     *
     * @param in the text, read to its end
     * @param name the file's name for messages
     * @param skipped gets what is passed over
     * @return the materials, in the order of the file
     * @throws SceneFormatException if it is no text of short lines; wrong values are kept in the materials
     * @throws IOException if it cannot be read
     */
    static List<MtlMaterial> read(InputStream in, String name, Skipped skipped) throws IOException {
        MtlReader reader = new MtlReader(new LineReader(in, name), skipped);
        LineReader lines = reader.lines;
        while (lines.read()) {
            reader.readLine();
            if (lines.isContinued()) {
                skipped.joined.addJoined(lines, KEYWORDS);
            }
        }
        return reader.materials;
    }

    private void readLine() {
        at = lines.begin;
        String written = word();
        String keyword = written.toLowerCase(Locale.ROOT);
        if (keyword.equals("newmtl")) {
            String name = lines.name(at);
            named = !name.isEmpty();
            if (named) {
                if (!names.add(name)) {
                    skipped.again.add(lines);
                }
                materials.add(new MtlMaterial(name, lines.file(), lines.number()));
            }
            return;
        }
        Property property = COLOURS.containsKey(keyword) ? COLOURS.get(keyword) : NUMBERS.get(keyword);
        if (keyword.startsWith("map_") || TEXTURES.contains(keyword)) {
            skipped.textures.add(lines);
        } else if (property != null && !named) {
            skipped.nameless.add(lines);
        } else if (property != null) {
            MtlMaterial material = materials.get(materials.size() - 1);
            String of = " in material " + Diagnostic.quoted(material.name);
            try {
                double[] value = COLOURS.containsKey(keyword) ? colour(written, of) : new double[] {number(property, written, of)};
                if (value != null) {
                    material.set(property, value);
                }
            } catch (SceneFormatException e) {
                material.set(property, e);
            }
        }
    }

    /** {@return the next word of the line, empty at its end} */
    private String word() {
        while (at < lines.end && LineReader.isBlank(lines.bytes[at])) {
            at++;
        }
        begin = at;
        while (at < lines.end && !LineReader.isBlank(lines.bytes[at])) {
            at++;
        }
        return lines.text(begin, at);
    }

    private double[] colour(String what, String of) throws SceneFormatException {
        int before = at;
        String first = word();
        if (SPECTRA.contains(first)) {
            skipped.spectra.add(lines);
            return null;
        }
        boolean alone = !first.isEmpty() && word().isEmpty();
        at = before;
        double[] colour = new double[AXES.length];
        for (int i = 0; i < AXES.length; i++) {
            colour[i] = i > 0 && alone ? colour[0] : readNumber(what + (alone ? "" : AXES[i]) + " of 0 or more" + of, 0, Double.MAX_VALUE);
        }
        return colour;
    }

    private double number(Property property, String what, String of) throws SceneFormatException {
        int before = at;
        if (!word().equals("-halo")) {
            at = before;
        }
        return switch (property) {
            case D, TR -> readNumber(what + " from 0 to 1" + of, 0, 1);
            case NI -> readNumber(what + " of 1 or more" + of, 1, Double.MAX_VALUE);
            case ILLUM -> readModel(what + " from 0 to " + MAX_MODEL + of);
            default -> readNumber(what + " of 0 or more" + of, 0, Double.MAX_VALUE);
        };
    }

    private double readModel(String wanted) throws SceneFormatException {
        double model = readNumber(wanted, 0, MAX_MODEL);
        if (model != Math.rint(model)) {
            throw lines.error(begin, wanted, Diagnostic.quoted(lines.text(begin, at)));
        }
        return model;
    }

    private double readNumber(String wanted, double least, double most) throws SceneFormatException {
        String word = word();
        double value = NumberParser.parseDouble(word);
        if (value >= least && value <= most) {
            return value;
        }
        throw lines.error(begin, wanted, word.isEmpty() ? "the end of the line" : BadNumber.describe(word));
    }
}
