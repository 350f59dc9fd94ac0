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
        RayTree cut = tree(scene, Terms.ALL, DEPTH, new RayTreeRecorder(scene, 3));

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

        assertThat(shadows.hit().lamps().get(0).verdict()).isEqualTo(RayTree.Verdict.BLOCKED);
        assertThat(shadows.colour().isBlack()).isTrue();
        assertThat(none.hit().lamps().get(0).verdict()).isEqualTo(RayTree.Verdict.NO_SHADOWS);
        assertThat(none.hit().diffuse()).hasToString(new Colour(0.5, 0.5, 0.5).toString());
        assertThat(none.hit().specular()).hasToString(new Colour(0.25, 0.25, 0.25).toString());
        assertThat(none.colour()).hasToString(new Colour(0.75, 0.75, 0.75).toString());
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
