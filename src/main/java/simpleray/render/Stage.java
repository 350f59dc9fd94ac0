package simpleray.render;

import java.util.Locale;
import simpleray.scene.Terms;

/** Which picture is made of a scene: the thesis's three (chapter 6, figures 12 to 14) and its single terms (figure 10). */
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
    SPECULAR(new Terms(false, false, true, false, false));

    private final Terms terms;

    Stage(Terms terms) {
        this.terms = terms;
    }

    /** {@return the parts of the colour that this stage shows} */
    public Terms terms() {
        return terms;
    }

    /** {@return the name as the command line has it, in lower case} */
    @Override
    public String toString() {
        return name().toLowerCase(Locale.ROOT);
    }
}
