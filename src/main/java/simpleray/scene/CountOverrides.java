package simpleray.scene;

import java.io.IOException;
import simpleray.text.SceneReader;

/** How many objects and lights a scene file is to be read with, whatever numbers it announces. <em>Mutable,</em> for one reading. */
final class CountOverrides {
    /** The number of objects that was announced was read. */
    boolean announced;
    /** Behind the last light, and the settings, the file ended. */
    boolean fit;

    private final Integer objects;
    private final Integer lights;
    private int changed;

    /** Those that the file announces. */
    CountOverrides() {
        this(null, null);
    }

    /** Others: a number, or null for the one that the file announces. */
    CountOverrides(Integer objects, Integer lights) {
        this.objects = objects;
        this.lights = lights;
    }

    /** {@return how many numbers were others than those announced; each was noted as an error} */
    int changed() {
        return changed;
    }

    /** {@return the number of objects to read} */
    int objects(SceneReader is, int read) throws IOException {
        announced = true;
        return instead(is, "the number of objects", objects, read);
    }

    /** {@return the number of lights to read} */
    int lights(SceneReader is, int read) throws IOException {
        return instead(is, "the number of lights", lights, read);
    }

    private int instead(SceneReader is, String what, Integer right, int read) throws IOException {
        if (right == null || right == read) {
            return read;
        }
        changed++;
        is.reject(what + " to be " + right + ", as many as follow");
        return right;
    }
}
