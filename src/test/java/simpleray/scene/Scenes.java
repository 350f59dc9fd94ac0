package simpleray.scene;

import simpleray.math.Colour;
import simpleray.math.Point;
import simpleray.math.Ray;
import simpleray.math.Vector;

/** Small scenes and rays whose colours follow from arithmetic. */
public final class Scenes {
    /** No shadows, no reflections. */
    public static final Terms LIGHTING = new Terms(true, true, true, false, false);

    private Scenes() {
    }

    public static Scene of(Object... objects) {
        Scene scene = new Scene();
        scene.setNumberObjects(objects.length);
        for (int i = 0; i < objects.length; i++) {
            scene.setObject(i, objects[i]);
        }
        return scene;
    }

    /** {@return a scene whose ambient light is 1} */
    public static Scene lit(Object... objects) {
        Scene scene = of(objects);
        scene.ambient = grey(1);
        return scene;
    }

    /** {@return a grey wall at z = 0 under an ambient light of 1, and what stands before it} */
    public static Scene shadowedBy(Object... obstacles) {
        Object[] objects = new Object[obstacles.length + 1];
        objects[0] = wall(material(grey(0.25), grey(0.5), grey(0), 0), 0);
        System.arraycopy(obstacles, 0, objects, 1, obstacles.length);
        return lit(objects);
    }

    public static void light(Scene scene, Light... lights) {
        scene.setNumberLights(lights.length);
        for (int i = 0; i < lights.length; i++) {
            scene.setLight(i, lights[i]);
        }
    }

    public static Material material(Colour ambient, Colour diffuse, Colour specular, double shininess) {
        Material material = new Material();
        material.ambient = ambient;
        material.diffuse = diffuse;
        material.specular = specular;
        material.shininess = shininess;
        return material;
    }

    /** {@return a material that only shines of itself, where GA is 1} */
    public static Material glowing(double light) {
        return material(grey(light), grey(0), grey(0), 0);
    }

    /** {@return glass that is seen in reflections up to the tenth} */
    public static Material glass(double specular, double transmission, double index) {
        Material glass = material(grey(0), grey(0), grey(specular), 10);
        glass.transmission = grey(transmission);
        glass.index = index;
        return glass;
    }

    /** {@return a tiny ball that only shines of itself} */
    public static Sphere ball(double x, double y, double z) {
        return new Sphere(glowing(1), new Point(x, y, z), 1e-6);
    }

    public static Colour grey(double light) {
        return new Colour(light, light, light);
    }

    /** {@return the plane at this z, its normal towards the viewer} */
    public static Plane wall(Material material, double z) {
        return new Plane(material, new Vector(0, 0, 1), z);
    }

    public static PointLight pointLight(double x, double y, double z) {
        return new PointLight(new Point(x, y, z));
    }

    public static Ray ray(double x, double y, double z, double dx, double dy, double dz) {
        return new Ray(new Point(x, y, z), new Vector(dx, dy, dz));
    }

    /** {@return the ray from (0,0,2) straight ahead, down the z axis} */
    public static Ray ahead() {
        return ray(0, 0, 2, 0, 0, -1);
    }

    /** {@return what the ray sees} */
    public static Colour seen(Scene scene, Ray ray, int depth, Terms terms) {
        Colour colour = new Colour(7, 7, 7);
        scene.intersect(ray, colour, depth, terms);
        return colour;
    }
}
