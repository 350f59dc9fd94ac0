package simpleray.scene;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static simpleray.scene.Scenes.grey;
import static simpleray.scene.Scenes.material;
import static simpleray.scene.Scenes.pointLight;

import java.util.Arrays;
import org.assertj.core.data.Offset;
import org.junit.jupiter.api.Test;
import simpleray.math.Colour;
import simpleray.math.Point;
import simpleray.math.Vector;

/** Objects of n = 1 and Kt = 1 that send back no light themselves: a picture is the same with and without them. */
class WhittedIntegratorInvisibleGlassTest {
    private static final Offset<Double> CLOSE = within(1e-9);
    private static final int SIDE = 24;
    private static final int DEPTH = 10;

    @Test
    void aSphereOfNothingIsInvisible() {
        assertInvisible(new Sphere(nothing(), new Point(0.3, 0.2, -0.5), 0.9));
    }

    @Test
    void aPlaneATriangleAndACylinderOfNothingAreInvisible() {
        assertInvisible(new Plane(nothing(), new Vector(0.2, 0.1, 1), -0.7));
        assertInvisible(new Triangle(nothing(), new Point(-1, -1, 0), new Point(1, -1, -0.5), new Point(0, 1.2, -1)));
        assertInvisible(new Cylinder(nothing(), new Point(-0.8, -0.5, 0), new Point(0.9, 0.4, -0.6), 0.4));
    }

    @Test
    void spheresWithinSpheresAreInvisible() {
        assertInvisible(new Sphere(nothing(), new Point(0, 0, -0.5), 0.9), new Sphere(nothing(), new Point(0, 0.1, -0.5), 0.5));
    }

    @Test
    void aSphereOfSomethingIsSeen() {
        Material glass = nothing();
        glass.index = 1.1;

        assertThat(pixels(room(new Sphere(glass, new Point(0.3, 0.2, -0.5), 0.9)))).isNotEqualTo(pixels(room()));
    }

    private static void assertInvisible(Object... objects) {
        double[] without = pixels(room());
        double[] with = pixels(room(objects));

        assertThat(Arrays.stream(without).distinct().count()).as("a picture with something in it").isGreaterThan(SIDE * SIDE);
        for (int i = 0; i < without.length; i++) {
            assertThat(with[i]).as("pixel " + i / 3 % SIDE + ',' + i / 3 / SIDE).isEqualTo(without[i], CLOSE);
        }
    }

    /** {@return a floor, a mirror behind and a ball before it, two lights and a background, with some objects more} */
    private static Scene room(Object... more) {
        Object[] objects = Arrays.copyOf(more, more.length + 3);
        objects[more.length] = new Plane(material(grey(0.2), new Colour(0.8, 0.6, 0.2), grey(0), 1), new Vector(0, 1, 0), -1.5);
        objects[more.length + 1] = new Plane(material(grey(0), new Colour(0, 0.1, 0.2), grey(0.5), 2), new Vector(0, 0.1, 1), -4);
        objects[more.length + 2] = new Sphere(material(grey(0.1), new Colour(0.2, 0.2, 0.9), grey(0), 1), new Point(0, 0, -2.5), 0.7);
        Scene scene = Scenes.of(objects);
        scene.ambient = grey(0.5);
        scene.settings.background = new Colour(0.1, 0.3, 0.6);
        Scenes.light(scene, pointLight(2, 3, 4), new DirectionalLight(new Vector(1, -2, -1.5)));
        return scene;
    }

    private static Material nothing() {
        Material nothing = material(grey(0), grey(0), grey(0), DEPTH);
        nothing.transmission = grey(1);
        return nothing;
    }

    private static double[] pixels(Scene scene) {
        SimpleCamera camera = new SimpleCamera(SIDE, SIDE);
        double[] pixels = new double[3 * SIDE * SIDE];
        for (int i = 0; i < SIDE * SIDE; i++) {
            Colour colour = Scenes.seen(scene, camera.ray(i % SIDE, i / SIDE), DEPTH, Terms.ALL);
            pixels[3 * i] = colour.r;
            pixels[3 * i + 1] = colour.g;
            pixels[3 * i + 2] = colour.b;
        }
        return pixels;
    }
}
