package simpleray.scene;

import static org.assertj.core.api.Assertions.assertThat;
import static simpleray.text.SceneText.reader;

import java.io.IOException;
import org.junit.jupiter.api.Test;
import simpleray.math.Colour;
import simpleray.math.Point;
import simpleray.math.Ray;
import simpleray.math.Vector;

/** Trees of single rays. */
class RayTreeRecorderTest {
    private static final int DEPTH = 6;

    @Test
    void beyondTheMostRaysOnlyColoursAreToldAndTheyAreRight() throws IOException {
        Scene scene = facingMirrors();
        Colour seen = new Colour();
        scene.intersect(ray(), seen, DEPTH);

        RayTree whole = tree(scene, Terms.ALL, DEPTH);
        RayTree cut = tree(scene, Terms.ALL, DEPTH, new RayTreeRecorder(scene, false, 3, 0, 0));

        assertThat(rays(whole)).isEqualTo(DEPTH + 1);
        assertThat(rays(cut)).isEqualTo(3);
        assertThat(whole.colour()).hasToString(seen.toString());
        assertThat(cut.colour()).hasToString(seen.toString());
        RayTree last = cut.hit().mirror().tree().hit().mirror().tree().hit().mirror().tree();
        assertThat(last.told()).isFalse();
        assertThat(last.hit()).isNull();
        assertThat(last.colour().isBlack()).isFalse();
    }

    @Test
    void whatDoesNotCountHasNoTree() throws IOException {
        Scene scene = facingMirrors();

        assertThat(tree(scene, Terms.ALL, 0).hit().mirror()).isNull();
        assertThat(tree(scene, Terms.ALL, 1).hit().refracted()).isNull();
        Terms flat = new Terms(true, true, true, true, false);
        assertThat(tree(scene, flat, 1).hit().mirror()).isNull();
    }

    @Test
    void aTreeTellsWhatAShadowlessPictureShows() throws IOException {
        Scene scene = new Scene();
        scene.read(reader("2  1 0 0 1 -2  0 0 0  0.5 0.5 0.5  0.25 0.25 0.25  3   0 0 0 3 0.5  0 0 0  0 0 0  0 0 0  1\n"
            + "0 0 0  1  0  1 1 1  0 0 6"));

        RayTree shadows = tree(scene, Terms.ALL, 0);
        RayTree none = tree(scene, new Terms(false, true, true, false, false), 0);

        assertThat(((RayTree.Lamp) shadows.hit().lamps().get(0)).verdict()).isEqualTo(RayTree.Verdict.BLOCKED);
        assertThat(shadows.colour().isBlack()).isTrue();
        assertThat(((RayTree.Lamp) none.hit().lamps().get(0)).verdict()).isEqualTo(RayTree.Verdict.NO_SHADOWS);
        assertThat(none.hit().diffuse()).hasToString(new Colour(0.5, 0.5, 0.5).toString());
        assertThat(none.hit().specular()).hasToString(new Colour(0.25, 0.25, 0.25).toString());
        assertThat(none.colour()).hasToString(new Colour(0.75, 0.75, 0.75).toString());
    }

    /** Of the light's points (-3,0,2), (3,0,2), (-3,0,-6), (3,0,-6) a ball blocks the second; the wall at z = -2 is turned away from the last two. */
    private static Scene areaLight(String ball) throws IOException {
        Scene scene = new Scene();
        scene.read(reader("2  1 0 0 1 -2  0 0 0  1 1 1  0 0 0  1   0 1.5 0 0 0.5  0 0 0  0 0 0  0 0 0  1" + ball
            + "\n0 0 0  1\n2  1 0.5 0.25  -6 0 6  12 0 0  0 0 -16  2"));
        return scene;
    }

    @Test
    void anAreaLightIsOneContribution() throws IOException {
        RayTree tree = tree(areaLight(""), Terms.ALL, 0);

        assertThat(tree.hit().lamps()).hasSize(1);
        RayTree.Area area = (RayTree.Area) tree.hit().lamps().get(0);
        assertThat(area.light()).isEqualTo(new RayTree.Thing(1, "area light", 3));
        assertThat(area.intensity()).hasToString("(1.0,0.5,0.25)");
        assertThat(area.points()).isEqualTo(4);
        assertThat(area.shadows()).isTrue();
        assertThat(area.whole()).isEqualTo(1);
        assertThat(area.dimmed()).isZero();
        assertThat(area.blocked()).isEqualTo(1);
        assertThat(area.turnedAway()).isEqualTo(2);
        assertThat(area.between()).containsExactly(new RayTree.Thing(2, "sphere", 1));
        assertThat(area.diffuse().r).isEqualTo(0.25 * 0.8);
        assertThat(area.specular().isBlack()).isTrue();
        assertThat(area.lamps()).isEmpty();
        assertThat(tree.hit().diffuse()).hasToString(area.diffuse().toString());
    }

    @Test
    void glassBetweenDimsAPointAndClearGlassDoesNot() throws IOException {
        RayTree.Area dimmed = (RayTree.Area) tree(areaLight(" transmit 0.5 1 1 1"), Terms.ALL, 0).hit().lamps().get(0);
        assertThat(dimmed.whole()).isEqualTo(1);
        assertThat(dimmed.dimmed()).isEqualTo(1);
        assertThat(dimmed.blocked()).isZero();
        assertThat(dimmed.between()).extracting(RayTree.Thing::number).containsExactly(2);
        RayTree.Area clear = (RayTree.Area) tree(areaLight(" transmit 1 1 1 1"), Terms.ALL, 0).hit().lamps().get(0);
        assertThat(clear.whole()).isEqualTo(2);
        assertThat(clear.between()).isEmpty();
    }

    @Test
    void withoutShadowsAllPointsInFrontReach() throws IOException {
        RayTree.Area area = (RayTree.Area) tree(areaLight(""), Scenes.LIGHTING, 0).hit().lamps().get(0);
        assertThat(area.shadows()).isFalse();
        assertThat(area.whole()).isEqualTo(2);
        assertThat(area.turnedAway()).isEqualTo(2);
        assertThat(area.between()).isEmpty();
    }

    @Test
    void eachPointOfAnAreaLightIsToldOnRequest() throws IOException {
        Scene scene = areaLight("");
        RayTree.Area area = (RayTree.Area) tree(scene, Terms.ALL, 0, new RayTreeRecorder(scene, true)).hit().lamps().get(0);

        assertThat(area.lamps()).extracting(RayTree.Lamp::verdict).containsExactly(RayTree.Verdict.REACHES, RayTree.Verdict.BLOCKED,
            RayTree.Verdict.TURNED_AWAY, RayTree.Verdict.TURNED_AWAY);
        assertThat(area.lamps()).extracting(lamp -> lamp.intensity().toString()).containsOnly("(0.25,0.125,0.0625)");
        assertThat(area.lamps()).extracting(RayTree.Lamp::distance).containsExactly(5.0, 5.0, 5.0, 5.0);
        assertThat(area.lamps().get(1).between()).extracting(between -> between.object().number()).containsExactly(2);
    }

    @Test
    void beyondTheMostPointsOnlySumsAreToldAndTheyAreRight() throws IOException {
        Scene scene = areaLight("");
        RayTreeRecorder recorder = new RayTreeRecorder(scene, true, 9, 8, 100);
        for (int i = 0; i < 2; i++) {
            assertThat(((RayTree.Area) tree(scene, Terms.ALL, 0, recorder).hit().lamps().get(0)).lamps()).hasSize(4);
        }
        RayTree cut = tree(scene, Terms.ALL, 0, recorder);
        RayTree.Area area = (RayTree.Area) cut.hit().lamps().get(0);
        assertThat(area.lamps()).isNull();
        assertThat(area.diffuse().r).isEqualTo(0.25 * 0.8);
        assertThat(area.blocked()).isEqualTo(1);
    }

    @Test
    void whatLiesBetweenIsLeftOutWhereFindingItTakesTooLong() throws IOException {
        Scene scene = areaLight("");
        RayTreeRecorder recorder = new RayTreeRecorder(scene, false, 9, 8, 4);      // two tests for each blocked point
        for (int i = 0; i < 2; i++) {
            assertThat(((RayTree.Area) tree(scene, Terms.ALL, 0, recorder).hit().lamps().get(0)).between()).hasSize(1);
        }
        RayTree.Area later = (RayTree.Area) tree(scene, Terms.ALL, 0, recorder).hit().lamps().get(0);
        assertThat(later.between()).isNull();
        assertThat(later.blocked()).isEqualTo(1);
    }

    @Test
    void anAreaLightOfARayThatIsNotToldIsNotTold() throws IOException {
        Scene scene = areaLight("");
        RayTree cut = tree(scene, Terms.ALL, 0, new RayTreeRecorder(scene, true, 0, 8, 4));
        assertThat(cut.told()).isFalse();
        assertThat(cut.colour().r).isEqualTo(0.25 * 0.8);
    }

    private static int rays(RayTree tree) {
        if (!tree.told()) {
            return 0;
        }
        return 1 + (tree.hit() == null || tree.hit().mirror() == null ? 0 : rays(tree.hit().mirror().tree()));
    }

    private static RayTree tree(Scene scene, Terms terms, int depth) {
        return tree(scene, terms, depth, new RayTreeRecorder(scene));
    }

    private static RayTree tree(Scene scene, Terms terms, int depth, RayTreeRecorder recorder) {
        new WhittedIntegrator(scene, new BruteForceIntersector(scene), terms, new RayStats(), recorder).trace(ray(), new Colour(), depth);
        return recorder.tree();
    }

    private static Ray ray() {
        return new Ray(new Point(0, 0, 2), new Vector(0, 0, -1));
    }

    private static Scene facingMirrors() throws IOException {
        Scene scene = new Scene();
        scene.read(reader("2  1 0 0 1 -2  0.3 0.2 0.1  0 0 0  0.5 0.5 0.5  99   1 0 0 1 4  0.1 0.2 0.3  0 0 0  0.7 0.7 0.7  99\n1 1 1  0"));
        return scene;
    }
}
