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
import simpleray.scene.Story.Between;
import simpleray.scene.Story.Lamp;
import simpleray.scene.Story.Verdict;

/** Stories of glass, of tinted shadows and of lamps. */
class GlassStoryTest {
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

    private static Story story(Scene scene, Ray ray, int depth, Terms terms) {
        return new Storyteller(scene, Probe.of(scene), terms).tell(ray, depth);
    }

    private static Lamp lamp(Scene scene, int i) {
        return story(scene, Scenes.ahead(), 0, Terms.ALL).hit().lamps().get(i);
    }

    @Test
    void theStorysColourIsThatOfThePictureToTheLastBit() {
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

            assertThat(story(scene, ray, DEPTH, terms).colour()).as(direction + " " + terms).hasToString(seen.toString());
        }
    }

    @Test
    void aHitsPartsAddUpToItsColour() {
        Story story = story(room(), ray(-1, 0, 5, 0, 0, -1), DEPTH, Terms.ALL);
        Story.Hit hit = story.hit();
        Colour sum = new Colour(hit.ambient());
        sum.add(hit.diffuse());
        sum.add(hit.specular());
        sum.add(hit.mirror().colour());
        sum.add(hit.refracted().colour());

        assertThat(story.colour()).hasToString(sum.toString());
        assertThat(hit.object()).isEqualTo(new Story.Thing(2, "sphere", 0));
        assertThat(hit.enters()).isTrue();
        assertThat(hit.mirror().share()).hasToString("(0.3,0.2,0.1)");
        assertThat(hit.refracted().share()).hasToString("(0.9,0.5,0.25)");
        assertThat(hit.refracted().story().depth()).isEqualTo(DEPTH - 1);
        assertThat(hit.refracted().story().ray().direction).hasToString("[0.0,0.0,-1.0]");
        assertThat(hit.refracted().story().hit().enters()).as("behind it the ray leaves the ball").isFalse();
    }

    /** From (0,0,0.5) in glass of index 2, a ray at 0.6 aside is beyond the critical angle of sine 0.5. */
    @Test
    void atTotalReflectionTheMirrorCarriesBothShares() {
        Scene scene = Scenes.of(wall(glass(new Colour(0.5, 0.25, 0), 2), 0));
        Story.Hit hit = story(scene, ray(0, 0, -4, 0.6, 0, 0.8), 1, Terms.ALL).hit();

        assertThat(hit.enters()).isFalse();
        assertThat(hit.refracted()).isNull();
        assertThat(hit.mirror().share()).hasToString("(0.8,0.45,0.1)");
        assertThat(hit.mirror().story().ray().direction).hasToString("[0.6,0.0,-0.8]");
    }

    @Test
    void aLampWithNothingBetweenReaches() {
        Scene scene = Scenes.shadowedBy();
        Scenes.light(scene, Scenes.pointLight(3, 0, 4));
        Lamp lamp = lamp(scene, 0);

        assertThat(lamp.light()).isEqualTo(new Story.Thing(1, "point light", 0));
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
        assertThat(dimmed.between()).extracting(Between::object).containsExactly(new Story.Thing(2, "sphere", 0),
            new Story.Thing(3, "sphere", 0));
        assertThat(dimmed.arriving()).hasToString("(0.5,0.25,0.5)");

        Lamp blocked = lamp(dark, 0);
        assertThat(blocked.verdict()).isEqualTo(Verdict.BLOCKED);
        assertThat(blocked.between()).as("up to the one that blocks").extracting(Between::object)
            .containsExactly(new Story.Thing(2, "sphere", 0), new Story.Thing(3, "plane", 0));
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

        assertThat(story(scene, up, 1, Terms.ALL).colour()).hasToString("(0.05,0.06,0.07)");
        assertThat(story(scene, up, 1, Terms.ALL).hit()).isNull();
        assertThat(story(scene, up, 1, new Terms(false, true, true, true, true)).colour().isBlack()).isTrue();
        scene.settings.background = null;
        assertThat(story(scene, up, 1, Terms.ALL).colour().isBlack()).isTrue();
    }

    @Test
    void anInterruptedThreadTellsNoStory() {
        Thread.currentThread().interrupt();
        try {
            assertThatThrownBy(() -> story(room(), Scenes.ahead(), 1, Terms.ALL)).isInstanceOf(CancellationException.class)
                .hasMessage("the story was cancelled");
        } finally {
            assertThat(Thread.interrupted()).isTrue();
        }
    }

    @Test
    void aProbeDimsLightByWhatIsBetween() {
        Scene scene = room();
        Colour light = new Colour(1, 2, 4);
        Probe probe = Probe.of(scene);
        Ray through = ray(-1, 0, 5, 0, 0, -1);

        probe.dim(light, through, 6.5, 0);
        assertThat(light).hasToString("(0.9,1.0,1.0)");
        probe.dim(light, through, 3, 0);
        assertThat(light).as("nothing is so near").hasToString("(0.9,1.0,1.0)");
        probe.dim(light, through, 100, 0);
        assertThat(light.isBlack()).as("the floor is next").isTrue();
        assertThat(probe.between(through, 100, 0)).as("in the scene's order, up to what blocks").containsExactly(0);
    }
}
