package simpleray.scene;

import java.io.IOException;
import java.util.ArrayList;
import simpleray.math.Colour;
import simpleray.text.SceneFormatException;
import simpleray.text.SceneReader;

/**
 * Finds out whether a scene that makes no sense would make sense with other numbers of objects or lights than it announces. Then this
 * is what is wrong, and not that the value behind the last announced object is no number of lights. <em>Constant.</em>
 */
final class Recount {
    /** A longer file is not read again: it takes time, and nobody counts its objects by hand. */
    static final int MAX_BYTES = 1 << 18;

    /** The last thing that seems to be one may be what follows them: an ambient light of 0 0 0 begins like a sphere. */
    private static final int BACK = 1;

    private final Source source;
    private final Reach reach;

    /** What opens the scene once more. */
    interface Source {
        SceneReader open();
    }

    Recount(Source source, Reach reach) {
        this.source = source;
        this.reach = reach;
    }

    /** {@return what was wrong, or if other numbers are right, that} */
    SceneFormatException explained(SceneFormatException first) throws IOException {
        SceneFormatException told = withOtherLights(first, null);
        int seen = told == first ? objects() : 0;
        for (int n = seen; told == first && n >= Math.max(0, seen - BACK); n--) {
            told = withOtherLights(first, n);
        }
        return told;
    }

    /** {@return the error that so many objects are right, or null for those announced, with as many lights as follow} */
    private SceneFormatException withOtherLights(SceneFormatException first, Integer objects) throws IOException {
        int seen = lights(objects);
        return seen > 0 ? attempt(first, objects, seen) : first;      // a file that is cut off may seem to end without lights
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

    /** {@return how many objects can be read, one after another} */
    private int objects() throws IOException {
        ArrayList<Object> objects = new ArrayList<>();
        try (SceneReader is = open()) {
            is.readInt();
            ObjectKind.TABLE.readAll(is, Integer.MAX_VALUE, new LineTable(), objects);
        } catch (SceneFormatException e) {
            return objects.size();                            // as a rule: no file holds so many
        }
        return objects.size();
    }

    /** {@return how many lights can be read after this many objects, or after those announced; -1 if not even the ambient light can} */
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
