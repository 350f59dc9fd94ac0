package simpleray.scene;

/** The kinds that a scene file knows, as messages list them, so that a new kind changes no test. */
public final class Kinds {
    /** What stands for {@link #objects()} in files of expected messages. */
    static final String OBJECTS = "<kinds of object>";
    /** What stands for {@link #lights()} there. */
    static final String LIGHTS = "<kinds of light>";

    private Kinds() {
    }

    /** {@return the kinds of object: "0 sphere, 1 plane" and so on} */
    public static String objects() {
        return ObjectKind.TABLE.list();
    }

    /** {@return the kinds of light: "0 point light, 1 directional light" and so on} */
    public static String lights() {
        return LightKind.TABLE.list();
    }
}
