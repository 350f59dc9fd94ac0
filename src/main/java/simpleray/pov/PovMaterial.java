package simpleray.pov;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import simpleray.math.Colour;
import simpleray.scene.Material;
import simpleray.text.SceneWriter;

/**
 * A material as POV-Ray 3.7 has it. <em>Constant.</em>
 *
 * <p>Its {@code specular} with roughness 1/shininess is our term of the half vector. It dims what a surface scatters by the share that
 * passes through, and brightens total internal reflection to 1; both are undone here. All this is exact if the colours are grey, as
 * they are in the picture of one colour channel. Where they are not, POV-Ray's one number is a mean.
 */
final class PovMaterial {
    /** The share of light that passes through a transparent pigment; the rest dims its scattered light. */
    private static final double FILTER = 0.5;
    /** Takes the place of a colour of 0 that something is divided by. */
    private static final double NEXT_TO_NOTHING = 1e-6;
    /** An exponent of 0, as near as a roughness can come. */
    private static final double ROUGHEST = 1e30;
    /** POV-Ray spends no depth where a ray goes straight on: an index of 1 bends it, but too little to see. */
    private static final double MIN_INDEX = 1.0000001;

    /** Whether it follows mirror rays and refracted rays. */
    final boolean follows;
    /** Whether light passes through it. */
    final boolean transmits;

    private final Colour ambient;
    private final Colour diffuse;
    private final Colour specular;
    private final Colour mirror;
    private final Colour transmission;
    private final double shininess;
    private final double index;

    /**
     * Prepares a material.
     *
     * @param material the material
     * @param light the scene's ambient light
     * @param shown which channels are shown
     * @param depth the most reflections of a ray from the eye
     */
    PovMaterial(Material material, Colour light, PovChannel shown, int depth) {
        ambient = shown.of(Colour.mult(material.ambient, light));
        diffuse = shown.of(material.diffuse);
        specular = shown.of(material.specular);
        mirror = shown.of(material.mirrored());
        transmission = shown.of(material.transmission);
        shininess = material.shininess;
        index = material.index;
        transmits = !transmission.isBlack();
        follows = Math.min(depth, material.reflections()) > 0 && (transmits || !mirror.isBlack());
    }

    /** {@return whether rays pass through it} */
    boolean isClear() {
        return transmits && follows;
    }

    /** {@return whether a ray goes on in another direction behind it} */
    boolean bends() {
        return isClear() && index > 1;
    }

    /** {@return whether it dims light, and does not stop it or let all of it through} */
    boolean dims() {
        return transmits && !(transmission.r == 1 && transmission.g == 1 && transmission.b == 1);
    }

    /** {@return whether POV-Ray shows the very same} */
    boolean isExact() {
        boolean sameShare = !isClear() || isGrey(diffuse) && isGrey(transmission);
        return isGrey(specular) && (sameShare || diffuse.isBlack());
    }

    /** {@return the texture, and the interior if there is one} */
    String look() {
        return text(os -> {
            if (!isClear()) {
                os.writeString("texture { ");
                opaque(os);
                os.writeString(" }");
                return;
            }
            Colour internal = Colour.add(mirror, transmission);     // what the mirror ray carries if nothing is refracted
            boolean dimmed = bends() && !(internal.r == 1 && internal.g == 1 && internal.b == 1);
            os.writeString("texture { ");
            clear(os, transmission);
            if (dimmed) {
                os.writeString(" } interior_texture { ");
                clear(os, new Colour(share(transmission.r, internal.r), share(transmission.g, internal.g),
                    share(transmission.b, internal.b)));
            }
            PovWriter.value(os, " } interior { ior ", Math.max(index, MIN_INDEX));
            if (dimmed) {
                PovWriter.colour(os, " fade_distance 1e-6 fade_power 2 fade_color ", internal);
            }
            os.writeString(" }");
        });
    }

    /** {@return the texture of a thing that nobody sees, and whose shadow is that of an object that is clear} */
    String shade(boolean solid) {
        return text(os -> {
            PovWriter.colour(os, solid ? "texture { pigment { rgbt <0,0,0,1> } } interior_texture { pigment { " : "texture { pigment { ",
                transmission);
            os.writeString(" filter 1 } }");
        });
    }

    private void opaque(SceneWriter os) throws IOException {
        double most = Math.max(diffuse.r, Math.max(diffuse.g, diffuse.b));
        Colour hue = most > 0 ? Colour.scale(diffuse, 1 / most) : new Colour(1, 1, 1);
        pigment(os, hue, 0);
        finish(os, hue, 1, most);
    }

    private void clear(SceneWriter os, Colour passing) throws IOException {
        Colour hue = Colour.scale(passing, 1 / FILTER);
        pigment(os, hue, FILTER);
        finish(os, hue, 1 - FILTER, mean(diffuse) / (mean(hue) * (1 - FILTER)));
    }

    /** Writes a pigment, of which POV-Ray lets colour times filter through. */
    private void pigment(SceneWriter os, Colour hue, double filter) throws IOException {
        hue.r = divisor(hue.r, ambient.r);
        hue.g = divisor(hue.g, ambient.g);
        hue.b = divisor(hue.b, ambient.b);
        PovWriter.colour(os, "pigment { ", hue);
        if (filter > 0) {
            PovWriter.value(os, " filter ", filter);
        }
        os.writeString(" }");
    }

    private void finish(SceneWriter os, Colour hue, double left, double scattered) throws IOException {
        PovWriter.colour(os, " finish { ambient ",
            new Colour(share(ambient.r, hue.r * left), share(ambient.g, hue.g * left), share(ambient.b, hue.b * left)));
        PovWriter.value(os, " diffuse ", scattered);
        if (!specular.isBlack()) {
            PovWriter.value(os, " specular ", mean(specular));
            PovWriter.value(os, " roughness ", Math.min(1 / shininess, ROUGHEST));
        }
        if (follows && !mirror.isBlack()) {
            PovWriter.colour(os, " reflection { ", mirror);
            os.writeString(" }");
        }
        os.writeString(" }");
    }

    private interface Text {
        void write(SceneWriter os) throws IOException;
    }

    private static String text(Text text) {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        try (SceneWriter os = new SceneWriter(bytes)) {
            text.write(os);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
        return bytes.toString(StandardCharsets.UTF_8);
    }

    private static double divisor(double hue, double ambient) {
        return hue == 0 && ambient > 0 ? NEXT_TO_NOTHING : hue;
    }

    private static double share(double part, double whole) {
        return part == 0 ? 0 : part / whole;
    }

    private static double mean(Colour c) {
        return c.r == c.g && c.g == c.b ? c.r : (c.r + c.g + c.b) / 3;
    }

    private static boolean isGrey(Colour c) {
        return c.r == c.g && c.g == c.b;
    }
}
