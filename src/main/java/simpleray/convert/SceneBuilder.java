package simpleray.convert;

import java.util.ArrayList;
import java.util.List;
import simpleray.math.Colour;
import simpleray.math.Point;
import simpleray.scene.Light;
import simpleray.scene.Object;
import simpleray.scene.PointLight;
import simpleray.scene.Scene;
import simpleray.scene.SceneSettings;

/** The parts of a scene, as they are read. <em>Mutable.</em> */
final class SceneBuilder {
    final SceneSettings settings = new SceneSettings();
    final Facets facets = new Facets();
    final List<Thing> things = new ArrayList<>();
    final List<Light> lights = new ArrayList<>();
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
    Light addLight(Point origin, Colour colour) {
        Light light = new PointLight(origin);
        light.intensity = colour;
        lights.add(light);
        return light;
    }

    /** {@return the scene of all parts} */
    ImportedScene build(ForeignText text) {
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
        return new ImportedScene(text.file(), scene, facets, text.warnings());
    }
}
