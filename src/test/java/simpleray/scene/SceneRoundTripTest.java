package simpleray.scene;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static simpleray.text.SceneText.reader;
import static simpleray.text.SceneText.written;

import java.io.IOException;
import java.util.Random;
import org.junit.jupiter.api.Test;
import simpleray.math.Colour;
import simpleray.math.Point;
import simpleray.math.Ray;
import simpleray.math.Vector;
import simpleray.text.SceneReader;
import simpleray.text.SceneWriter;

class SceneRoundTripTest {
    private static final int SCENES = 500;
    private static final long SEED = 20100623;

    @Test
    void aSceneIsWrittenALineForEachThing() {
        Scene scene = Scenes.of(new Sphere(), new Plane());
        scene.ambient = new Colour(0.25, 0.5, 1);
        Scenes.light(scene, new PointLight(), new DirectionalLight());

        assertThat(written(scene::write)).isEqualTo("""
            # number of objects
            2
            0  0.0 0.0 0.0 1.0  1.0 1.0 1.0  1.0 1.0 1.0  0.0 0.0 0.0  2.0
            1  0.0 1.0 0.0 0.0  1.0 1.0 1.0  1.0 1.0 1.0  0.0 0.0 0.0  2.0
            # ambient light
            0.25 0.5 1.0
            # number of lights
            2
            0  1.0 1.0 1.0  0.0 0.0 0.0
            1  1.0 1.0 1.0  0.0 -1.0 0.0
            """);
    }

    @Test
    void anySceneReadsBackBitForBit() throws IOException {
        for (int i = 0; i < SCENES; i++) {
            Scene before = random(new Random(SEED + i));
            Scene after = new Scene();
            try (SceneReader is = reader(written(before::write))) {
                after.read(is);
                assertThat(is.warnings()).isEmpty();
            }
            assertThat(SceneBits.of(after)).as("seed " + (SEED + i)).isEqualTo(SceneBits.of(before));
        }
    }

    @Test
    void anObjectOfAClassWithoutCodeCannotBeWritten() {
        Scene scene = Scenes.of(new Nothing());

        assertThatThrownBy(() -> written(scene::write)).isInstanceOf(IllegalArgumentException.class)
            .hasMessage("a scene file has no code for " + Nothing.class.getName());
    }

    private static Scene random(Random random) {
        Object[] objects = new Object[random.nextInt(5)];
        for (int i = 0; i < objects.length; i++) {
            objects[i] = object(random);
        }
        Scene scene = Scenes.of(objects);
        scene.ambient = colour(random);
        Light[] lights = new Light[random.nextInt(4)];
        for (int i = 0; i < lights.length; i++) {
            lights[i] = random.nextBoolean() ? new DirectionalLight(vector(random))
                : new PointLight(point(random));
            lights[i].intensity = colour(random);
        }
        Scenes.light(scene, lights);
        return scene;
    }

    private static Object object(Random random) {
        Material material = material(random);
        return switch (random.nextInt(4)) {
            case 0 -> new Plane(material, vector(random), number(random));
            case 1 -> new Triangle(material, near(random), near(random), near(random));
            case 2 -> new Cylinder(material, point(random), near(random), above(random));
            default -> new Sphere(material, point(random), above(random));
        };
    }

    private static Material material(Random random) {
        return Scenes.material(colour(random), colour(random), colour(random), Math.abs(number(random)));
    }

    private static Colour colour(Random random) {
        return new Colour(Math.abs(number(random)), Math.abs(number(random)), Math.abs(number(random)));
    }

    private static Vector vector(Random random) {
        return new Vector(number(random), above(random), number(random));
    }

    private static Point point(Random random) {
        return new Point(number(random), number(random), number(random));
    }

    /** {@return a point near the origin: three of them are hardly ever on one line} */
    private static Point near(Random random) {
        return new Point(random.nextGaussian(), random.nextGaussian(), random.nextGaussian());
    }

    private static double above(Random random) {
        return Math.max(Double.MIN_VALUE, Math.abs(number(random)));
    }

    /** {@return a number: as people write them, or any finite pattern of bits, or a zero of either sign} */
    private static double number(Random random) {
        double any = Double.longBitsToDouble(random.nextLong());
        return switch (random.nextInt(4)) {
            case 0 -> random.nextInt(2001) / 100.0 - 10;
            case 1 -> random.nextGaussian();
            case 2 -> random.nextBoolean() ? 0.0 : -0.0;
            default -> Double.isFinite(any) ? any : Double.MAX_VALUE;
        };
    }

    /** Something that a scene file cannot hold. */
    private static final class Nothing extends Object {
        Nothing() {
            super(new Material());
        }

        @Override
        public double intersect(Ray ray) {
            return MISS;
        }

        @Override
        public Vector normal(Point pt) {
            return new Vector(0, 0, 1);
        }

        @Override
        public void print(SceneWriter os) {
            throw new UnsupportedOperationException();
        }

        @Override
        public void read(SceneReader is) {
            throw new UnsupportedOperationException();
        }

        @Override
        public void write(SceneWriter os) {
            throw new UnsupportedOperationException();
        }
    }
}
