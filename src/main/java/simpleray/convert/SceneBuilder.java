package simpleray.convert;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import simpleray.math.Colour;
import simpleray.math.Point;
import simpleray.scene.Light;
import simpleray.scene.Object;
import simpleray.scene.PointLight;
import simpleray.scene.Scene;
import simpleray.scene.SceneSettings;
import simpleray.text.SceneFormatException;
import simpleray.text.SceneReader;
import simpleray.text.SceneWriter;

/** The parts of a scene, as they are read. <em>Mutable.</em> */
final class SceneBuilder {
    final SceneSettings settings = new SceneSettings();
    final Facets facets = new Facets();
    final List<Thing> things = new ArrayList<>();
    final List<Light> lights = new ArrayList<>();
    private final List<ForeignText.Place> lightPlaces = new ArrayList<>();
    Colour ambient = new Colour();

    /**
     * An object.
     *
     * @param object the object
     * @param place where it is from
     */
    record Thing(Object object, ForeignText.Place place) {
    }

    void add(ForeignText.Place place, Object object) {
        things.add(new Thing(object, place));
    }

    /** Adds a point light. {@return it} */
    Light addLight(ForeignText.Place place, Point origin, Colour colour) {
        Light light = new PointLight(origin);
        light.intensity = colour;
        lights.add(light);
        lightPlaces.add(place);
        return light;
    }

    /**
     * Builds the scene of all parts, and reads it back from its text.
     *
     * @param text the file that the parts are from
     * @param view where the camera is from
     * @return the scene
     * @throws SceneFormatException if a part has numbers, as sums of the file's, that no scene file may have
     */
    ImportedScene build(ForeignText text, ForeignText.Place view) throws SceneFormatException {
        Scene scene = scene(things, lights, settings);
        String written = written(scene);
        if (fault(written) != null) {
            for (Thing thing : things) {
                require(text, thing.place, scene(List.of(thing), List.of(), new SceneSettings()));
            }
            for (int i = 0; i < lights.size(); i++) {
                require(text, lightPlaces.get(i), scene(List.of(), List.of(lights.get(i)), new SceneSettings()));
            }
            require(text, view, scene(List.of(), List.of(), settings));
        }
        return new ImportedScene(text.file(), scene, written, facets, text.warnings());
    }

    private Scene scene(List<Thing> things, List<Light> lights, SceneSettings settings) {
        Scene scene = new Scene();
        scene.settings = settings;
        scene.ambient = ambient;
        scene.setNumberObjects(things.size());
        for (int i = 0; i < things.size(); i++) {
            scene.setObject(i, things.get(i).object);
        }
        scene.setNumberLights(lights.size());
        for (int i = 0; i < lights.size(); i++) {
            scene.setLight(i, lights.get(i));
        }
        return scene;
    }

    private static void require(ForeignText text, ForeignText.Place place, Scene part) throws SceneFormatException {
        String fault = fault(written(part));
        if (fault != null) {
            throw text.error(place, fault.replaceFirst("(object|light) 1's ", ""));
        }
    }

    private static String written(Scene scene) {
        try {
            ByteArrayOutputStream out = new ByteArrayOutputStream();
            SceneWriter writer = new SceneWriter(out);
            scene.write(writer);
            writer.flush();
            return out.toString(StandardCharsets.UTF_8);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    /** {@return what is wrong with the text of a scene; null if nothing is} */
    private static String fault(String written) {
        try {
            new Scene().read(new SceneReader(new ByteArrayInputStream(written.getBytes(StandardCharsets.UTF_8))));
            return null;
        } catch (SceneFormatException e) {
            return e.problems().get(0).message();
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }
}
