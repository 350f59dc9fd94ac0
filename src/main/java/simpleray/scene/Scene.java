package simpleray.scene;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import simpleray.math.Colour;
import simpleray.math.Ray;
import simpleray.text.SceneReader;
import simpleray.text.SceneWriter;

/**
 * Objects, lights and ambient light, and the colour that a ray sees among them (thesis, chapters 4 and 5; Whitted, "An improved
 * illumination model for shaded display", 1980). <em>Mutable</em> until it is rendered.
 */
public final class Scene {
    /** Reading ends at this many errors. */
    private static final int MAX_ERRORS = 20;
    /** The ambient light that falls on every object alike, GA. */
    public Colour ambient = new Colour();
    /** The settings of camera and renderer, from the scene's file or its user; not null. */
    public SceneSettings settings = new SceneSettings();

    private final List<Object> objects;
    private final List<Light> lights;
    private int numberObjects;
    private int numberLights;
    private LineTable objectLines = new LineTable();
    private LineTable lightLines = new LineTable();

    /** Creates an empty, dark scene. */
    public Scene() {
        objects = new ArrayList<>();
        lights = new ArrayList<>();
    }

    private Scene(Scene of, SceneSettings settings, List<Object> objects, List<Light> lights) {
        ambient = of.ambient;
        this.settings = settings;
        this.objects = objects;
        this.lights = lights;
        numberObjects = of.numberObjects;
        numberLights = of.numberLights;
        objectLines = of.objectLines;
        lightLines = of.lightLines;
    }

    /**
     * Returns this scene with other settings. Both have the same objects, lights and ambient light; neither may be changed while the
     * other is used.
     *
     * @param other the settings, referenced
     * @return a new scene
     */
    public Scene with(SceneSettings other) {
        return new Scene(this, other, objects, lights);
    }

    /** {@return the film of this scene, of one frame if it has no frames; a new one, so keep it for many frames} */
    public Film film() {
        return new Film(this);
    }

    /**
     * Returns the still scene of a frame, as by {@link Film#still}.
     *
     * @param frame the frame, from 0 to the film's last; need not be whole
     * @return the scene, without frames, keys and curve; this scene if it is no film
     * @throws IllegalArgumentException if there is no such frame, or it has values that no scene may have
     */
    public Scene still(double frame) {
        return film().still(frame);
    }

    /** {@return a scene of the same objects and lights, any of which can be replaced} */
    Scene copy() {
        return new Scene(this, settings, new ArrayList<>(objects), new ArrayList<>(lights));
    }

    /** Replaces an object by the same one in another place; it keeps its line. */
    void replace(int i, Object o) {
        objects.set(i, o);
    }

    /** Replaces a light likewise. */
    void replace(int i, Light light) {
        lights.set(i, light);
    }

    /** {@return the number of objects} */
    public int getNumberObjects() {
        return numberObjects;
    }

    /** {@return the number of lights} */
    public int getNumberLights() {
        return numberLights;
    }

    /**
     * Sets the number of objects, each of which must be set before the scene is used.
     *
     * @param n the number, 0 or more
     */
    public void setNumberObjects(int n) {
        numberObjects = resize(objects, n);
    }

    /**
     * Sets the number of lights, each of which must be set before the scene is used.
     *
     * @param n the number, 0 or more
     */
    public void setNumberLights(int n) {
        numberLights = resize(lights, n);
    }

    /**
     * Sets an object.
     *
     * @param i its index
     * @param o the object, referenced
     * @throws IndexOutOfBoundsException if the index is out of range
     */
    public void setObject(int i, Object o) {
        put(objects, Objects.checkIndex(i, numberObjects), o);
        objectLines.forget(i);
    }

    /**
     * Sets a light.
     *
     * @param i its index
     * @param o the light, referenced
     * @throws IndexOutOfBoundsException if the index is out of range
     */
    public void setLight(int i, Light o) {
        put(lights, Objects.checkIndex(i, numberLights), o);
        lightLines.forget(i);
    }

    /**
     * Returns an object.
     *
     * @param i its index
     * @return the object itself
     */
    public Object getObject(int i) {
        return objects.get(i);
    }

    /**
     * Returns a light.
     *
     * @param i its index
     * @return the light itself
     */
    public Light getLight(int i) {
        return lights.get(i);
    }

    /**
     * Returns a scene of other objects.
     *
     * @param others its objects, referenced
     * @return a new scene with these objects, and with the lights, the ambient light and the settings of this one, referenced
     */
    public Scene with(List<Object> others) {
        Scene scene = new Scene();
        scene.ambient = ambient;
        scene.settings = settings;
        scene.setNumberObjects(others.size());
        for (int i = 0; i < others.size(); i++) {
            scene.setObject(i, others.get(i));
        }
        scene.setNumberLights(numberLights);
        for (int i = 0; i < numberLights; i++) {
            scene.setLight(i, lights.get(i));
        }
        return scene;
    }

    /** {@return the first line of an object in the scene's file; 0 if it is from no file} */
    int objectLine(int i) {
        return objectLines.get(i);
    }

    /** {@return the first line of a light in the scene's file; 0 if it is from no file} */
    int lightLine(int i) {
        return lightLines.get(i);
    }

    /**
     * Computes the colour that a ray sees. Any thread may call.
     *
     * @param ray the ray, of unit direction
     * @param colour gets the colour, linear and not clamped; the background if nothing is hit
     * @param depth the number of reflections and refractions that may follow, 0 or more
     * @return whether an object is hit
     */
    public boolean intersect(Ray ray, Colour colour, int depth) {
        return intersect(ray, colour, depth, Terms.ALL);
    }

    /**
     * Computes some terms of the colour that a ray sees, by testing all objects in turn. Any thread may call.
     *
     * @param ray the ray, of unit direction
     * @param colour gets the colour, linear and not clamped; the background if nothing is hit
     * @param depth how many reflections and refractions may follow, 0 or more
     * @param terms the terms
     * @return whether an object is hit
     */
    public boolean intersect(Ray ray, Colour colour, int depth, Terms terms) {
        return new WhittedIntegrator(this, new BruteForceIntersector(this), terms, new RayStats(), null).trace(ray, colour, depth);
    }

    /** Throws unless all objects and lights are set: a picture without them would be wrong. */
    void requireComplete() {
        all(objects, numberObjects);
        all(lights, numberLights);
    }

    /**
     * Prints the thesis's Interpretation of the scene (chapter 6).
     *
     * @param os where to
     * @throws IOException if it cannot be written
     */
    public void print(SceneWriter os) throws IOException {
        os.writeString("Scene has " + numberObjects + " objects\n");
        os.writeString("Scene has " + numberLights + " lights\n");
        os.writeString("Number of objects " + numberObjects + '\n');
        for (Object object : all(objects, numberObjects)) {
            object.print(os);
            os.writeNewline();
        }
        os.writeString("Ambient light is ");
        ambient.write(os);
        os.writeNewline();
        os.writeString("Number of lights " + numberLights + '\n');
        for (Light light : all(lights, numberLights)) {
            light.print(os);
            os.writeNewline();
        }
        settings.write(os);
    }

    /**
     * Reads a scene to the end of the file. This scene changes only if the whole file is right. Objects with equal materials
     * refer to one {@link Material}.
     *
     * @param is where from
     * @throws IOException if it cannot be read; {@link simpleray.text.SceneFormatException} with up to 20 errors if it is no scene
     */
    public void read(SceneReader is) throws IOException {
        read(is, new CountOverrides());
    }

    /** Reads a scene that has as many objects and lights as it announces, or others. */
    void read(SceneReader is, CountOverrides counts) throws IOException {
        is.tolerate(MAX_ERRORS);
        LineTable newObjectLines = new LineTable();
        LineTable newLightLines = new LineTable();
        int n = counts.objects(is, is.readInt("the number of objects", 0, Integer.MAX_VALUE));
        List<Object> newObjects = ObjectKind.TABLE.readAll(is, n, newObjectLines);
        is.enter("the scene's ambient");
        Colour newAmbient = new Colour();
        newAmbient.read(is);
        is.leave();
        String before = "(after " + ObjectKind.TABLE.counted(n) + " and ";
        int m = counts.lights(is, is.readInt("the number of lights " + before + "the ambient light)", 0, Integer.MAX_VALUE));
        List<Light> newLights = LightKind.TABLE.readAll(is, m, newLightLines);
        String end = "the end of the scene " + before + LightKind.TABLE.counted(m) + ')';
        SceneSettings newSettings = new SceneSettings();
        newSettings.read(is, newObjects, newLights);
        counts.fit = is.eof();
        is.complete(end);
        if (newSettings.keys != null) {
            KeyReader.of(is).checkFilm(is, new Film(new Scene(this, newSettings, newObjects, newLights)));
            is.complete(end);
        }

        objects.clear();
        objects.addAll(newObjects);
        numberObjects = n;
        lights.clear();
        lights.addAll(newLights);
        numberLights = m;
        objectLines = newObjectLines;
        lightLines = newLightLines;
        ambient = newAmbient;
        settings = newSettings;
    }

    /**
     * Writes the scene; {@link #read} reads an equal one, bit for bit.
     *
     * @param os where to
     * @throws IOException if it cannot be written
     */
    public void write(SceneWriter os) throws IOException {
        writeThings(os);
        settings.write(os);
    }

    /** Writes the scene without its settings, which follow. */
    void writeThings(SceneWriter os) throws IOException {
        os.writeString("# number of objects\n");
        os.writeInt(numberObjects);
        os.writeNewline();
        ObjectKind.TABLE.writeAll(os, all(objects, numberObjects));
        os.writeString("# ambient light\n");
        ambient.write(os);
        os.writeString("\n# number of lights\n");
        os.writeInt(numberLights);
        os.writeNewline();
        LightKind.TABLE.writeAll(os, all(lights, numberLights));
    }

    /** {@return whether another scene has the same objects, lights and ambient light; equal ones are not the same} */
    boolean hasThingsOf(Scene other) {
        boolean same = ambient == other.ambient && numberObjects == other.numberObjects && numberLights == other.numberLights;
        for (int i = 0; same && i < numberObjects; i++) {
            same = objects.get(i) == other.objects.get(i);
        }
        for (int i = 0; same && i < numberLights; i++) {
            same = lights.get(i) == other.lights.get(i);
        }
        return same;
    }

    private static int resize(List<?> list, int n) {
        if (n < 0) {
            throw new IllegalArgumentException("a number of things must be 0 or more, and is " + n);
        }
        if (n < list.size()) {
            list.subList(n, list.size()).clear();
        }
        return n;
    }

    /** {@return the list, after checking that all things that were announced are set} */
    private static <T> List<T> all(List<T> list, int n) {
        if (list.size() != n) {
            throw new IllegalStateException("of " + n + " places in the scene only " + list.size() + " are set");
        }
        return list;
    }

    private static <T> void put(List<T> list, int i, T thing) {
        while (list.size() <= i) {
            list.add(null);
        }
        list.set(i, thing);
    }
}
