package simpleray.scene;

import java.io.IOException;
import simpleray.math.Colour;
import simpleray.math.Point;
import simpleray.math.Vector;
import simpleray.text.SceneWriter;

/** Writes what POV-Ray's scene language is made of. Vectors are taken as they are, so that it sees our right-handed axes. */
final class Pov {
    private Pov() {
    }

    static void vector(SceneWriter os, double x, double y, double z) throws IOException {
        os.writeChar('<');
        os.writeDouble(x + 0.0);                             // -0.0 becomes 0.0
        os.writeChar(',');
        os.writeDouble(y + 0.0);
        os.writeChar(',');
        os.writeDouble(z + 0.0);
        os.writeChar('>');
    }

    static void colour(SceneWriter os, Colour c) throws IOException {
        os.writeString("rgb ");
        vector(os, c.r, c.g, c.b);
    }

    /** Writes a number after a word. */
    static void value(SceneWriter os, String word, double value) throws IOException {
        os.writeString(word);
        os.writeChar(' ');
        os.writeDouble(value);
    }

    /**
     * Writes a camera.
     *
     * @param eye where it stands
     * @param direction from there to the middle of the picture
     * @param right from the left edge of the picture to the right one
     * @param up from its lower edge to the upper one
     */
    static void camera(SceneWriter os, Point eye, Vector direction, Vector right, Vector up) throws IOException {
        os.writeString("camera { perspective location ");
        vector(os, eye.x, eye.y, eye.z);
        os.writeString(" direction ");
        vector(os, direction.x, direction.y, direction.z);
        os.writeString(" right ");
        vector(os, right.x, right.y, right.z);
        os.writeString(" up ");
        vector(os, up.x, up.y, up.z);
        os.writeString(" }\n");
    }
}
