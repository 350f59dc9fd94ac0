package simpleray.scene;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static simpleray.scene.Scenes.grey;
import static simpleray.scene.Scenes.material;
import static simpleray.scene.Scenes.ray;
import static simpleray.scene.Scenes.wall;

import java.util.List;
import java.util.Random;
import java.util.concurrent.CancellationException;
import org.junit.jupiter.api.Test;
import simpleray.math.Colour;
import simpleray.math.Point;
import simpleray.math.Ray;
import simpleray.math.Vector;
import simpleray.scene.RayTree.Between;
import simpleray.scene.RayTree.Lamp;
import simpleray.scene.RayTree.Verdict;

/** Ray trees of glass, of tinted shadows and of lamps. */
class RayTreeRecorderGlassTest {
    private static final int DEPTH = 5;

    private static Material glass(Colour tint, double index) {
        Material glass = material(new Colour(0.1, 0, 0.2), new Colour(0.2, 0.1, 0.3), new Colour(0.3, 0.2, 0.1), 20);
        glass.transmission = tint;
        glass.index = index;
        return glass;
    }

    /** A floor, two glass balls, of which one is tinted, and a mirror ball, under two lamps and a dim sky. */
    private static Scene room() {
        Scene scene = Scenes.of(wall(material(grey(0.2), new Colour(0.7, 0.6, 0.5), grey(0), 3), -2),
            new Sphere(glass(new Colour(0.9, 0.5, 0.25), 1.5), new Point(-1, 0, 0), 1),
            new Sphere(glass(grey(1), 1), new Point(1, 0.5, 0), 0.75),
            new Sphere(material(grey(0), grey(0.1), grey(0.8), 9), new Point(0, -1, -1), 0.5));
        scene.ambient = new Colour(0.1, 0.2, 0.3);
        scene.settings.background = new Colour(0.05, 0.06, 0.07);
        Scenes.light(scene, Scenes.pointLight(-3, 4, 5), new DirectionalLight(new Vector(-1, -1, -2)));
        return scene;
    }

    private static RayTree tree(Scene scene, Ray ray, int depth, Terms terms) {
        RayTreeRecorder recorder = new RayTreeRecorder(scene);
        new WhittedIntegrator(scene, new BruteForceIntersector(scene), terms, new RayStats(), recorder).trace(ray, new Colour(), depth);
        return recorder.tree();
    }

    private static Lamp lamp(Scene scene, int i) {
        return (RayTree.Lamp) tree(scene, Scenes.ahead(), 0, Terms.ALL).hit().lamps().get(i);
    }

    @Test
    void theTreesColourIsThatOfThePictureToTheLastBit() {
        Scene scene = room();
        Random random = new Random(1980);
        List<Terms> stages = List.of(Terms.ALL, new Terms(true, false, false, true, true), new Terms(false, true, false, true, true),
            new Terms(false, false, true, true, true), new Terms(true, true, true, false, true), new Terms(true, true, true, true, false));
        for (int i = 0; i < 600; i++) {
            Vector direction = new Vector(0.6 * random.nextDouble() - 0.3, 0.6 * random.nextDouble() - 0.3, -1).normalised();
            Ray ray = new Ray(new Point(0, 0, 5), direction);
            Terms terms = stages.get(i % stages.size());
            Colour seen = new Colour();
            scene.intersect(ray, seen, DEPTH, terms);

            assertThat(tree(scene, ray, DEPTH, terms).colour()).as(direction + " " + terms).hasToString(seen.toString());
        }
    }

    @Test
    void aHitsPartsAddUpToItsColour() {
        RayTree tree = tree(room(), ray(-1, 0, 5, 0, 0, -1), DEPTH, Terms.ALL);
        RayTree.Hit hit = tree.hit();
        Colour sum = new Colour(hit.ambient());
        sum.add(hit.diffuse());
        sum.add(hit.specular());
        sum.add(hit.mirror().colour());
        sum.add(hit.refracted().colour());

        assertThat(tree.colour()).hasToString(sum.toString());
        assertThat(hit.object()).isEqualTo(new RayTree.Thing(2, "sphere", 0));
        assertThat(hit.enters()).isTrue();
        assertThat(hit.mirror().share()).hasToString("(0.3,0.2,0.1)");
        assertThat(hit.refracted().share()).hasToString("(0.9,0.5,0.25)");
        assertThat(hit.refracted().tree().depth()).isEqualTo(DEPTH - 1);
        assertThat(hit.refracted().tree().ray().direction).hasToString("[0.0,0.0,-1.0]");
        assertThat(hit.refracted().tree().hit().enters()).as("behind it the ray leaves the ball").isFalse();
    }

    /** From (0,0,0.5) in glass of index 2, a ray at 0.6 aside is beyond the critical angle of sine 0.5. */
    @Test
    void atTotalReflectionTheMirrorCarriesBothShares() {
        Scene scene = Scenes.of(wall(glass(new Colour(0.5, 0.25, 0), 2), 0));
        RayTree.Hit hit = tree(scene, ray(0, 0, -4, 0.6, 0, 0.8), 1, Terms.ALL).hit();

        assertThat(hit.enters()).isFalse();
        assertThat(hit.refracted()).isNull();
        assertThat(hit.mirror().share()).hasToString("(0.8,0.45,0.1)");
        assertThat(hit.mirror().tree().ray().direction).hasToString("[0.6,0.0,-0.8]");
    }

    @Test
    void aLampWithNothingBetweenReaches() {
        Scene scene = Scenes.shadowedBy();
        Scenes.light(scene, Scenes.pointLight(3, 0, 4));
        Lamp lamp = lamp(scene, 0);

        assertThat(lamp.light()).isEqualTo(new RayTree.Thing(1, "point light", 0));
        assertThat(lamp.verdict()).isEqualTo(Verdict.REACHES);
        assertThat(lamp.distance()).isEqualTo(5);
        assertThat(lamp.between()).isEmpty();
        assertThat(lamp.arriving()).hasToString("(1.0,1.0,1.0)");
        assertThat(lamp.diffuse()).hasToString("(0.4,0.4,0.4)");
    }

    @Test
    void aLampThroughGlassIsDimmedByEachAndOneBehindAWallIsBlocked() {
        Sphere red = new Sphere(glass(new Colour(1, 0.5, 0.5), 1), new Point(0.75, 0, 1), 0.25);
        Sphere blue = new Sphere(glass(new Colour(0.5, 0.5, 1), 1), new Point(1.5, 0, 2), 0.25);
        Plane opaque = wall(material(grey(0), grey(0), grey(0), 1), 3);
        Scene dim = Scenes.shadowedBy(red, blue);
        Scenes.light(dim, Scenes.pointLight(3, 0, 4));
        Scene dark = Scenes.shadowedBy(red, opaque, blue);
        Scenes.light(dark, Scenes.pointLight(3, 0, 4));

        Lamp dimmed = lamp(dim, 0);
        assertThat(dimmed.verdict()).isEqualTo(Verdict.DIMMED);
        assertThat(dimmed.between()).extracting(Between::object).containsExactly(new RayTree.Thing(2, "sphere", 0),
            new RayTree.Thing(3, "sphere", 0));
        assertThat(dimmed.arriving()).hasToString("(0.5,0.25,0.5)");

        Lamp blocked = lamp(dark, 0);
        assertThat(blocked.verdict()).isEqualTo(Verdict.BLOCKED);
        assertThat(blocked.between()).as("up to the one that blocks").extracting(Between::object)
            .containsExactly(new RayTree.Thing(2, "sphere", 0), new RayTree.Thing(3, "plane", 0));
        assertThat(blocked.arriving().isBlack()).isTrue();
        assertThat(blocked.diffuse().isBlack()).isTrue();
    }

    @Test
    void aSurfaceIsTurnedAwayFromALampBehindItOrAlongIt() {
        Scene scene = Scenes.shadowedBy();
        Scenes.light(scene, Scenes.pointLight(0, 0, -1), Scenes.pointLight(5, 0, 0));

        for (int i = 0; i < 2; i++) {
            assertThat(lamp(scene, i).verdict()).isEqualTo(Verdict.TURNED_AWAY);
            assertThat(lamp(scene, i).arriving().isBlack()).isTrue();
        }
    }

    @Test
    void aRayThatHitsNothingShowsTheBackgroundUnlessOnlyTheLampsTermsAreAskedFor() {
        Scene scene = room();
        Ray up = ray(0, 0, 5, 0, 0, 1);

        assertThat(tree(scene, up, 1, Terms.ALL).colour()).hasToString("(0.05,0.06,0.07)");
        assertThat(tree(scene, up, 1, Terms.ALL).hit()).isNull();
        assertThat(tree(scene, up, 1, new Terms(false, true, true, true, true)).colour().isBlack()).isTrue();
        scene.settings.background = null;
        assertThat(tree(scene, up, 1, Terms.ALL).colour().isBlack()).isTrue();
    }

    @Test
    void anInterruptedThreadRecordsNoTree() {
        Thread.currentThread().interrupt();
        try {
            assertThatThrownBy(() -> tree(room(), Scenes.ahead(), 1, Terms.ALL)).isInstanceOf(CancellationException.class)
                .hasMessage("the story was cancelled");
        } finally {
            assertThat(Thread.interrupted()).isTrue();
        }
    }

    /** Index 1 and Kt 1: the light comes whole, and yet the ball is between. */
    @Test
    void clearGlassIsToldThoughItDimsNothing() {
        Scene scene = Scenes.shadowedBy(new Sphere(glass(grey(1), 1), new Point(0.75, 0, 1), 0.25));
        Scenes.light(scene, Scenes.pointLight(3, 0, 4));

        assertThat(lamp(scene, 0).verdict()).isEqualTo(Verdict.DIMMED);
        assertThat(lamp(scene, 0).between()).extracting(Between::object).containsExactly(new RayTree.Thing(2, "sphere", 0));
        assertThat(lamp(scene, 0).arriving()).hasToString("(1.0,1.0,1.0)");
    }

    @Test
    void aBlackLampWithNothingBetweenReachesAsBlack() {
        Scene scene = Scenes.shadowedBy();
        Scenes.light(scene, new PointLight(new Point(3, 0, 4)));
        scene.getLight(0).intensity = grey(0);

        assertThat(lamp(scene, 0).verdict()).isEqualTo(Verdict.REACHES);
        assertThat(lamp(scene, 0).arriving().isBlack()).isTrue();
    }
}
