package simpleray.render;

import java.util.Locale;

/** The way to find the nearest object along a ray. It does not change the picture. */
public enum Accel {
    /** By a tree or a grid, and light buffers. */
    AUTO,
    /** By testing all objects in turn, as the thesis does. */
    NONE;

    /** {@return the name as the command line has it, in lower case} */
    @Override
    public String toString() {
        return name().toLowerCase(Locale.ROOT);
    }
}
