package simpleray.scene;

import java.io.IOException;
import simpleray.text.SceneReader;
import simpleray.text.SceneWriter;

/** An object or light, listed in a scene file after the code of its kind. */
interface SceneElement {
    /** Prints this as the thesis's Interpretation does, without the last line break. */
    void print(SceneWriter os) throws IOException;

    /** Reads this without the code of its kind. */
    void read(SceneReader is) throws IOException;

    /** Writes this in the form that {@link #read} reads. */
    void write(SceneWriter os) throws IOException;
}
