package simpleray.scene;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import simpleray.scene.PerspectiveCamera.Pose;
import simpleray.scene.SceneSettings.Window;
import simpleray.text.SceneFormatException;
import simpleray.text.SourceSpan;

/** A camera put into the text of a scene. */
class ViewLinesTest {
    private static final Path ROOM = Path.of("room.scene");
    private static final Pose POSE = new Pose(1, 2.5, 3, 0, 0, -1, 40);
    private static final String LINE = "camera 1 2.5 3 0 0 -1 40";
    private static final String SCENE = "0 # objects\n0.1 0.1 0.1 # ambient\n0";

    @Test
    void aCameraIsALineOfNumbersThatReadBackAsTheSame() {
        assertThat(ViewLines.of(view(POSE))).isEqualTo(LINE + "\n");
    }

    @Test
    void aWindowAndACentreOfProjectionAreTwoLines() {
        assertThat(ViewLines.of(simple(3.0, new Window(-1, 1, -2, 2)))).isEqualTo("window -1 1 -2 2\ncop 3\n");
        assertThat(ViewLines.of(new SceneSettings())).isEmpty();
    }

    @Test
    void aParallelCameraAndUpTakeThePlaceOfACameraAndStayThemselves() throws IOException {
        SceneSettings view = SceneSettings.of("parallel 1 2 3 4 5 6 7\nup 0 0 1\n", "a");

        assertThat(ViewLines.of(view)).isEqualTo("parallel 1 2 3 4 5 6 7\nup 0 0 1\n");
        assertThat(put(SCENE + "\ncamera 0 0 1 0 0 0 40 # far\n", view))
            .isEqualTo(SCENE + "\nparallel 1 2 3 4 5 6 7 # far\nup 0 0 1\n");
        assertThat(put(SCENE + "\nup 0 0 2\nparallel 1 2 3 4 5 6 8 # near\n", view))
            .isEqualTo(SCENE + "\nup 0 0 1\nparallel 1 2 3 4 5 6 7 # near\n");
        assertThat(put(SCENE + "\nup 0 0 2\nparallel 1 2 3 4 5 6 8\n# near\n")).isEqualTo(SCENE + '\n' + LINE + "\n# near\n");
    }

    @Test
    void itComesDirectlyBehindTheLastLightOrSetting() throws IOException {
        assertThat(put(SCENE + " # no lights\n\n# the end\n")).isEqualTo(SCENE + " # no lights\n" + LINE + "\n\n# the end\n");
        assertThat(put(SCENE + "\ndepth 3 # deep\n# the end")).isEqualTo(SCENE + "\ndepth 3 # deep\n" + LINE + "\n# the end");
    }

    @Test
    void itGetsALineOfItsOwnWhereTheFileEndsWithoutALineBreak() throws IOException {
        assertThat(put(SCENE)).isEqualTo(SCENE + '\n' + LINE);
        assertThat(put(SCENE + " # no lights")).isEqualTo(SCENE + " # no lights\n" + LINE);
        assertThat(put("0 0 0 0 0")).isEqualTo("0 0 0 0 0\n" + LINE);
    }

    @ParameterizedTest
    @CsvSource({"'\r\n'", "'\r'", "'\n'"})
    void lineEndsAreTheFilesOwn(String end) throws IOException {
        String scene = SCENE.replace("\n", end);
        assertThat(put(scene + end + "# end" + end)).isEqualTo(scene + end + LINE + end + "# end" + end);
        assertThat(put(scene)).isEqualTo(scene + end + LINE);
    }

    @Test
    void ofACameraThatIsThereOnlyTheNumbersChangeAndOfThoseOnlyWhatIsDifferent() throws IOException {
        String before = "\uFEFF" + SCENE + "\ndepth 2\n\tcamera  1 2.50 +9\t# eye\n\n  0 0.5 # look at; Größe\n"
            + "heading 5\n -1.00   4e1# fov\nsamples 2\n";
        assertThat(put(before)).isEqualTo(before.replace("+9", "3").replace("0.5", "0"));
    }

    @Test
    void aCameraTakesThePlaceOfAWindow() throws IOException {
        assertThat(put(SCENE + "\nwindow  -1 1  -1 1  # narrow\nsamples 2\n"))
            .isEqualTo(SCENE + "\n" + LINE + "  # narrow\nsamples 2\n");
    }

    @Test
    void ofWindowAndCopTheSecondGoesAndItsCommentStays() throws IOException {
        assertThat(put(SCENE + "\ncop 3 # near\n\n  window -1 1\n   -1 1\nsamples 2\n"))
            .isEqualTo(SCENE + "\n" + LINE + " # near\n\nsamples 2\n");
        assertThat(put(SCENE + "\nwindow -1 1 -1 1\ncop 3 # near\n")).isEqualTo(SCENE + "\n" + LINE + "\n # near\n");
        assertThat(put(SCENE + "\nwindow -1 1 -1 1\ncop 3")).isEqualTo(SCENE + "\n" + LINE + "\n");
    }

    @Test
    void aWindowTakesThePlaceOfACamera() throws IOException {
        SceneSettings simple = simple(3.0, new Window(-1, 1, -2, 2));
        assertThat(put(SCENE + "\ncamera 0 0 1 0 0 0 50 # mine\nsamples 2\n", simple))
            .isEqualTo(SCENE + "\nwindow -1 1 -2 2 # mine\nsamples 2\ncop 3\n");
        assertThat(put(SCENE + "\ncop 5\n", simple)).isEqualTo(SCENE + "\ncop 3\nwindow -1 1 -2 2\n");
    }

    @Test
    void aHeadingBeforeTheLastLightIsNoCamera() throws IOException {
        String headed = "camera 1 2 3 is the best\n" + SCENE + "\n";
        assertThat(put(headed)).isEqualTo(headed + LINE + "\n");
    }

    @Test
    void bytesThatAreNoUtf8Stay() throws IOException {
        byte[] before = (SCENE + "\n# caf\u00e9\n").getBytes(StandardCharsets.ISO_8859_1);
        byte[] after = ViewLines.put(before, ROOM, view(POSE), Reach.FOLDER);
        assertThat(new String(after, StandardCharsets.ISO_8859_1)).isEqualTo(SCENE + "\n" + LINE + "\n# caf\u00e9\n");
    }

    @Test
    void whatIsWrittenReadsBackAsTheVerySameDoubles() throws IOException {
        Random random = new Random(5);
        String text = SCENE + "\n# end\n";
        for (int i = 0; i < 300; i++) {
            Pose pose = new Pose(any(random), any(random), any(random), any(random), any(random), any(random), 179 * random.nextDouble());
            text = put(text, view(pose));
            Scene scene = new Scene();
            scene.read(SourceSpan.reader(text.getBytes(StandardCharsets.UTF_8), ROOM));
            assertThat(scene.settings.camera).isEqualTo(pose);
            assertThat(text).startsWith(SCENE + "\ncamera ").endsWith("\n# end\n");
        }
    }

    @Test
    void everySampleSceneKeepsAllButItsCamera(@TempDir Path folder) throws IOException {
        Path scenes = Path.of(System.getProperty("simpleray.scenes"));
        try (var files = Files.list(scenes)) {
            for (Path path : files.filter(p -> p.toString().endsWith(".scene")).toList()) {
                byte[] before = Files.readAllBytes(path);
                byte[] after = ViewLines.put(before, path, view(POSE), Reach.FOLDER);
                Scene old = read(before, path);
                Scene changed = read(after, path);
                assertThat(changed.settings.camera).as(path.toString()).isEqualTo(POSE);
                changed.settings = old.settings;
                assertThat(SceneBits.of(changed)).as(path.toString()).isEqualTo(SceneBits.of(old));
                String comments = comments(after);
                assertThat(comments).as(path.toString()).isEqualTo(comments(before));
            }
        }
    }

    @Test
    void whatIsNoSceneIsRefused() {
        assertThatThrownBy(() -> put("oops")).isInstanceOf(SceneFormatException.class)
            .hasMessage("room.scene:1:5: error: expected the number of objects, found the end of the file (1 line was skipped as a heading)\noops\n    ^");
    }

    private static Scene read(byte[] text, Path path) throws IOException {
        Scene scene = new Scene();
        scene.read(SourceSpan.reader(text, path));
        return scene;
    }

    private static String comments(byte[] text) {
        StringBuilder all = new StringBuilder();
        new String(text, StandardCharsets.ISO_8859_1).lines().filter(line -> line.contains("#"))
            .forEach(line -> all.append(line.substring(line.indexOf('#'))).append('\n'));
        return all.toString();
    }

    private static double any(Random random) {
        return (random.nextDouble() - 0.5) * Math.pow(10, random.nextInt(20) - 8);
    }

    private static String put(String text) throws IOException {
        return put(text, view(POSE));
    }

    private static String put(String text, SceneSettings view) throws IOException {
        return new String(ViewLines.put(text.getBytes(StandardCharsets.UTF_8), ROOM, view, Reach.FOLDER), StandardCharsets.UTF_8);
    }

    private static SceneSettings view(Pose pose) {
        SceneSettings view = new SceneSettings();
        view.camera = pose;
        return view;
    }

    private static SceneSettings simple(Double cop, Window window) {
        SceneSettings view = new SceneSettings();
        view.cop = cop;
        view.window = window;
        return view;
    }

    private static String putKey(String text, int frame) throws IOException {
        byte[] put = ViewLines.putKey(text.getBytes(StandardCharsets.UTF_8), ROOM, frame, POSE, Reach.FOLDER);
        return new String(put, StandardCharsets.UTF_8);
    }

    @Test
    void aKeyOfTheCameraStandsBehindTheOneBeforeIt() throws IOException {
        String head = SCENE + "\nframes 20 25\nkey 0 camera 0 0 1  0 0 0  50 # the first\n";
        String tail = "key 9 camera 0 0 2\n  0 0 0  50\ndepth 3\n";
        String key = "key 4 " + LINE + '\n';

        assertThat(putKey(head + tail, 4)).isEqualTo(head + key + tail);
        assertThat(putKey(head + tail, 12)).isEqualTo(head + tail.replace("depth", "key 12 " + LINE + "\ndepth"));
        assertThat(putKey(SCENE + "\nframes 20 25\n" + tail, 4)).isEqualTo(SCENE + "\nframes 20 25\n" + key + tail);
        assertThat(putKey(SCENE + "\nframes 20 25", 4)).isEqualTo(SCENE + "\nframes 20 25\nkey 4 " + LINE);
    }

    @Test
    void ofAKeyThatIsThereOnlyTheNumbersChange() throws IOException {
        String film = SCENE + "\r\nframes 20 25\r\nkey 4 light 1 0 0 0\r\nkey  4 camera 1 2.5 3.00  0 0 0  50 # c\r\n";
        film = film.replace("0 # objects", "0").replace("\n0\r", "\n1 0 1 1 1 2 2 2\r");

        assertThat(putKey(film, 4)).isEqualTo(film.replace("0 0 0  50 #", "0 0 -1  40 #"));
    }

    @Test
    void aCameraThatCanHaveNoKeysIsReplaced() throws IOException {
        assertThat(putKey(SCENE + "\nwindow -1 1 -1 1\ncop 3\nframes 20 25\n", 4))
            .isEqualTo(SCENE + '\n' + LINE + "\nframes 20 25\nkey 4 " + LINE + '\n');
    }
}
