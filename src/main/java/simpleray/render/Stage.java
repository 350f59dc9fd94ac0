package simpleray.render;

import java.util.Locale;
import simpleray.scene.Terms;

/**
 * Which picture is made of a scene: the thesis's three (chapter 6, figures 12 to 14), its single terms (figure 10), or a view that shows
 * something else than light.
 */
public enum Stage {
    /** Before lighting and shadows: Ka·GA alone. */
    ORIGINAL(new Terms(true, false, false, false, false)),
    /** After lighting: ambient, diffuse and specular term, without shadows and reflections. */
    LIGHTING(new Terms(true, true, true, false, false)),
    /** After shadows and reflections: all of it. */
    FINAL(Terms.ALL),
    /** The ambient term of lighting alone. */
    AMBIENT(new Terms(true, false, false, false, false)),
    /** The diffuse term of lighting alone. */
    DIFFUSE(new Terms(false, true, false, false, false)),
    /** The specular term of lighting alone. */
    SPECULAR(new Terms(false, false, true, false, false)),
    /** The normals of what the eye sees. */
    NORMALS,
    /** How near it is. */
    DEPTH,
    /** Which object it is. */
    OBJECTS,
    /** How far reflections and refractions are followed. */
    BOUNCES,
    /** Which share of the lights comes there. */
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

    /** {@return whether it shows something else than light, as a {@link ViewIntegrator} finds it} */
    public boolean isView() {
        return view;
    }

    /** {@return the parts of the colour that this stage shows; of a view, those of the finished picture} */
    public Terms terms() {
        return terms;
    }

    /** {@return the name as the command line has it, in lower case} */
    @Override
    public String toString() {
        return name().toLowerCase(Locale.ROOT);
    }
}
