package simpleray.rays;

import simpleray.math.Colour;
import simpleray.math.Point;
import simpleray.math.Ray;
import simpleray.math.Vector;
import simpleray.scene.Camera;
import simpleray.scene.Material;
import simpleray.scene.Mesh;
import simpleray.scene.Object;
import simpleray.scene.Plane;
import simpleray.scene.RayTree.Thing;
import simpleray.scene.Scene;
import simpleray.scene.Triangle;

/**
 * What a viewer would call the objects of a scene: "white sphere", "left wall". The words come from the material and the shape alone. Reads
 * the scene, which must not change meanwhile.
 */
final class ObjectNames {
    private static final double BLACK = 0.06;                 // up to this value a colour is black
    private static final double WHITE = 0.75;                 // from this value on a grey is white
    private static final double GREY = 0.2;                   // below this saturation a colour is a grey
    private static final double BROWN = 0.7;                  // below this value an orange is brown
    private static final double ALONG = 0.9;                  // from this cosine on a plane faces that way
    private static final double[] HUES = {15, 45, 70, 165, 195, 255, 290, 345};   // degrees; each the end of a word of HUE_WORDS
    private static final String[] HUE_WORDS = {"red", "orange", "yellow", "green", "turquoise", "blue", "violet", "pink", "red"};

    private final Scene scene;
    private final Point eye;
    private final Vector ahead;                               // level, as far as the camera does not look straight up or down
    private final Vector right;

    ObjectNames(Scene scene, Camera camera) {
        this.scene = scene;
        Ray middle = camera.through(camera.width() / 2.0, camera.height() / 2.0);
        eye = middle.origin;                                  // of parallel rays, the one in the middle
        ahead = middle.direction;
        ahead.y = 0;
        ahead.normalise();
        right = new Vector(-ahead.z, 0, ahead.x);
    }

    /**
     * Names an object.
     *
     * @param thing the object
     * @param material its material where it is hit; null for its only one
     * @return the name, without an article
     */
    String of(Thing thing, Material material) {
        Object object = scene.getObject(thing.number() - 1);
        Material seen = material != null ? material : object instanceof Mesh ? null : object.material(0);
        String look = seen == null ? "" : look(seen) + ' ';
        return look + (object instanceof Plane plane ? wall(plane) : thing.kind());
    }

    /** {@return whether an object has an inside} */
    boolean isBody(Thing thing) {
        Object object = scene.getObject(thing.number() - 1);
        return !(object instanceof Plane || object instanceof Triangle);
    }

    private String wall(Plane plane) {
        Vector facing = plane.normal.normalised();
        if (facing.dot(eye) * plane.normal.norm() < plane.constant) {
            facing.negate();                                  // towards the eye
        }
        double side = facing.dot(right);
        double back = facing.dot(ahead);
        return facing.y > ALONG ? "floor" : facing.y < -ALONG ? "ceiling" : side > ALONG ? "left wall" : side < -ALONG ? "right wall"
            : back < -ALONG ? "back wall" : back > ALONG ? "wall behind the eye" : "plane";
    }

    private static String look(Material material) {
        if (!material.transmission.isBlack()) {
            String kind = material.index > 1 ? "glass" : "transparent";
            return isGrey(material.transmission) ? kind : colour(material.transmission) + ' ' + kind;
        }
        Colour mirrored = material.mirrored();
        if (material.reflections() > 0 && max(mirrored) > 2 * max(material.diffuse) && max(mirrored) > BLACK) {
            return isGrey(mirrored) ? "mirror" : colour(mirrored) + " mirror";
        }
        return colour(material.diffuse.isBlack() ? material.ambient : material.diffuse);
    }

    /** {@return a word for a colour, as a screen shows it} */
    static String colour(Colour c) {
        double value = max(c);
        if (value <= BLACK) {
            return "black";
        }
        if (isGrey(c)) {
            return value >= WHITE ? "white" : "grey";
        }
        double spread = value - Math.min(c.r, Math.min(c.g, c.b));
        double sixths = value == c.r ? (c.g - c.b) / spread : value == c.g ? 2 + (c.b - c.r) / spread : 4 + (c.r - c.g) / spread;
        double hue = (60 * sixths + 360) % 360;
        int word = 0;
        while (word < HUES.length && hue >= HUES[word]) {
            word++;
        }
        return word == 1 && value < BROWN ? "brown" : HUE_WORDS[word];
    }

    private static boolean isGrey(Colour c) {
        double value = max(c);
        return value - Math.min(c.r, Math.min(c.g, c.b)) < GREY * value;
    }

    private static double max(Colour c) {
        return Math.max(c.r, Math.max(c.g, c.b));
    }
}
