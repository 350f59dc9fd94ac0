package simpleray.cli;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import simpleray.Rendered;
import simpleray.image.Picture;
import simpleray.image.Sheet;
import simpleray.image.png.PngWriter;
import simpleray.render.RenderListener;
import simpleray.render.RenderRequest;
import simpleray.render.Stage;
import simpleray.scene.Scene;
import simpleray.scene.SceneFile;
import simpleray.scene.SceneSettings;
import simpleray.scene.SceneSettings.Resolution;

/** {@code simpleray figures}: which sheets it makes, and what it says. */
class FiguresCommandTest {
    /** A shiny ball over a mirroring floor, with two exponents left open. */
    private static final String SCENE = "2\n0  0 0 -1  1.2  0.9 0.3 0.2  0.9 0.3 0.2  0.5 0.5 0.5  %s\n"
        + "1  0 1 0  -1  0.4 0.4 0.4  0.6 0.6 0.6  0.3 0.3 0.3  %s\n0.3 0.3 0.3\n1\n0  0.9 0.9 0.8  -2 3 2\n";
    private static final Resolution SIZE = new Resolution(20, 10);
    private static final String TIME = "\\d+\\.\\d s";

    @TempDir
    Path folder;
    private Path scene;
    private Path sheets;
    private String said;

    @BeforeEach
    void writeTheScene() throws IOException {
        scene = Files.writeString(folder.resolve("ball.scene"), scene("7", "3"));
        sheets = folder.resolve("a").resolve("b");
    }

    @Test
    void raysAreDrawnOnRequest() throws IOException {
        assertThat(figures("--size", "20x10", "--rays")).isZero();

        assertThat(names(sheets)).containsExactly("ball-rays.png", "ball-stages.png", "ball-terms.png");
    }

    @Test
    void theStagesAndTheTermsAreMadeInAFolderThatIsMadeToo() throws IOException {
        assertThat(figures("--size", "20x10")).isZero();

        assertThat(said).matches(sheets.resolve("ball-stages.png") + ": 243x72, " + TIME + "\n"
            + sheets.resolve("ball-terms.png") + ": 248x61, " + TIME + "\n");
        assertThat(names(sheets)).containsExactly("ball-stages.png", "ball-terms.png");
    }

    @Test
    void theStagesAreTheThesissThree() throws IOException {
        assertThat(figures("--size", "20x10", "-q")).isZero();

        assertThat(said).isEmpty();
        Scene read = read(scene("7", "3"));
        assertShows("ball-stages.png", sheet(
            List.of("original", "with lighting", "with shadows and reflections"),
            List.of(render(read, Stage.ORIGINAL), render(read, Stage.LIGHTING), render(read, Stage.FINAL))));
    }

    @Test
    void theTermsAreFollowedByTheLightingThatTheyAddUpTo() throws IOException {
        assertThat(figures("--size", "20x10", "-q")).isZero();

        Scene read = read(scene("7", "3"));
        assertShows("ball-terms.png", sheet(List.of("ambient", "diffuse", "specular", "their sum"),
            List.of(render(read, Stage.AMBIENT), render(read, Stage.DIFFUSE), render(read, Stage.SPECULAR), render(read, Stage.LIGHTING))));
    }

    @Test
    void aSweepGivesEveryMaterialEachShininess() throws IOException {
        assertThat(figures("--size", "20x10", "--sweep", "shininess=0.5,20,3e1")).isZero();

        assertThat(said).matches(".*\n.*\n" + sheets.resolve("ball-shininess.png") + ": \\d+x\\d+, " + TIME + "\n");
        List<Picture> pictures = new ArrayList<>();
        for (String shininess : List.of("0.5", "20", "30")) {
            pictures.add(render(read(scene(shininess, shininess)), Stage.LIGHTING));
        }
        assertShows("ball-shininess.png",
            sheet(List.of("shininess 0.5", "shininess 20", "shininess 3e1"), pictures));
    }

    @Test
    void aSweepReachesTheMaterialsOfMtlFiles() throws IOException {
        Files.writeString(folder.resolve("a.mtl"), "newmtl red\nKs 1 1 1\nNs 2\n");
        Files.writeString(folder.resolve("a.obj"), "mtllib a.mtl\nv -1 -1 0\nv 1 -1 0\nv 1 1 0\nf 1 2 3\nusemtl red\nv -1 1 0\nf 1 3 4\n");
        String text = "1\n4 \"a.obj\" 0 0 0 1  0 0 0 0.5 0.5 0.5 1 1 1 %s mtl\n1 1 1\n1\n0 1 1 1 0 0 2\n";
        scene = Files.writeString(folder.resolve("ball.scene"), String.format(text, 3));
        assertThat(figures("--size", "20x10", "-q", "--sweep", "shininess=5,50")).isZero();

        List<Picture> pictures = new ArrayList<>();
        for (String shininess : List.of("5", "50")) {
            Files.writeString(folder.resolve("a.mtl"), "newmtl red\nKs 1 1 1\nNs " + shininess + "\n");
            pictures.add(render(SceneFile.read(Files.writeString(folder.resolve("other.scene"), String.format(text, shininess))).scene(),
                Stage.LIGHTING));
        }
        assertThat(pictures.get(0)).isNotEqualTo(pictures.get(1));
        assertShows("ball-shininess.png", sheet(List.of("shininess 5", "shininess 50"), pictures));
    }

    @Test
    void theOtherSheetsAreOfTheSceneAsItIs() throws IOException {
        assertThat(figures("--size", "20x10", "-q")).isZero();
        byte[] stages = Files.readAllBytes(sheets.resolve("ball-stages.png"));
        byte[] terms = Files.readAllBytes(sheets.resolve("ball-terms.png"));

        assertThat(figures("--size", "20x10", "-q", "--sweep", "shininess=1")).isZero();

        assertThat(sheets.resolve("ball-stages.png")).hasBinaryContent(stages);
        assertThat(sheets.resolve("ball-terms.png")).hasBinaryContent(terms);
        assertThat(names(sheets)).containsExactly("ball-shininess.png", "ball-stages.png", "ball-terms.png");
    }

    @Test
    void whatAScenesFileAsksForIsKept() throws IOException {
        Files.writeString(scene, scene("7", "3") + "resolution 30 20\n");

        assertThat(figures()).isZero();

        assertThat(said).contains("ball-terms.png: 248x71, ");
    }

    @ParameterizedTest
    @CsvSource({"room.scene, room", "room.v2.scene, room.v2", "room, room", ".room, .room", "stdin.txt, stdin"})
    void sheetsAreNamedAfterTheScene(String file, String name) throws IOException {
        Path named = Files.copy(scene, folder.resolve(file));

        assertThat(run("", "figures", named.toString(), "-d", sheets.toString(), "-q", "--size", "2x2")).isZero();

        assertThat(names(sheets)).containsExactly(name + "-stages.png", name + "-terms.png");
    }

    @Test
    void aSceneFromStandardInputIsCalledStdin() throws IOException {
        assertThat(run(scene("7", "3"), "figures", "-", "-d", sheets.toString(), "-q", "--size", "2x2")).isZero();

        assertThat(names(sheets)).containsExactly("stdin-stages.png", "stdin-terms.png");
    }

    @Test
    void progressCountsTheRowsOfAllSheets() {
        assertThat(figures("--size", "2x10", "--progress", "plain", "--threads", "1", "--sweep", "shininess=1,2,3")).isZero();

        assertThat(said.lines().filter(line -> line.endsWith(" left"))).hasSize(10).first().asString()
            .startsWith(" 10 %, 9 of 90 rows, ");
        assertThat(said).contains("100 %, 90 of 90 rows, 0.0 s left\n");
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {
        "--sweep depth=1,2 | Invalid value for option '--sweep': only the shininess can be swept: "
            + "expected shininess=2,5,20,100 or the like, found 'depth=1,2'",
        "--sweep 2,5 | Invalid value for option '--sweep': only the shininess can be swept: "
            + "expected shininess=2,5,20,100 or the like, found '2,5'",
        "--sweep shininess= | Invalid value for option '--sweep': "
            + "expected numbers of 0 or more such as shininess=2,5,20,100, found ''",
        "--sweep shininess=2,x | Invalid value for option '--sweep': "
            + "expected numbers of 0 or more such as shininess=2,5,20,100, found 'x' in 'shininess=2,x'",
        "--sweep shininess=-1 | Invalid value for option '--sweep': "
            + "expected numbers of 0 or more such as shininess=2,5,20,100, found '-1'",
        "--sweep shininess=2,NaN, | Invalid value for option '--sweep': "
            + "expected numbers of 0 or more such as shininess=2,5,20,100, found 'NaN' in 'shininess=2,NaN,'",
        "--stage final | Unknown options: '--stage', 'final'",
        "--threads 0 | --threads must be 1 to 1024, and is 0",
        "--depth -1 | the depth must be 0 to 1000, and is -1",
        "--size 16384x2 | a sheet of 4 pictures of 16384x2 would have 65596x42 pixels, and a side has at most 65535"})
    void wrongUsageIsOneLineAndNothingIsMade(String options, String message) {
        assertThat(figures(options.split(" "))).isEqualTo(ExitCode.USAGE);

        assertThat(said).isEqualTo("simpleray figures: " + message + " (see simpleray figures --help)\n");
        assertThat(folder.resolve("a")).doesNotExist();
    }

    @Test
    void theFolderIsAskedFor() {
        assertThat(run("", "figures", scene.toString())).isEqualTo(ExitCode.USAGE);

        assertThat(said).isEqualTo("simpleray figures: Missing required option: '--directory=DIR' (see simpleray figures --help)\n");
    }

    @Test
    void noFolderIsMadeForABadScene() throws IOException {
        Files.writeString(scene, "x");
        assertThat(figures()).isEqualTo(ExitCode.BAD_SCENE);
        Files.delete(scene);
        assertThat(figures()).isEqualTo(ExitCode.NO_SCENE);

        assertThat(said).isEqualTo("simpleray: " + scene + ": no such file\n");
        assertThat(folder.resolve("a")).doesNotExist();
    }

    @Test
    void aFileInPlaceOfTheFolderIsNamed() throws IOException {
        Files.createFile(folder.resolve("a"));

        assertThat(figures()).isEqualTo(ExitCode.NO_OUTPUT);
        assertThat(said).startsWith("simpleray: " + sheets + ": cannot be created: ").hasLineCount(1);

        assertThat(run("", "figures", scene.toString(), "-d", folder.resolve("a").toString())).isEqualTo(ExitCode.NO_OUTPUT);
        assertThat(said).isEqualTo("simpleray: " + folder.resolve("a") + ": cannot be created: " + folder.resolve("a") + " is no folder\n");
    }

    @Test
    void allSheetsCanBeCreatedOrNoneIs() throws IOException {
        Path blocked = Files.createDirectories(sheets.resolve("ball-shininess.png"));

        assertThat(figures("--sweep", "shininess=2", "--progress", "plain")).isEqualTo(ExitCode.NO_OUTPUT);

        assertThat(said).isEqualTo("simpleray: " + blocked + ": cannot be created: is a folder\n");
        assertThat(names(sheets)).containsExactly("ball-shininess.png");
    }

    @Test
    void aSheetThatCannotBeWrittenEndsTheCommand() throws IOException {
        Path full = Path.of("/dev/full");
        assumeTrue(Files.exists(full), "no /dev/full here");
        Files.createDirectories(sheets);
        Files.createSymbolicLink(sheets.resolve("ball-terms.png"), full);

        assertThat(figures("--size", "20x10", "--sweep", "shininess=2", "-q")).isEqualTo(ExitCode.WRITE_ERROR);

        assertThat(said).isEqualTo("simpleray: " + sheets.resolve("ball-terms.png") + ": cannot be written: No space left on device\n");
        assertThat(names(sheets)).containsExactly("ball-stages.png", "ball-terms.png");
        Files.delete(sheets.resolve("ball-terms.png"));       // JUnit warns of links that lead out of its folder
    }

    @Test
    void theSceneItselfIsNotOverwritten() throws IOException {
        Files.createDirectories(sheets);
        Path target = sheets.resolve("ball-terms.png");
        Files.createSymbolicLink(target, scene);

        assertThat(figures()).isEqualTo(ExitCode.USAGE);

        assertThat(said).isEqualTo("simpleray figures: the output " + target + " is the scene itself (see simpleray figures --help)\n");
        assertThat(scene).hasContent(scene("7", "3"));
        assertThat(names(sheets)).containsExactly("ball-terms.png");
    }

    private int figures(String... options) {
        List<String> args = new ArrayList<>(List.of("figures", scene.toString(), "-d", sheets.toString()));
        args.addAll(Arrays.asList(options));
        return run("", args.toArray(new String[0]));
    }

    private int run(String in, String... args) {
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        ByteArrayOutputStream err = new ByteArrayOutputStream();
        int exitCode = Main.run(args, new ByteArrayInputStream(in.getBytes(StandardCharsets.UTF_8)), out,
            new PrintStream(err, true, StandardCharsets.UTF_8));
        said = err.toString(StandardCharsets.UTF_8).replace(System.lineSeparator(), "\n");
        assertThat(out.toByteArray()).isEmpty();
        return exitCode;
    }

    private static String scene(String ball, String floor) {
        return String.format(SCENE, ball, floor);
    }

    private static Scene read(String text) throws IOException {
        return SceneFile.read(new ByteArrayInputStream(text.getBytes(StandardCharsets.UTF_8))).scene();
    }

    private static Picture render(Scene scene, Stage stage) {
        SceneSettings asked = new SceneSettings();
        asked.resolution = SIZE;
        return new RenderRequest(asked, stage, false, 1).renderer(scene).render(RenderListener.NONE);
    }

    private void assertShows(String name, byte[] sheet) throws IOException {
        assertThat(Rendered.levels(Files.readAllBytes(sheets.resolve(name)))).isEqualTo(Rendered.levels(sheet));
    }

    private static byte[] sheet(List<String> labels, List<Picture> pictures) throws IOException {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        PngWriter.write(new Sheet(SIZE.width(), SIZE.height(), labels).with(pictures), bytes);
        return bytes.toByteArray();
    }

    private static List<String> names(Path folder) throws IOException {
        try (Stream<Path> files = Files.list(folder)) {
            return files.map(file -> file.getFileName().toString()).sorted().toList();
        }
    }
}
