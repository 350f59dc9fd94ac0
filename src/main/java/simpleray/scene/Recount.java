package simpleray.scene;

import java.io.IOException;
import java.util.ArrayList;
import simpleray.math.Colour;
import simpleray.text.SceneFormatException;
import simpleray.text.SceneReader;

/**
 * Tries whether a scene with errors would be right with other numbers of objects or lights than it announces. Then the error is the
 * wrong number, and not the value after the last announced object. <em>Constant.</em>
 */
final class Recount {
    /** A longer file is not read again: it takes time, and nobody counts its objects by hand. */
    static final int MAX_BYTES = 1 << 18;

    /** The last object read may belong to what follows: an ambient light of 0 0 0 begins like a sphere. */
    private static final int BACK = 1;

    private final Source source;
    private final Reach reach;

    /** Opens the scene again. */
    interface Source {
        SceneReader open();
    }

    Recount(Source source, Reach reach) {
        this.source = source;
        this.reach = reach;
    }

    /** {@return the first error, or the error that other numbers are right} */
    SceneFormatException explained(SceneFormatException first) throws IOException {
        SceneFormatException told = withOtherLights(first, null);
        int seen = told == first ? objects() : 0;
        for (int n = seen; told == first && n >= Math.max(0, seen - BACK); n--) {
            told = withOtherLights(first, n);
        }
        return told;
    }

    /** {@return the error that this number of objects, null for the announced one, is right with the lights that follow} */
    private SceneFormatException withOtherLights(SceneFormatException first, Integer objects) throws IOException {
        int seen = lights(objects);
        return seen > 0 ? attempt(first, objects, seen) : first;      // a truncated file may seem to end without lights
    }

    /** {@return the error that these numbers are the right ones; the first error if they are not} */
    private SceneFormatException attempt(SceneFormatException first, Integer objects, Integer lights) throws IOException {
        CountOverrides counts = new CountOverrides(objects, lights);
        Scene scene = new Scene();
        try (SceneReader is = open()) {
            scene.read(is, counts);
        } catch (SceneFormatException e) {
            return counts.fit && counts.changed() == e.problems().size() ? e : first;
        }
        return first;
    }

    /** {@return the number of objects that can be read, one after another} */
    private int objects() throws IOException {
        ArrayList<Object> objects = new ArrayList<>();
        try (SceneReader is = open()) {
            is.readInt();
            ObjectKind.TABLE.readAll(is, Integer.MAX_VALUE, new LineTable(), objects);
        } catch (SceneFormatException e) {
            return objects.size();                            // the usual end: no file contains the maximum
        }
        return objects.size();
    }

    /** {@return the number of lights that can be read after this or the announced number of objects; -1 without ambient light} */
    private int lights(Integer objects) throws IOException {
        ArrayList<Light> lights = new ArrayList<>();
        boolean ambient = false;
        try (SceneReader is = open()) {
            int announced = is.readInt();
            ObjectKind.TABLE.readAll(is, objects == null ? announced : objects, new LineTable());
            new Colour().read(is);
            is.readInt();
            ambient = true;
            LightKind.TABLE.readAll(is, Integer.MAX_VALUE, new LineTable(), lights);
        } catch (SceneFormatException e) {
            return ambient ? lights.size() : -1;
        }
        return lights.size();
    }

    private SceneReader open() {
        SceneReader is = source.open();
        MeshFiles.of(is, reach);
        return is;
    }
}
