package simpleray.rays;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import simpleray.Sample;
import simpleray.math.Point;
import simpleray.math.Ray;
import simpleray.math.Vector;
import simpleray.rays.RaySegment.Kind;
import simpleray.render.Explainer;
import simpleray.render.PixelStory;
import simpleray.render.RenderRequest;
import simpleray.scene.RayTree;
import simpleray.scene.RayTree.Lamp;
import simpleray.scene.RayTree.Verdict;
import simpleray.scene.Scene;
import simpleray.scene.SceneFile;
import simpleray.text.SceneReader;

/** The segments of a pixel are the rays of its story, bit for bit and in the order of the recursion. */
class RaySegmentTest {
    private static final String SCENE = """
        2
        0  0 0 -5  1   0.1 0.1 0.1  0.5 0.5 0.5  0.5 0.5 0.5  10
        1  0 1 0  -1   0.1 0.1 0.1  0.5 0.5 0.5  0 0 0  1
        0.1 0.1 0.1
        %s
        """;

    private static Scene scene(String lights) throws IOException {
        Scene scene = new Scene();
        scene.read(new SceneReader(new ByteArrayInputStream(String.format(SCENE, lights).getBytes(StandardCharsets.UTF_8))));
        return scene;
    }

    private static List<RaySegment> segments(Scene scene, int x, int y) {
        return RaySegment.of(new RenderRequest().renderer(scene).explainer().story(x, y), scene);
    }

    private static List<Kind> kinds(List<RaySegment> segments) {
        return segments.stream().map(RaySegment::kind).toList();
    }

    @Test
    void aRayThatHitsNothingIsEndless() throws IOException {
        List<RaySegment> segments = segments(scene("0"), 100, 0);

        assertThat(segments).hasSize(1);
        assertThat(segments.get(0).kind()).isEqualTo(Kind.PRIMARY);
        assertThat(segments.get(0).endless()).isTrue();
        Ray ray = segments.get(0).ray().ray();
        assertThat(segments.get(0).from().equals(ray.origin)).isTrue();
        assertThat(segments.get(0).to().equals(ray.getPointAt(0.75 * 2))).as("as far as the eye is from the origin").isTrue();
    }

    @Test
    void shadowRaysStandBeforeMirrorRaysAndVectorsBeforeThem() throws IOException {
        List<RaySegment> segments = segments(scene("1\n0  1 1 1  0 9 3"), 100, 100);

        assertThat(kinds(segments)).startsWith(Kind.PRIMARY, Kind.NORMAL, Kind.HALFWAY, Kind.ARRIVING, Kind.MIRROR);
        assertThat(segments.get(3).to().x).isEqualTo(0, within(1e-9));
        assertThat(segments.get(3).to().y).isEqualTo(9, within(1e-9));
        assertThat(segments.get(3).lamp().light().number()).isEqualTo(1);
        assertThat(segments.get(4).from().equals(segments.get(0).to())).as("the mirror ray starts at the hit").isTrue();
    }

    @Test
    void aStoppedShadowRayEndsAtWhatStopsIt() throws IOException {
        Scene scene = scene("1\n0  1 1 1  0 9 -9");
        RaySegment stopped = segments(scene, 100, 117).stream().filter(s -> s.kind() == Kind.STOPPED).findFirst().orElseThrow();

        double x = stopped.to().x;
        double y = stopped.to().y;
        double z = stopped.to().z + 5;
        assertThat(Math.sqrt(x * x + y * y + z * z)).as("on the ball").isEqualTo(1, within(1e-9));
    }

    @Test
    void theWayToADirectionalLightIsEndless() throws IOException {
        RaySegment arriving = segments(scene("1\n1  1 1 1  0 -1 0"), 100, 199).stream().filter(s -> s.kind() == Kind.ARRIVING).findFirst()
            .orElseThrow();

        assertThat(arriving.endless()).isTrue();
        assertThat(arriving.to().y).isGreaterThan(arriving.from().y);
    }

    @Test
    void ofALightThatIsFarAwayOnlyTheWayThereIsFramed() throws IOException {
        List<Point> near = RaySegment.framed(segments(scene("1\n0  1 1 1  0 3 0"), 100, 90));
        List<RaySegment> all = segments(scene("1\n0  1 1 1  0 300 0"), 100, 90);
        List<Point> far = RaySegment.framed(all);
        Point hit = all.get(0).to();
        double length = Vector.subtract(hit, all.get(0).from()).norm();
        Vector way = Vector.subtract(new Point(0, 300, 0), hit);
        Point arrow = Point.add(hit, Vector.scale(way, 0.75 * length / way.norm()));

        assertThat(near).anySatisfy(point -> assertThat(point.y).isEqualTo(3, within(1e-9)));
        assertThat(far).contains(all.get(0).from(), hit).allSatisfy(point -> assertThat(point.y).isLessThan(length));
        assertThat(far).anySatisfy(point -> assertThat(Vector.subtract(point, arrow).norm()).isLessThan(1e-9));
    }

    @ParameterizedTest
    @ValueSource(strings = {"thesis", "glass", "mirror-still-life", "billiards", "mesh", "light-ring"})
    void theyAreTheRaysOfTheStoryBitForBit(String name) throws IOException {
        Scene scene = SceneFile.read(Path.of(System.getProperty("simpleray.scenes"), name + ".scene")).scene();
        Explainer explainer = new RenderRequest().renderer(scene).explainer();
        Random random = new Random(7);
        for (int k = 0; k < Sample.size(1700, 40); k++) {
            PixelStory story = explainer.story(random.nextInt(explainer.width()), random.nextInt(explainer.height()));
            List<double[]> told = new ArrayList<>();
            tell(story.samples().get(story.samples().size() / 2).tree(), scene, told);
            List<RaySegment> drawn = RaySegment.of(story, scene).stream().filter(segment -> !segment.kind().isVector()).toList();
            assertThat(drawn).hasSameSizeAs(told);
            for (int i = 0; i < drawn.size(); i++) {
                Point from = drawn.get(i).from();
                Point to = drawn.get(i).to();
                assertThat(new double[] {from.x, from.y, from.z}).isEqualTo(new double[] {told.get(i)[0], told.get(i)[1], told.get(i)[2]});
                if (!drawn.get(i).endless() && drawn.get(i).kind() != Kind.STOPPED) {
                    assertThat(new double[] {to.x, to.y, to.z}).isEqualTo(new double[] {told.get(i)[3], told.get(i)[4], told.get(i)[5]});
                }
            }
        }
    }

    private static void tell(RayTree tree, Scene scene, List<double[]> told) {
        RayTree.Hit hit = tree.hit();
        Point end = hit == null ? new Point() : hit.point();
        told.add(new double[] {tree.ray().origin.x, tree.ray().origin.y, tree.ray().origin.z, end.x, end.y, end.z});
        if (hit == null) {
            return;
        }
        for (RayTree.Contribution light : hit.lamps()) {
            if (light instanceof Lamp lamp && lamp.verdict() != Verdict.TURNED_AWAY && lamp.verdict() != Verdict.NO_SHADOWS) {
                told.add(new double[] {end.x, end.y, end.z, end.x + lamp.towards().x * lamp.distance(),
                    end.y + lamp.towards().y * lamp.distance(), end.z + lamp.towards().z * lamp.distance()});
            }
        }
        if (hit.mirror() != null) {
            tell(hit.mirror().tree(), scene, told);
        }
        if (hit.refracted() != null) {
            tell(hit.refracted().tree(), scene, told);
        }
    }
}
