package simpleray.scene;

import java.io.IOException;
import simpleray.text.SceneReader;
import simpleray.text.SceneWriter;

/** Something that is listed in a scene file after the code of its kind. */
interface SceneElement {
    /** Prints it as the thesis's Interpretation does, without the last line break. */
    void print(SceneWriter os) throws IOException;

    /** Reads it, all but the code of its kind. */
    void read(SceneReader is) throws IOException;

    /** Writes it, so that {@link #read} gets an equal one. */
    void write(SceneWriter os) throws IOException;
}
