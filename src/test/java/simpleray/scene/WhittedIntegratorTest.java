package simpleray.scene;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static simpleray.scene.Scenes.grey;
import static simpleray.scene.Scenes.material;
import static simpleray.scene.Scenes.ray;
import static simpleray.scene.Scenes.wall;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;
import simpleray.math.Colour;
import simpleray.math.Point;
import simpleray.math.Ray;
import simpleray.math.Vector;

/** What Whitted's recursion finds, counts, and says while it does. */
class WhittedIntegratorTest {
    private static final int DEPTH = 5;
    private static final int RAYS = 300;

    private final RayStats stats = new RayStats();

    /** Adds up what it hears, in the order in which it hears it, and holds each ray's colour to the sum. */
    private static final class Adder implements Recorder {
        private final Deque<Colour> sums = new ArrayDeque<>();
        private final List<String> heard = new ArrayList<>();
        private boolean hit;
        private int hits;

        @Override
        public void begin(Ray ray, int depth, int level) {
            heard.add("begin " + level + " of " + depth);
            sums.push(new Colour());
            hit = false;
        }

        @Override
        public void hit(Ray ray, Interaction at) {
            heard.add("hit " + at.place);
            hit = true;
            hits++;
        }

        @Override
        public void light(int number, VisibilityTester seen, Colour arriving, Vector halfway, double cosine, Colour diffuse,
                Colour specular) {
            heard.add("light " + number + ": " + diffuse.r + " + " + specular.r);
        }

        @Override
        public void lit(Colour ambient, Colour diffuse, Colour specular) {
            heard.add("lit " + ambient.r + " + " + diffuse.r + " + " + specular.r);
            sums.peek().add(ambient);
            sums.peek().add(diffuse);
            sums.peek().add(specular);
        }

        @Override
        public void followed(Colour share, Colour added, boolean refracted) {
            heard.add((refracted ? "refracted " : "mirrored ") + share.r + ": " + added.r);
            sums.peek().add(added);
            hit = true;
        }

        @Override
        public void end(Colour colour) {
            heard.add("end " + colour.r);
            Colour sum = sums.pop();
            if (hit) {
                assertThat(colour).hasToString(sum.toString());
            }
        }
    }

    private WhittedIntegrator integrator(Scene scene, Terms terms, Recorder recorder) {
        return new WhittedIntegrator(scene, new BruteForceIntersector(scene), terms, stats, recorder);
    }

    /** A floor, a glass ball and a mirror ball under two lights. */
    private static Scene room() {
        Material glass = material(new Colour(0.1, 0, 0.2), new Colour(0.2, 0.1, 0.3), new Colour(0.3, 0.2, 0.1), 20);
        glass.transmission = new Colour(0.9, 0.5, 0.25);
        glass.index = 1.5;
        Scene scene = Scenes.lit(wall(material(grey(0.2), new Colour(0.7, 0.6, 0.5), grey(0.1), 3), -2),
            new Sphere(glass, new Point(-1, 0, 0), 1), new Sphere(material(grey(0), grey(0.1), grey(0.8), 9), new Point(1, 0, 0), 0.5));
        scene.settings.background = new Colour(0.05, 0.06, 0.07);
        Scenes.light(scene, Scenes.pointLight(-3, 4, 5), new DirectionalLight(new Vector(-1, -1, -2)));
        return scene;
    }

    private static Ray next(Random random) {
        return new Ray(new Point(0, 0, 5), new Vector(0.8 * random.nextDouble() - 0.4, 0.8 * random.nextDouble() - 0.4, -1).normalised());
    }

    /** A wall of Ka 0.25, Kd 0.5 and Ks 0.5 reflects one that glows by 0.75; a lamp is where the eye is. */
    @Test
    void aRecorderHearsEachTermInTheOrderOfTheSum() {
        Scene scene = Scenes.lit(wall(material(grey(0.25), grey(0.5), grey(0.5), 1), 0), wall(Scenes.glowing(0.75), 4));
        Scenes.light(scene, Scenes.pointLight(0, 0, 2));
        Adder adder = new Adder();
        Colour colour = new Colour();

        assertThat(integrator(scene, Terms.ALL, adder).trace(Scenes.ahead(), colour, 1)).isTrue();

        assertThat(colour.r).isEqualTo(0.25 + 0.5 + 0.5 + 0.375);
        assertThat(adder.heard).containsExactly("begin 0 of 1", "hit 0", "light 0: 0.5 + 0.5", "lit 0.25 + 0.5 + 0.5",
            "begin 1 of 0", "hit 1", "light 0: 0.0 + 0.0", "lit 0.75 + 0.0 + 0.0", "end 0.75", "mirrored 0.5: 0.375", "end 1.625");
    }

    @Test
    void whatARecorderHearsAddsUpToTheColourBitForBit() {
        Adder adder = new Adder();
        WhittedIntegrator integrator = integrator(room(), Terms.ALL, adder);
        Random random = new Random(1980);
        for (int i = 0; i < RAYS; i++) {
            integrator.trace(next(random), new Colour(), DEPTH);
        }

        assertThat(adder.hits).isGreaterThan(2 * RAYS);
        assertThat(adder.sums).isEmpty();
    }

    @Test
    void theColourIsTheSameWithAndWithoutARecorder() {
        Scene scene = room();
        List<Terms> wanted = List.of(Terms.ALL, new Terms(true, false, false, true, true), new Terms(false, true, false, true, true),
            new Terms(false, false, true, true, true), new Terms(true, true, true, false, true), new Terms(true, true, true, true, false));
        Random random = new Random(1980);
        for (int i = 0; i < RAYS; i++) {
            Terms terms = wanted.get(i % wanted.size());
            Ray ray = next(random);
            Colour alone = new Colour();
            Colour heard = new Colour();

            boolean hit = integrator(scene, terms, null).trace(ray, alone, DEPTH);

            assertThat(integrator(scene, terms, new Recorder() { }).trace(ray, heard, DEPTH)).isEqualTo(hit);
            assertThat(heard).hasToString(alone.toString());
        }
    }

    @Test
    void aRecorderHearsOfLightsWhoseTermsAreNotAskedFor() {
        Scene scene = Scenes.shadowedBy();
        Scenes.light(scene, Scenes.pointLight(0, 0, 2));
        Adder adder = new Adder();

        integrator(scene, new Terms(true, false, false, false, false), adder).trace(Scenes.ahead(), new Colour(), 1);

        assertThat(adder.heard).contains("light 0: 0.0 + 0.0", "lit 0.25 + 0.0 + 0.0");
    }

    @Test
    void aMissIsTheBackgroundAndIsHeardAsSuch() {
        Scene scene = room();
        Adder adder = new Adder();
        Colour colour = new Colour();

        assertThat(integrator(scene, Terms.ALL, adder).trace(ray(0, 0, 5, 0, 0, 1), colour, 1)).isFalse();

        assertThat(colour).hasToString("(0.05,0.06,0.07)");
        assertThat(adder.heard).containsExactly("begin 0 of 1", "end 0.05");
    }

    /** Between two mirrors; the light is in front of both. */
    @Test
    void raysAreCountedByKindAndLevel() {
        Scene scene = Scenes.of(wall(material(grey(0), grey(0), grey(1), 9), 0), wall(material(grey(0), grey(0), grey(1), 9), 3));
        Scenes.light(scene, Scenes.pointLight(0, 0, 1));

        integrator(scene, Terms.ALL, null).trace(Scenes.ahead(), new Colour(), 3);

        assertThat(stats.primary).isEqualTo(1);
        assertThat(stats.reflected).isEqualTo(3);
        assertThat(stats.refracted).isZero();
        assertThat(stats.shadow).isEqualTo(4);
        assertThat(stats.depths).containsExactly(1, 1, 1, 1);
        assertThat(stats.rays()).isEqualTo(8);
    }

    @Test
    void glassWithoutKsHasRefractedRaysAlone() {
        Scene scene = Scenes.of(new Sphere(Scenes.glass(0, 1, 1.5), new Point(), 1));
        Adder adder = new Adder();

        integrator(scene, Terms.ALL, adder).trace(Scenes.ahead(), new Colour(), 5);

        assertThat(adder.heard).filteredOn(what -> what.startsWith("begin")).containsExactly("begin 0 of 5", "begin 1 of 4", "begin 2 of 3");
        assertThat(stats.reflected).isZero();
        assertThat(stats.refracted).isEqualTo(2);
    }

    @Test
    void aSceneOfWhichAnObjectIsMissingIsRefused() {
        Scene scene = new Scene();
        scene.setNumberObjects(1);

        assertThatThrownBy(() -> integrator(scene, Terms.ALL, null)).isInstanceOf(IllegalStateException.class);
    }
}
