package simpleray.scene;

import static org.assertj.core.api.Assertions.assertThat;
import static simpleray.text.SceneText.reader;

import java.io.IOException;
import org.junit.jupiter.api.Test;
import simpleray.math.Colour;
import simpleray.math.Point;
import simpleray.math.Ray;
import simpleray.math.Vector;

/** Stories of single rays. */
class StorytellerTest {
    private static final int DEPTH = 6;

    @Test
    void beyondTheMostRaysOnlyColoursAreToldAndTheyAreRight() throws IOException {
        Scene scene = facingMirrors();
        Colour seen = new Colour();
        scene.intersect(ray(), seen, DEPTH);

        Story whole = new Storyteller(scene, Probe.of(scene), Terms.ALL).tell(ray(), DEPTH);
        Story cut = new Storyteller(scene, Probe.of(scene), Terms.ALL, 3).tell(ray(), DEPTH);

        assertThat(rays(whole)).isEqualTo(DEPTH + 1);
        assertThat(rays(cut)).isEqualTo(3);
        assertThat(whole.colour()).hasToString(seen.toString());
        assertThat(cut.colour()).hasToString(seen.toString());
        Story last = cut.hit().mirror().story().hit().mirror().story().hit().mirror().story();
        assertThat(last.told()).isFalse();
        assertThat(last.hit()).isNull();
        assertThat(last.colour().isBlack()).isFalse();
    }

    @Test
    void whatDoesNotCountHasNoStory() throws IOException {
        Scene scene = facingMirrors();

        assertThat(new Storyteller(scene, Probe.of(scene), Terms.ALL).tell(ray(), 0).hit().mirror()).isNull();
        assertThat(new Storyteller(scene, Probe.of(scene), Terms.ALL).tell(ray(), 1).hit().refracted()).isNull();
        Terms flat = new Terms(true, true, true, true, false);
        assertThat(new Storyteller(scene, Probe.of(scene), flat).tell(ray(), 1).hit().mirror()).isNull();
    }

    @Test
    void aStoryTellsWhatAShadowlessPictureShows() throws IOException {
        Scene scene = new Scene();
        scene.read(reader("2  1 0 0 1 -2  0 0 0  0.5 0.5 0.5  0.25 0.25 0.25  3   0 0 0 3 0.5  0 0 0  0 0 0  0 0 0  1\n"
            + "0 0 0  1  0  1 1 1  0 0 6"));

        Story shadows = new Storyteller(scene, Probe.of(scene), Terms.ALL).tell(ray(), 0);
        Story none = new Storyteller(scene, Probe.of(scene), new Terms(false, true, true, false, false)).tell(ray(), 0);

        assertThat(shadows.hit().lamps().get(0).verdict()).isEqualTo(Story.Verdict.BLOCKED);
        assertThat(shadows.colour().isBlack()).isTrue();
        assertThat(none.hit().lamps().get(0).verdict()).isEqualTo(Story.Verdict.NO_SHADOWS);
        assertThat(none.hit().diffuse()).hasToString(new Colour(0.5, 0.5, 0.5).toString());
        assertThat(none.hit().specular()).hasToString(new Colour(0.25, 0.25, 0.25).toString());
        assertThat(none.colour()).hasToString(new Colour(0.75, 0.75, 0.75).toString());
    }

    private static int rays(Story story) {
        if (!story.told()) {
            return 0;
        }
        return 1 + (story.hit() == null || story.hit().mirror() == null ? 0 : rays(story.hit().mirror().story()));
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
