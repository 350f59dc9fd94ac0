package simpleray.render;

import java.util.Locale;
import simpleray.scene.Terms;

/**
 * The kind of picture: one of the thesis's three (chapter 6, figures 12 to 14), a single term (figure 10), or a view that shows something
 * other than light.
 */
public enum Stage {
    /** Before lighting and shadows: Ka·GA alone. */
    ORIGINAL(new Terms(true, false, false, false, false)),
    /** After lighting: ambient, diffuse and specular term, without shadows and reflections. */
    LIGHTING(new Terms(true, true, true, false, false)),
    /** After shadows and reflections: the complete picture. */
    FINAL(Terms.ALL),
    /** The ambient term of lighting alone. */
    AMBIENT(new Terms(true, false, false, false, false)),
    /** The diffuse term of lighting alone. */
    DIFFUSE(new Terms(false, true, false, false, false)),
    /** The specular term of lighting alone. */
    SPECULAR(new Terms(false, false, true, false, false)),
    /** The normals of the surfaces that the eye sees. */
    NORMALS,
    /** The distance of these surfaces: the nearer, the brighter. */
    DEPTH,
    /** A colour for each object. */
    OBJECTS,
    /** The number of reflections and refractions that are followed. */
    BOUNCES,
    /** The share of the lights that reaches the surface. */
    SHADOWS;

    private final Terms terms;
    private final boolean view;

    Stage(Terms terms) {
        this.terms = terms;
        view = false;
    }

    Stage() {
        terms = Terms.ALL;
        view = true;
    }

    /** {@return whether it shows something other than light, by a {@link ViewIntegrator}} */
    public boolean isView() {
        return view;
    }

    /** {@return the parts of the colour that this stage shows; for a view, those of the final stage} */
    public Terms terms() {
        return terms;
    }

    /** {@return the name as the command line has it, in lower case} */
    @Override
    public String toString() {
        return name().toLowerCase(Locale.ROOT);
    }
}
