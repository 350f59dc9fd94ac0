package simpleray.convert;

import java.io.IOException;
import java.io.InputStream;
import java.util.Locale;

/** A format of other programs' scenes. */
public enum ForeignFormat {
    /** The scenes of miniRT, a course project: {@code .rt}. */
    RT,
    /** Haines' Neutral File Format, that of the Standard Procedural Databases: {@code .nff}. */
    NFF;

    /**
     * Finds the format of a file by its name.
     *
     * @param name the file's name
     * @return the format; null if the name tells none
     */
    public static ForeignFormat of(String name) {
        for (ForeignFormat format : values()) {
            if (name.toLowerCase(Locale.ROOT).endsWith("." + format)) {
                return format;
            }
        }
        return null;
    }

    /**
     * Reads a scene.
     *
     * @param in the file, read to its end and not closed
     * @param name its name for messages
     * @return the scene, with a warning for whatever is changed or left out
     * @throws simpleray.text.SceneFormatException if there is an error in it
     * @throws IOException if it cannot be read
     */
    public ImportedScene read(InputStream in, String name) throws IOException {
        ForeignText text = new ForeignText(in, name);
        return this == RT ? new RtReader(text).read() : new NffReader(text).read();
    }

    /** {@return the usual extension of a file's name, which is also the word for the format} */
    @Override
    public String toString() {
        return name().toLowerCase(Locale.ROOT);
    }
}
