package simpleray.scene;

import java.io.IOException;
import simpleray.math.Vector;
import simpleray.text.SceneReader;

/** Reads vectors that must not be zero. */
final class Directions {
    private Directions() {
    }

    static void read(SceneReader is, String name, Vector v) throws IOException {
        is.group();
        is.enter(name);
        v.read(is);
        is.leave();
        if (v.x == 0 && v.y == 0 && v.z == 0) {
            is.rejectGroup(name + " other than zero");
        }
    }
}
