package simpleray.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Map;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import simpleray.Project;
import simpleray.Rendered;
import simpleray.image.Checkpoint;
import simpleray.image.Picture;
import simpleray.render.Band;
import simpleray.render.PictureIdentity;
import simpleray.render.Region;
import simpleray.render.RenderRequest;
import simpleray.render.Stage;
import simpleray.scene.Scene;
import simpleray.scene.SceneFile;
import simpleray.scene.SceneSettings;
import simpleray.scene.SceneSettings.Resolution;

/** A rendering goes on with the rows of its own picture, and with no others. */
class RenderCommandResumeTest {
    private static final int SIDE = 40;
    private static final String SIZE = SIDE + "x" + SIDE;

    @TempDir
    Path folder;
    private Path scene;
    private Path out;
    private Path part;

    @BeforeEach
    void copyScene() throws IOException {
        scene = Files.copy(Project.scene("thesis"), folder.resolve("a.scene"));
        out = folder.resolve("a.png");
        part = folder.resolve("a.png.part");
    }

    private Program.Result render(String... options) {
        String[] args = Stream.concat(Stream.of("render", scene.toString(), "-o", out.toString(), "--size", SIZE), Arrays.stream(options))
            .toArray(String[]::new);
        return InProcess.run(args);
    }

    /** Writes a checkpoint as an ended rendering leaves it. */
    private void keep(Path file, boolean adaptive, byte[] levels, IntStream rows) throws IOException {
        keep(file, adaptive, null, levels, rows);
    }

    private void keep(Path file, boolean adaptive, Region region, byte[] levels, IntStream rows) throws IOException {
        keep(file, adaptive, region, null, levels, rows);
    }

    private void keep(Path file, boolean adaptive, Region region, Band band, byte[] levels, IntStream rows) throws IOException {
        SceneSettings asked = new SceneSettings();
        asked.resolution = new Resolution(SIDE, SIDE);
        RenderRequest request = new RenderRequest(asked, Stage.FINAL, adaptive, 1).with(region).with(band);
        Scene read = SceneFile.read(scene).scene();
        read = read.settings.frames == null ? read : read.still(1);
        Picture picture = request.renderer(read).picture();
        Map<String, String> identity = PictureIdentity.of(Main.version(), request, read);
        try (Checkpoint checkpoint = Checkpoint.create(file, identity, 3 * picture.width(), picture.height())) {
            for (int y : rows.toArray()) {
                checkpoint.put(y, levels, 3 * picture.width() * y);
            }
        }
    }

    private byte[] levels(byte[] png) throws IOException {
        int[] levels = Rendered.levels(png);
        byte[] bytes = new byte[levels.length];
        for (int i = 0; i < bytes.length; i++) {
            bytes[i] = (byte) levels[i];
        }
        return bytes;
    }

    private byte[] unbroken(String... options) throws IOException {
        assertThat(render(options).exitCode()).isZero();
        byte[] png = Files.readAllBytes(out);
        Files.delete(out);
        return png;
    }

    private void assertFails(Program.Result result, int exitCode, String message) {
        assertThat(result.err()).isEqualTo("simpleray: " + message + "\n");
        assertThat(result.exitCode()).isEqualTo(exitCode);
        assertThat(out).doesNotExist();
    }

    @ParameterizedTest
    @ValueSource(strings = {"1", "adaptive"})
    void keptRowsAndNewRowsMakeTheSamePicture(String samples) throws IOException {
        byte[] expected = unbroken("--samples", samples);
        keep(part, samples.equals("adaptive"), levels(expected), IntStream.range(0, SIDE).filter(y -> y % 3 == 1));

        Program.Result result = render("--resume", "--samples", samples);

        assertThat(result.err()).startsWith("simpleray: going on with 13 of 40 rows, kept in " + part + "\n" + out + ": 40x40, ");
        assertThat(Files.readAllBytes(out)).isEqualTo(expected);
        assertThat(part).doesNotExist();
    }

    @ParameterizedTest
    @ValueSource(strings = {"1", "adaptive"})
    void theRowsOfARegionMakeTheSameRegion(String samples) throws IOException {
        String[] options = {"--samples", samples, "--region", "7,5,23,30"};
        byte[] expected = unbroken(options);
        Region region = new Region(7, 5, 23, 30);
        keep(part, samples.equals("adaptive"), region, levels(expected), IntStream.range(0, 30).filter(y -> y % 3 == 1));

        Program.Result result = render("--resume", "--samples", samples, "--region", "7,5,23,30");

        assertThat(result.err()).startsWith("simpleray: going on with 10 of 30 rows, kept in " + part + "\n" + out + ": 23x30, ");
        assertThat(Files.readAllBytes(out)).isEqualTo(expected);
        assertThat(part).doesNotExist();
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {"--region 7,5,23,31 | region 7,5,23,30 (now 7,5,23,31)",
        "--region 8,5,23,30 | region 7,5,23,30 (now 8,5,23,30)", "--depth 10 | a region"})
    void theRowsOfAnotherRegionAreRefused(String option, String difference) throws IOException {
        keep(part, false, new Region(7, 5, 23, 30), new byte[3 * SIDE * SIDE], IntStream.range(0, 30));

        assertFails(render(Stream.concat(Stream.of("--resume"), Arrays.stream(option.split(" "))).toArray(String[]::new)),
            ExitCode.BAD_SCENE, part + " holds rows of another picture: " + difference + " (--restart discards them)");
    }

    @Test
    void theRowsOfAFrameAreThoseOfThatFrameAlone() throws IOException {
        Files.writeString(scene, Files.readString(scene) + "\nframes 3 25\nkey 0 object 1 0 0 0\nkey 2 object 1 0.5 0 0\n");
        byte[] expected = unbroken("--frame", "1");
        keep(part, false, levels(expected), IntStream.range(0, 20));

        assertFails(render("--resume", "--frame", "2"), ExitCode.BAD_SCENE, part + " holds rows of another picture: another scene (--restart discards them)");
        assertFails(render("--resume"), ExitCode.BAD_SCENE, part + " holds rows of another picture: another scene (--restart discards them)");
        assertThat(render("--resume", "--frame", "1").err()).startsWith("simpleray: going on with 20 of 40 rows, kept in " + part + "\n");
        assertThat(Files.readAllBytes(out)).isEqualTo(expected);
    }

    @Test
    void theRowsOfABandMakeTheSamePart() throws IOException {
        byte[] expected = unbroken("--band", "2/3");
        keep(part, false, null, new Band(2, 3), levels(expected), IntStream.of(0, 5, 12));

        assertThat(render("--resume", "--band", "2/3").err())
            .startsWith("simpleray: going on with 3 of 13 rows, kept in " + part + "\n" + out + ": 40x13, ");
        assertThat(Files.readAllBytes(out)).isEqualTo(expected);
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {"--band 1/3 | band 2/3 (now 1/3)", "--band 2/4 | band 2/3 (now 2/4)", "--depth 10 | a band"})
    void theRowsOfAnotherBandAreRefused(String option, String difference) throws IOException {
        keep(part, false, null, new Band(2, 3), new byte[3 * SIDE * SIDE], IntStream.range(0, 13));

        assertFails(render(Stream.concat(Stream.of("--resume"), Arrays.stream(option.split(" "))).toArray(String[]::new)),
            ExitCode.BAD_SCENE, part + " holds rows of another picture: " + difference + " (--restart discards them)");
    }

    @Test
    void aCheckpointThatIsInUseIsRefused() throws IOException {
        keep(part, false, new byte[3 * SIDE * SIDE], IntStream.range(0, 5));
        String busy = part + ": is being written by another run of SimpleRay: wait until it has ended, or choose another name";

        try (Checkpoint first = Checkpoint.open(part, Checkpoint.identity(part), 3 * SIDE, SIDE)) {
            assertFails(render("--resume"), ExitCode.BUSY, busy);
            assertFails(render("--restart"), ExitCode.BUSY, busy);
            assertFails(render("--restart", "--checkpoint", part.toString()), ExitCode.BUSY, busy);
            first.put(5, new byte[3 * SIDE], 0);
            assertThat(first.count()).isEqualTo(6);
        }
    }

    @Test
    void keptRowsAreNotRenderedAgain() throws IOException {
        byte[] black = new byte[3 * SIDE * SIDE];
        keep(part, false, black, IntStream.range(0, SIDE));

        assertThat(render("--resume").exitCode()).isZero();
        assertThat(Rendered.levels(Files.readAllBytes(out))).containsOnly(0);
    }

    @Test
    void onlyTheRaysOfNewRowsAreCounted() throws IOException {
        keep(part, false, new byte[3 * SIDE * SIDE], IntStream.range(0, 15));

        assertThat(render("--resume", "--stats", "json").text()).startsWith("{\"rays\":{\"primary\":" + 25 * SIDE + ',');
    }

    @Test
    void aCheckpointMayBeNamed() throws IOException {
        byte[] expected = unbroken();
        Path named = folder.resolve("rows");
        keep(named, false, levels(expected), IntStream.of(39, 0, 7));

        Program.Result result = render("--resume", "--checkpoint", named.toString(), "-q");

        assertThat(result.err()).isEmpty();
        assertThat(Files.readAllBytes(out)).isEqualTo(expected);
        assertThat(named).doesNotExist();
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {"--size 40x41 | size 40x40 (now 40x41)", "--stage lighting | stage final (now lighting)",
        "--depth 3 | depth 10 (now 3)", "--samples adaptive | samples 1 (now adaptive)", "--cop 3 | cop 2.0 (now 3.0)",
        "--window -1,1,-1,1 | window default (now -1.0,1.0,-1.0,1.0)", "--background 0,0,1 | background 0.0,0.0,0.0 (now 0.0,0.0,1.0)"})
    void theRowsOfAnotherPictureAreRefused(String option, String difference) throws IOException {
        keep(part, false, new byte[3 * SIDE * SIDE], IntStream.range(0, 5));
        byte[] before = Files.readAllBytes(part);
        String[] line = Stream.concat(Stream.of("render", scene.toString(), "-o", out.toString(), "--resume"),
            Arrays.stream((option.startsWith("--size") ? option : "--size " + SIZE + " " + option).split(" "))).toArray(String[]::new);

        assertFails(InProcess.run(line), ExitCode.BAD_SCENE,
            part + " holds rows of another picture: " + difference + " (--restart discards them)");
        assertThat(part).hasBinaryContent(before);
    }

    @Test
    void theRowsOfAnotherSceneAreRefusedUnlessDiscarded() throws IOException {
        keep(part, false, new byte[3 * SIDE * SIDE], IntStream.range(0, 5));
        Files.writeString(scene, Files.readString(scene).replace("0.3 0.3 0.3", "0.3 0.3 0.4"));

        assertFails(render("--resume"), ExitCode.BAD_SCENE,
            part + " holds rows of another picture: another scene (--restart discards them)");
        Program.Result discarded = render("--resume", "--restart");
        assertThat(discarded.err()).matches("\\Q" + out + "\\E: 40x40, .* s\n");
        assertThat(part).doesNotExist();
        assertThat(Files.readAllBytes(out)).isEqualTo(unbroken());
    }

    @Test
    void theRowsOfAnotherVersionAreRefused() throws IOException {
        Checkpoint.create(part, Map.of("version", "0.0.1"), 3 * SIDE, SIDE).close();

        assertThat(render("--resume").err()).startsWith("simpleray: " + part + " holds rows of another picture: version 0.0.1 (now "
            + Main.version() + "), no scene, ");
    }

    @Test
    void aCommentInTheSceneDoesNotMatterAndThePictureCarriesIt() throws IOException {
        byte[] before = unbroken();
        keep(part, false, levels(before), IntStream.range(0, 20));
        Files.writeString(scene, "# mine\n" + Files.readString(scene));

        assertThat(render("--resume").exitCode()).isZero();
        byte[] resumed = Files.readAllBytes(out);
        assertThat(levels(resumed)).isEqualTo(levels(before));
        assertThat(resumed).isNotEqualTo(before).isEqualTo(unbroken());
    }

    @Test
    void withoutKeptRowsItBeginsWithTheFirst() throws IOException {
        byte[] expected = unbroken();

        assertThat(render("--resume").err()).startsWith("simpleray: " + part + " is not there: beginning with the first row\n");
        assertThat(Files.readAllBytes(out)).isEqualTo(expected);

        Files.writeString(part, "SimpleRay check");
        assertThat(render("--resume").err()).startsWith("simpleray: " + part + " holds no row: beginning with the first\n");
        assertThat(Files.readAllBytes(out)).isEqualTo(expected);
        assertThat(part).doesNotExist();
    }

    @Test
    void keptRowsAreNeitherUsedNorLostUnlessAskedFor() throws IOException {
        keep(part, false, new byte[3 * SIDE * SIDE], IntStream.range(0, 5));
        byte[] before = Files.readAllBytes(part);

        Program.Result result = render();

        assertThat(result.err()).startsWith("simpleray: " + part + " holds rows of an earlier rendering, which --resume goes on with and "
            + "--restart discards; this one begins with the first row, and keeps none\n" + out + ": 40x40, ");
        assertThat(Files.readAllBytes(out)).isEqualTo(unbroken());
        assertThat(part).hasBinaryContent(before);
        assertFails(render("--checkpoint", part.toString()), ExitCode.NO_OUTPUT,
            part + " holds rows of an earlier rendering: --resume goes on with them, --restart discards them");
    }

    @Test
    void aFileThatIsNoCheckpointIsNeverTouched() throws IOException {
        Files.writeString(part, "half of something else");

        assertThat(render().exitCode()).isZero();
        Files.delete(out);
        assertFails(render("--resume"), ExitCode.BAD_SCENE, part + ": is no checkpoint");
        assertFails(render("--restart"), ExitCode.NO_OUTPUT, part + ": is no checkpoint");
        assertFails(render("--checkpoint", scene.toString()), ExitCode.NO_OUTPUT, scene + ": is no checkpoint");
        assertThat(part).hasContent("half of something else");
        assertThat(scene).hasSameBinaryContentAs(Project.scene("thesis"));
    }

    @Test
    void aCheckpointThatCannotBeCreatedIsKnownBeforeTheFirstRay() {
        Path nowhere = folder.resolve("no/rows");

        assertFails(render("--checkpoint", nowhere.toString()), ExitCode.NO_OUTPUT, nowhere + ": there is no folder " + folder.resolve("no"));
        assertFails(render("--checkpoint", folder.toString()), ExitCode.NO_OUTPUT, folder + ": is a folder");
    }

    @Test
    void aCheckpointNeedsANameOfItsOwn() {
        Program.Result itself = render("--checkpoint", out.toString());
        Program.Result stream = InProcess.run("render", scene.toString(), "-o", "-", "--resume");

        assertThat(itself.err()).isEqualTo("simpleray render: the checkpoint " + out + " is the output itself "
            + "(see simpleray render --help)\n");
        assertThat(itself.exitCode()).isEqualTo(ExitCode.USAGE);
        assertThat(stream.err()).isEqualTo("simpleray render: --resume needs --checkpoint FILE where the picture goes to standard output "
            + "(see simpleray render --help)\n");
        assertThat(stream.exitCode()).isEqualTo(ExitCode.USAGE);
    }

    @Test
    void aShortRenderingLeavesNothingButItsPicture() throws IOException {
        assertThat(render().exitCode()).isZero();
        assertThat(render("--checkpoint", folder.resolve("rows").toString()).exitCode()).isZero();

        try (Stream<Path> files = Files.list(folder)) {
            assertThat(files).containsExactlyInAnyOrder(scene, out);
        }
    }
}
