package simpleray.ui.inspect;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static simpleray.text.SceneText.reader;

import java.io.IOException;
import java.util.List;
import org.junit.jupiter.api.Test;
import simpleray.render.RenderSettings;
import simpleray.render.Renderer;
import simpleray.scene.RayTree;
import simpleray.scene.RayTree.Lamp;
import simpleray.scene.Scene;
import simpleray.scene.SimpleCamera;
import simpleray.ui.inspect.StoryMark.Kind;

/** What the picture marks of a story. */
class StoryMarkTest {
    private static final double CLOSE = 1e-6;

    /** The ray from (0,0,2) hits a mirror at (0,0,-2), which stands at 45 degrees and shows the wall at (-1,0,-2); a ball stops the light. */
    @Test
    void aRaysMarksAreItsHitTheBlockersAndWhatTheMirrorShows() throws IOException {
        Scene scene = new Scene();
        scene.read(reader("""
            3
            1 -1 0 1 -2   0 0 0  1 1 1  0.5 0.5 0.5  2
            1 1 0 0 -1    0 0 0  1 1 1  0 0 0  1
            0 -0.25 0.5 -1.25 0.25  0 0 0  1 1 1  0 0 0  1
            0 0 0
            2
            0  1 1 1  -0.5 1 -0.5
            0  1 1 1  0 0.5 0
            """));
        SimpleCamera camera = new SimpleCamera(200, 200);
        RayTree ray = new Renderer(scene, camera, new RenderSettings()).explainer().story(100, 100).samples().get(0).tree();
        Lamp hidden = (Lamp) ray.hit().lamps().get(0);
        Lamp seen = (Lamp) ray.hit().lamps().get(1);

        List<StoryMark> all = StoryMark.of(ray, null, scene, camera);
        assertThat(all).extracting(StoryMark::kind).containsExactly(Kind.POINT, Kind.BLOCKER, Kind.NEXT);
        assertThat(all.get(0).x()).isCloseTo(100.5, within(CLOSE));
        assertThat(all.get(0).y()).isCloseTo(100.5, within(CLOSE));
        assertThat(all.get(1).y()).isLessThan(100);
        assertThat(all.get(2).x()).as("(-1,0,-2) is seen at -0.5 of the window's -2 to 2").isCloseTo(75, within(0.6));
        assertThat(StoryMark.of(ray, hidden, scene, camera)).extracting(StoryMark::kind).containsExactly(Kind.POINT, Kind.BLOCKER);
        assertThat(StoryMark.of(ray, seen, scene, camera)).extracting(StoryMark::kind).containsExactly(Kind.POINT);
    }

    @Test
    void whatIsNotInThePictureHasNoMark() throws IOException {
        Scene scene = new Scene();
        scene.read(reader("1\n1 0 0 1 -2   0 0 0  1 1 1  0.5 0.5 0.5  2\n0 0 0\n0\n"));
        SimpleCamera camera = new SimpleCamera(3, 3);
        RayTree ray = new Renderer(scene, camera, new RenderSettings()).explainer().story(1, 1).samples().get(0).tree();

        assertThat(StoryMark.of(ray, null, scene, camera)).extracting(StoryMark::kind).containsExactly(Kind.POINT);
        assertThat(StoryMark.of(ray.hit().mirror().tree(), null, scene, camera)).isEmpty();
    }
}
