package simpleray.render;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static simpleray.text.SceneText.reader;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.CancellationException;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;
import simpleray.Project;
import simpleray.RandomScenes;
import simpleray.image.Picture;
import simpleray.math.Colour;
import simpleray.rays.StoryText;
import simpleray.scene.RayTree;
import simpleray.scene.Scene;
import simpleray.scene.SceneFile;
import simpleray.scene.SceneSettings;
import simpleray.scene.SimpleCamera;

/** Stories of pixels: their terms add up to the picture's colours, bit for bit. */
class ExplainerTest {
    private static final long SEED = 20140607;
    private static final int SIDE = 5;
    private static final int DEPTH = 4;

    @TempDir
    Path folder;

    @ParameterizedTest
    @EnumSource
    void theTermsAddUpOnRandomScenesOfAllShapes(Accel accel) {
        RandomScenes scenes = new RandomScenes(SEED + accel.ordinal(), folder);
        StorySums sums = new StorySums();
        for (int i = 0; i < 150; i++) {
            Scene scene = scenes.next(i % 10 == 0 ? 60 : 20);
            check(new Renderer(scene, new SimpleCamera(SIDE, SIDE), new RenderSettings(Stage.FINAL, DEPTH, 1, accel, 1, null)), 1, sums,
                "seed " + (SEED + accel.ordinal()) + ", scene " + i);
        }
        assertThat(sums.hits).isGreaterThan(600);
        assertThat(sums.blocked).isGreaterThan(50);
        assertThat(sums.dimmed).isGreaterThan(20);
        assertThat(sums.areas).isGreaterThan(50);
        assertThat(sums.mirrored).isGreaterThan(100);
        assertThat(sums.refracted).isGreaterThan(50);
    }

    @Test
    void theStoryDoesNotDependOnAcceleration() {
        RandomScenes scenes = new RandomScenes(SEED, folder);
        int blocked = 0;
        SimpleCamera camera = new SimpleCamera(SIDE, SIDE);
        for (int i = 0; i < 60; i++) {
            Scene scene = scenes.next(i % 10 == 0 ? 60 : 20);
            Explainer plain = explainer(scene, Accel.NONE);
            Explainer engine = explainer(scene, Accel.AUTO);
            for (int p = 0; p < SIDE * SIDE; p++) {
                String text = StoryText.of(engine.story(p % SIDE, p / SIDE), scene, camera);
                assertThat(text).isEqualTo(StoryText.of(plain.story(p % SIDE, p / SIDE), scene, camera));
                assertThat(engine.objectAt(p % SIDE, p / SIDE)).isEqualTo(plain.objectAt(p % SIDE, p / SIDE));
                blocked += text.contains(" is hidden by ") ? 1 : 0;
            }
        }
        assertThat(blocked).isGreaterThan(30);
    }

    private static Explainer explainer(Scene scene, Accel accel) {
        return new Renderer(scene, new SimpleCamera(SIDE, SIDE), new RenderSettings(Stage.FINAL, 2, 1, accel, 1, null)).explainer();
    }

    static List<String> sampleScenes() {
        return Project.scenes();
    }

    @ParameterizedTest
    @MethodSource("sampleScenes")
    void theTermsAddUpOnEverySampleScene(String name) throws IOException {
        SceneSettings small = new SceneSettings();
        small.resolution = new SceneSettings.Resolution(24, 18);
        small.samples = 1;
        StorySums sums = new StorySums();

        check(new RenderRequest(small, Stage.FINAL, false, 1).renderer(SceneFile.read(Project.scene(name)).scene()), 3, sums, name);

        assertThat(sums.hits).isGreaterThan(10);
    }

    @ParameterizedTest
    @EnumSource
    void aStoryOfAnyStageHasThePicturesColour(Stage stage) {
        RandomScenes scenes = new RandomScenes(SEED, folder);
        for (int i = 0; i < 30; i++) {
            Renderer renderer = new Renderer(scenes.next(15), new SimpleCamera(SIDE, SIDE), new RenderSettings(stage, DEPTH, 1, 1));
            Picture picture = renderer.render(RenderListener.NONE);
            Explainer explainer = renderer.explainer();
            for (int p = 0; p < SIDE * SIDE; p++) {
                PixelStory story = explainer.story(p % SIDE, p / SIDE);
                String where = "scene " + i + ", pixel " + p;
                StorySums.assertSame(where, story.colour(), pixel(picture, p % SIDE, p / SIDE));
                assertThat(story.stage()).isEqualTo(stage);
                if (!stage.isView()) {
                    StorySums.assertSame(where, story.samples().get(0).tree().colour(), story.colour());
                }
            }
        }
    }

    @ParameterizedTest
    @ValueSource(ints = {2, 3, RenderSettings.ADAPTIVE})
    void aStoryHasEachSampleAndTheirMeanIsThePixel(int samples) {
        RandomScenes scenes = new RandomScenes(SEED, folder);
        int alone = 0;
        int many = 0;
        for (int i = 0; i < 40; i++) {
            Renderer renderer = new Renderer(scenes.next(15), new SimpleCamera(SIDE, SIDE), new RenderSettings(Stage.FINAL, 2, samples, 1));
            Picture picture = renderer.render(RenderListener.NONE);
            Explainer explainer = renderer.explainer();
            for (int p = 0; p < SIDE * SIDE; p++) {
                PixelStory story = explainer.story(p % SIDE, p / SIDE);
                Colour mean = new Colour();
                for (PixelStory.Sample sample : story.samples()) {
                    Colour seen = new Colour(sample.tree().colour());
                    seen.clamp();
                    StorySums.assertSame("a sample", sample.colour(), seen);
                    assertThat(sample.clamped()).isTrue();
                    mean.add(seen);
                }
                if (story.mean()) {
                    mean.scale(1.0 / story.samples().size());
                }
                StorySums.assertSame("the sum", story.colour(), mean);
                StorySums.assertSame("the picture", story.colour(), pixel(picture, p % SIDE, p / SIDE));
                alone += story.samples().size() == 1 ? 1 : 0;
                many += story.samples().size() == (samples == RenderSettings.ADAPTIVE ? 16 : samples * samples) ? 1 : 0;
            }
        }
        assertThat(alone + many).isEqualTo(40 * SIDE * SIDE);
        assertThat(many).isGreaterThan(100);
        assertThat(alone > 100).isEqualTo(samples == RenderSettings.ADAPTIVE);
    }

    @Test
    void theStoryNamesHitAndBlockingObjectsByNumberKindAndLine() throws IOException {
        Scene scene = scene("""
            3
            # the floor
            1  0 1 0 -1      0.5 0.5 0.5  1 1 1  0 0 0  1
            0  0 5 -1  1     1 1 1  1 1 1  0 0 0  1
            2  -9 2 -9  9 2 -9  0 2 9
               1 1 1  1 1 1  0 0 0  1  transmit 0.5 1 0.25 1

            0.2 0.2 0.2
            2
            0  1 1 1  0 9 -1
            1  1 0 0  0 1 0
            """);
        RayTree story = explainer(scene, 3, Stage.FINAL, 10).story(1, 2).samples().get(0).tree();

        assertThat(story.hit().object()).isEqualTo(new RayTree.Thing(1, "plane", 3));
        assertThat(story.hit().ambient()).hasToString(new Colour(0.1, 0.1, 0.1).toString());
        assertThat(story.hit().lamps()).extracting(RayTree.Contribution::light).containsExactly(new RayTree.Thing(1, "point light", 10),
            new RayTree.Thing(2, "directional light", 11));
        assertThat(lamp(story, 0).verdict()).isEqualTo(RayTree.Verdict.BLOCKED);
        assertThat(lamp(story, 1).verdict()).isEqualTo(RayTree.Verdict.TURNED_AWAY);
        assertThat(lamp(story, 0).between()).extracting(RayTree.Between::object)
            .containsExactly(new RayTree.Thing(2, "sphere", 4));
        assertThat(lamp(story, 1).between()).isEmpty();
    }

    private static RayTree.Lamp lamp(RayTree story, int light) {
        return (RayTree.Lamp) story.hit().lamps().get(light);
    }

    @Test
    void theStoryNamesGlassThatDimsALightAndItsTransmission() throws IOException {
        Scene scene = scene("""
            2
            1  0 1 0 -1   0 0 0  1 1 1  0 0 0  1
            2  -9 2 -9  9 2 -9  0 2 9   0 0 0  0 0 0  0 0 0  1  transmit 0.5 1 0.25 1
            0 0 0  1
            0  1 0.5 1  0 9 -1
            """);
        RayTree.Lamp lamp = lamp(explainer(scene, 3, Stage.FINAL, 10).story(1, 2).samples().get(0).tree(), 0);

        assertThat(lamp.verdict()).isEqualTo(RayTree.Verdict.DIMMED);
        assertThat(lamp.arriving()).hasToString(new Colour(0.5, 0.5, 0.25).toString());
        assertThat(lamp.between().get(0).object()).isEqualTo(new RayTree.Thing(2, "triangle", 3));
    }

    @Test
    void theStoryOfARayThatMissesIsTheBackground() throws IOException {
        PixelStory story = explainer(scene("0  1 1 1  0\nbackground 0.25 0.5 1"), 3, Stage.FINAL, 10).story(0, 0);

        assertThat(story.samples().get(0).tree().hit()).isNull();
        assertThat(story.colour()).hasToString(new Colour(0.25, 0.5, 1).toString());
        assertThat(explainer(scene("0  1 1 1  0\nbackground 0.25 0.5 1"), 3, Stage.DIFFUSE, 10).story(0, 0).colour().isBlack()).isTrue();
    }

    @Test
    void theObjectAtAPixelIsTheOneAtItsCentre() throws IOException {
        Explainer explainer = explainer(scene("1  0 0 0 0 0.5  1 1 1  0 0 0  0 0 0  1   1 1 1  0"), 3, Stage.FINAL, 10);

        assertThat(explainer.objectAt(1, 1)).isEqualTo(new RayTree.Thing(1, "sphere", 1));
        assertThat(explainer.objectAt(0, 0)).isNull();
    }

    @Test
    void aPixelOutsideThePictureHasNoStory() throws IOException {
        Explainer explainer = explainer(scene("0  1 1 1  0"), 3, Stage.FINAL, 10);

        assertThat(List.of(explainer.width(), explainer.height())).containsExactly(3, 3);
        assertThatThrownBy(() -> explainer.story(3, 0)).isInstanceOf(IndexOutOfBoundsException.class);
        assertThatThrownBy(() -> explainer.story(0, -1)).isInstanceOf(IndexOutOfBoundsException.class);
    }

    @Test
    void anInterruptCancelsAStory() throws IOException {
        Explainer explainer = explainer(scene("0  1 1 1  0"), 3, Stage.FINAL, 10);
        Thread.currentThread().interrupt();

        assertThatThrownBy(() -> explainer.story(0, 0)).isInstanceOf(CancellationException.class);
        assertThat(Thread.interrupted()).isTrue();
    }

    private static void check(Renderer renderer, int step, StorySums sums, String where) {
        Picture picture = renderer.render(RenderListener.NONE);
        Explainer explainer = renderer.explainer();
        for (int y = 0; y < picture.height(); y += step) {
            for (int x = 0; x < picture.width(); x += step) {
                PixelStory story = explainer.story(x, y, (x + y) % 2 == 0);
                String pixel = where + ", pixel " + x + ',' + y;
                sums.check(story.samples().get(0).tree(), pixel);
                assertThat(story.samples()).hasSize(1);
                StorySums.assertSame(pixel, story.colour(), pixel(picture, x, y));
                StorySums.assertSame(pixel, story.samples().get(0).tree().colour(), story.colour());
            }
        }
    }

    private static Colour pixel(Picture picture, int x, int y) {
        double[] row = picture.row(y);
        int at = picture.channels() * x;
        return new Colour(row[at], row[at + 1], row[at + 2]);
    }

    private static Explainer explainer(Scene scene, int side, Stage stage, int depth) {
        return new Renderer(scene, new SimpleCamera(side, side), new RenderSettings(stage, depth, 1, 1)).explainer();
    }

    private static Scene scene(String text) throws IOException {
        Scene scene = new Scene();
        scene.read(reader(text));
        return scene;
    }
}
