package simpleray.rays;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.EnumSet;
import java.util.List;
import java.util.concurrent.CancellationException;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import simpleray.image.Picture;
import simpleray.math.Point;
import simpleray.rays.RaySegment.Kind;
import simpleray.render.RenderRequest;
import simpleray.render.Stage;
import simpleray.scene.Camera;
import simpleray.scene.PerspectiveCamera.Pose;
import simpleray.scene.Scene;
import simpleray.scene.SceneSettings;
import simpleray.text.SceneReader;

/** A ball in a room of six walls, whose rays are drawn from outside. */
class RayDrawingTest {
    private static final int WIDTH = 400;
    private static final int HEIGHT = 300;
    private static final String SCENE = """
        7
        0  0 0 -5  1   0.1 0.1 0.1  0.5 0.5 0.5  0.5 0.5 0.5  10
        1  0 1 0  -2   0.1 0.1 0.1  0.5 0 0  0 0 0  1
        1  0 1 0   4   0.1 0.1 0.1  0.5 0.5 0.5  0 0 0  1
        1  1 0 0  -4   0.1 0.1 0.1  0.5 0.5 0.5  0 0 0  1
        1  1 0 0   4   0.1 0.1 0.1  0.5 0.5 0.5  0 0 0  1
        1  0 0 1  -9   0.1 0.1 0.1  0.5 0.5 0.5  0 0 0  1
        1  0 0 1   3   0.1 0.1 0.1  0.5 0.5 0.5  0 0 0  1
        0.1 0.1 0.1
        1
        0  1 1 1  3 3 2
        """;
    private static final String LIT = """
        1
        0  0 0 -5  1   0.1 0.1 0.1  0.5 0.5 0.5  0.5 0.5 0.5  10
        0.1 0.1 0.1
        1
        0  1 1 1  0 %s 2
        """;
    private Scene scene;
    private List<RaySegment> segments;

    @BeforeEach
    void tell() throws IOException {
        tell(SCENE, 100, 100);
    }

    private void tell(String text, int x, int y) throws IOException {
        scene = new Scene();
        scene.read(new SceneReader(new ByteArrayInputStream(text.getBytes(StandardCharsets.UTF_8))));
        segments = RaySegment.of(new RenderRequest().renderer(scene).explainer().story(x, y), scene);
    }

    private OutsideView view(Point eye) {
        return OutsideView.of(scene, segments.get(0).from(), eye == null ? home(WIDTH, HEIGHT) : pose(eye),
            WIDTH, HEIGHT, Stage.LIGHTING, 1);
    }

    private Pose pose(Point eye) {
        return OutsideView.pose(segments, scene.settings.newCamera(), eye);
    }

    private Pose home(int width, int height) {
        return OutsideView.pose(segments, scene.settings.newCamera(), width, height);
    }

    private RayDrawing drawing(OutsideView view) {
        return new RayDrawing(view, scene.settings.newCamera(), segments, RayDrawing.RAYS);
    }

    private OutsideView view(OutsideScene outside, double x, double y, double z, double density) {
        return outside.view(new Point(0, 0, 2), new Pose(x, y, z, 0.1, 0.2, 0.3, 40), 40, 30, density, Stage.LIGHTING, 1);
    }

    @Test
    void wallsBeforeTheRoomAreLeftOut() {
        OutsideScene outside = new OutsideScene(scene);
        view(outside, 0, 30, 0, 1);
        assertThat(outside.numberObjects()).isEqualTo(6);
        view(outside, 30, 30, 30, 1);
        assertThat(outside.numberObjects()).isEqualTo(4);
        view(outside, 1, 1, 1, 1);
        assertThat(outside.numberObjects()).isEqualTo(7);
    }

    @Test
    void whileTheSameWallsAreLeftOutTheSceneIsCompiledOnce() {
        OutsideScene outside = new OutsideScene(scene);
        view(outside, 0, 30, 0, 1);
        Scene opened = outside.opened();
        view(outside, 1, 40, 1, 1);
        assertThat(outside.opened()).isSameAs(opened);
        view(outside, 30, 30, 1, 1);
        assertThat(outside.opened()).isNotSameAs(opened);
    }

    @Test
    void aViewOfAnyDensityHasTheSameDistances() {
        OutsideScene outside = new OutsideScene(scene);
        OutsideView coarse = view(outside, 5, 30, 2, 0.5);
        OutsideView plain = view(outside, 5, 30, 2, 1);
        OutsideView fine = view(outside, 5, 30, 2, 2);

        assertThat(new int[] {coarse.image.getWidth(), coarse.image.getHeight()}).containsExactly(20, 15);
        assertThat(new int[] {fine.image.getWidth(), fine.image.getHeight()}).containsExactly(80, 60);
        assertThat(plain.distance(20.5, 15.5)).isFinite();
        assertThat(coarse.distance(20.5, 15.5)).isCloseTo(plain.distance(20.5, 15.5), within(1.0));
        assertThat(fine.distance(20.5, 15.5)).isCloseTo(plain.distance(20.5, 15.5), within(1.0));
        assertThat(fine.distance(40, 15.5)).isInfinite();
        assertThat(fine.distance(20.5, -0.1)).isInfinite();
    }

    @ParameterizedTest
    @CsvSource({"3, 2.2", "-3, 2.2", "3, -2.2"})
    void theLegendCoversNoEye(double right, double up) {
        Point eye = segments.get(0).from();
        OutsideView view = new OutsideScene(scene).view(eye, new Pose(eye.x, eye.y, eye.z + 10, eye.x + right, eye.y + up, eye.z, 40),
            WIDTH, HEIGHT, 1, Stage.LIGHTING, 1);
        BufferedImage image = new BufferedImage(WIDTH, HEIGHT, BufferedImage.TYPE_INT_RGB);
        drawing(view).paint(image.createGraphics(), 100, 100, 0, null);
        double[] at = drawing(view).ends(eye, segments.get(0).to());

        assertThat(image.getRGB((int) at[0], (int) at[1]) & 0xff).as("a white dot").isGreaterThan(200);
    }

    @Test
    void anInterruptEndsAView() {
        OutsideScene outside = new OutsideScene(scene);
        Thread.currentThread().interrupt();
        assertThatThrownBy(() -> view(outside, 0, 30, 0, 1)).isInstanceOf(CancellationException.class);
        assertThat(Thread.interrupted()).isTrue();
    }

    @Test
    void theEyeOutsideLooksAtTheMiddleOfTheRays() {
        Pose pose = pose(new Point(20, 5, 9));

        assertThat(new double[] {pose.ex(), pose.ey(), pose.ez()}).containsExactly(20, 5, 9);
        assertThatThrownBy(() -> pose(new Point(pose.lx(), pose.ly(), pose.lz())))
            .isInstanceOf(IllegalArgumentException.class).hasMessage("an eye other than the middle of the rays");
    }

    @ParameterizedTest
    @CsvSource({"400, 300", "90, 600", "900, 60"})
    void withoutAnEyeAllRaysAndTheImagePlaneAreInAPictureOfAnyShapeAndFillIt(int width, int height) {
        OutsideView view = OutsideView.of(scene, segments.get(0).from(), home(width, height), width, height, Stage.LIGHTING, 1);
        Camera inside = scene.settings.newCamera();
        List<Point> ends = new ArrayList<>(List.of(inside.eye(), onPlane(inside, 0, 0), onPlane(inside, inside.width(), inside.height())));
        segments.stream().filter(segment -> !segment.kind().isVector()).forEach(segment -> ends.add(segment.to()));
        double most = 0;
        for (Point end : ends) {
            double[] at = drawing(view).ends(end, end);
            most = Math.max(most, Math.max(Math.abs(2 * at[0] / width - 1), Math.abs(2 * at[1] / height - 1)));
        }
        assertThat(most).isBetween(0.85, 0.88 + 1e-9);
    }

    private Point onPlane(Camera inside, double x, double y) {
        return RayDrawing.onPlane(inside, x, y, RayDrawing.planeDistance(segments.get(0)));
    }

    @ParameterizedTest
    @ValueSource(doubles = {100, 1e6})
    void aLightFarAwayIsAnArrowTowardsIt(double height) throws IOException {
        tell(LIT.formatted(height), 100, 90);
        RayDrawing drawing = drawing(view(null));
        RaySegment arriving = segments.stream().filter(segment -> segment.kind() == Kind.ARRIVING).findFirst().orElseThrow();
        double[] whole = drawing.ends(arriving.from(), arriving.to());
        double[] arrow = drawing.inside(whole);

        assertThat(whole[4]).isNegative();
        assertThat(arrow[4]).isCloseTo(0, within(1e-6));
        assertThat(arrow[1] - arrow[4]).isGreaterThan(HEIGHT / 4.0);
        double[] eye = drawing.ends(new Point(0, 0, 0), arriving.from());
        assertThat(Math.hypot(eye[3] - eye[0], eye[4] - eye[1])).isGreaterThan(HEIGHT / 4.0);
    }

    @Test
    void aHitAtTheHorizonLeavesTheOthersTheirPlace() throws IOException {
        tell("""
            2
            0  0 0 -5  1       0.1 0.1 0.1  0.5 0.5 0.5  0.5 0.5 0.5  10
            0  0 1e7 -5  9e6   0.1 0.1 0.1  0.5 0.5 0.5  0 0 0  10
            0.1 0.1 0.1
            0
            """, 100, 90);
        RaySegment mirror = segments.stream().filter(segment -> segment.kind() == Kind.MIRROR).findFirst().orElseThrow();
        assertThat(mirror.endless()).isFalse();
        assertThat(mirror.to().y).isGreaterThan(1e6);
        RayDrawing drawing = drawing(view(null));
        double[] eye = drawing.ends(segments.get(0).from(), segments.get(0).to());

        assertThat(Math.hypot(eye[3] - eye[0], eye[4] - eye[1])).isGreaterThan(HEIGHT / 4.0);
    }

    @Test
    void ofALineThatLeavesTheViewTheRestIsCutWhereItDoes() {
        RayDrawing drawing = drawing(view(null));

        assertThat(drawing.inside(new double[] {200, 150, 1, 600, 150, 3})).containsExactly(200, 150, 1, 400, 150, 1.5);
        assertThat(drawing.inside(new double[] {-100, 150, 1, 100, 50, 1})).containsExactly(0, 100, 1, 100, 50, 1);
        assertThat(drawing.inside(new double[] {10, 20, 1, 30, 40, 2})).containsExactly(10, 20, 1, 30, 40, 2);
        assertThat(drawing.inside(new double[] {-1, 20, 1, -1, 40, 2})).isNull();
        assertThat(drawing.inside(new double[] {-100, 20, 1, -1, 40, 2})).isNull();
        assertThat(drawing.inside(null)).isNull();
    }

    @Test
    void theMiddleOfTheViewIsWhereTheEyeLooks() {
        OutsideView view = view(new Point(0, 20, 0));
        Pose pose = pose(new Point(0, 20, 0));
        Point middle = new Point(pose.lx(), pose.ly(), pose.lz());
        double[] ends = drawing(view).ends(middle, new Point(pose.lx(), pose.ly(), pose.lz() + 1e-9));

        assertThat(ends[0]).isCloseTo(WIDTH / 2.0, within(1e-3));
        assertThat(ends[1]).isCloseTo(HEIGHT / 2.0, within(1e-3));
    }

    @Test
    void whatIsBehindTheEyeIsNotDrawnAndALineFromThereIsCut() {
        RayDrawing drawing = drawing(view(new Point(0, 20, 0)));

        assertThat(drawing.ends(new Point(0, 30, 0), new Point(1, 25, 0))).isNull();
        double[] cut = drawing.ends(new Point(0, 30, 0), new Point(0, 0, 0));
        assertThat(cut[2]).isBetween(0.0, 1e-3);
        assertThat(cut[5]).isGreaterThan(10);
    }

    @Test
    void aLineBehindTheBallIsHiddenAndOneBeforeItIsNot() {
        OutsideView view = view(new Point(0, 20, -5));
        RayDrawing drawing = drawing(view);

        double[] behind = drawing.ends(new Point(-0.1, -1.5, -5), new Point(0.1, -1.5, -5));
        double[] before = drawing.ends(new Point(-0.1, 1.5, -5), new Point(0.1, 1.5, -5));
        assertThat(drawing.isHidden(behind, 0.5)).isTrue();
        assertThat(drawing.isHidden(before, 0.5)).isFalse();
    }

    @Test
    void theRayUnderTheMouseIsFound() {
        RayDrawing drawing = drawing(view(null));
        double[] ends = drawing.ends(segments.get(0).from(), segments.get(0).to());

        double x = ends[0] + 0.2 * (ends[3] - ends[0]);
        double y = ends[1] + 0.2 * (ends[4] - ends[1]);
        assertThat(drawing.at(x, y, 3).kind()).isEqualTo(Kind.PRIMARY);
        assertThat(drawing.at(x, y + 120, 3)).isNull();
    }

    @Test
    void raysAreDrawnInTheirColoursOverTheView() {
        OutsideView view = view(null);
        Picture picture = drawing(view).picture(100, 100);
        BufferedImage with = picture.toBufferedImage();

        assertThat(count(view.image, 0xffffffff)).isZero();
        assertThat(count(with, 0xffffffff)).as("primary ray and legend").isGreaterThan(50);
        assertThat(count(with, 0xffffe14d)).as("shadow ray").isPositive();
    }

    @Test
    void vectorsAreDrawnIfTheyAreAskedFor() {
        OutsideView view = view(null);
        RayDrawing all = new RayDrawing(view, scene.settings.newCamera(), segments, EnumSet.allOf(Kind.class));

        assertThat(all.segments()).anyMatch(segment -> segment.kind() == Kind.NORMAL);
        assertThat(drawing(view).segments()).noneMatch(segment -> segment.kind().isVector());
        assertThat(count(all.picture(100, 100).toBufferedImage(), 0xff7be07b)).isPositive();
    }

    /** The ray of a pixel at the upper left starts at (-1.25, 1.25, 2), in a frame that is 4 wide and high. */
    @Test
    void ofParallelRaysEachStartsAtAPlaceOfItsOwn() throws IOException {
        scene.settings = SceneSettings.of("parallel 0 0 2 0 0 0 4\nresolution 8 8", "a");
        segments = RaySegment.of(new RenderRequest().renderer(scene).explainer().story(1, 1), scene);
        OutsideView view = view(new Point(9, 12, 9));
        RayDrawing drawing = drawing(view);
        BufferedImage with = drawing.picture(1, 1).toBufferedImage();

        assertThat(segments.get(0).from()).hasToString("[-1.25,1.25,2.0]");
        assertThat(isChanged(drawing, with, view.image, -1.25, 1.25)).isTrue();
        for (int side = -1; side <= 1; side += 2) {
            assertThat(isChanged(drawing, with, view.image, 2 * side, 0)).as("an edge, dashed if it is hidden").isTrue();
            assertThat(isChanged(drawing, with, view.image, 0, 2 * side)).as("an edge, dashed if it is hidden").isTrue();
        }
    }

    /** {@return whether something is drawn near a point of the plane z = 2} */
    private static boolean isChanged(RayDrawing drawing, BufferedImage with, BufferedImage without, double atX, double atY) {
        double[] ends = drawing.ends(new Point(atX, atY, 2), new Point(atX, atY, 2 + 1e-9));
        for (int y = (int) ends[1] - 5; y <= (int) ends[1] + 5; y++) {
            for (int x = (int) ends[0] - 5; x <= (int) ends[0] + 5; x++) {
                if (with.getRGB(x, y) != without.getRGB(x, y)) {
                    return true;
                }
            }
        }
        return false;
    }

    @Test
    void aSelectedRayIsThicker() {
        RayDrawing drawing = drawing(view(null));
        assertThat(white(drawing, segments.get(0))).isGreaterThan(white(drawing, null));
    }

    private static int white(RayDrawing drawing, RaySegment selected) {
        BufferedImage image = new BufferedImage(WIDTH, HEIGHT, BufferedImage.TYPE_INT_RGB);
        drawing.paint(image.createGraphics(), 100, 100, 1, selected);
        return count(image, 0xffffffff);
    }

    private static int count(BufferedImage image, int rgb) {
        int count = 0;
        for (int y = 0; y < image.getHeight(); y++) {
            for (int x = 0; x < image.getWidth(); x++) {
                count += image.getRGB(x, y) == rgb ? 1 : 0;
            }
        }
        return count;
    }
}
