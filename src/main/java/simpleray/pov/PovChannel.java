package simpleray.pov;

import java.util.Locale;
import java.util.function.ToDoubleFunction;
import simpleray.math.Colour;

/** The colour channels that a scene for POV-Ray shows. With one channel it shows a grey picture, which equals ours. */
public enum PovChannel {
    /** Red alone. */
    R(c -> c.r),
    /** Green alone. */
    G(c -> c.g),
    /** Blue alone. */
    B(c -> c.b),
    /** All three. */
    ALL(null);

    private final ToDoubleFunction<Colour> value;

    PovChannel(ToDoubleFunction<Colour> value) {
        this.value = value;
    }

    /** {@return the name on the command line, in lower case} */
    @Override
    public String toString() {
        return name().toLowerCase(Locale.ROOT);
    }

    /** {@return a new colour with only these channels of another} */
    Colour of(Colour c) {
        if (value == null) {
            return new Colour(c);
        }
        double grey = value.applyAsDouble(c);
        return new Colour(grey, grey, grey);
    }
}
