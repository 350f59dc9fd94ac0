package simpleray.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.BufferedOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.Random;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import simpleray.Project;
import simpleray.image.Picture;
import simpleray.image.png.PngRowReader;
import simpleray.image.png.PngWriter;
import simpleray.render.Band;
import simpleray.render.Provenance;
import simpleray.render.Region;
import simpleray.render.RenderRequest;
import simpleray.scene.SceneFile;
import simpleray.scene.SceneSettings;

/** {@code render --band} makes parts of a picture, {@code merge} the picture of them, as if it had been rendered whole. */
class MergeCommandTest {
    private static final String SIZE = "33x41";

    @TempDir
    Path folder;
    private Path scene;
    private Path out;

    @BeforeEach
    void copyScene() throws IOException {
        scene = Files.copy(Project.scene("thesis"), folder.resolve("a.scene"));
        out = folder.resolve("out.png");
    }

    private static Program.Result run(List<String> line) {
        return InProcess.run(line.toArray(new String[0]));
    }

    private Path file(String name) {
        return folder.resolve(name + ".png");
    }

    /** Renders a picture or a part of one, and returns its file. */
    private Path render(String name, String... options) {
        List<String> line = new ArrayList<>(List.of("render", scene.toString(), "-o", file(name).toString(), "-q"));
        line.addAll(List.of(options));
        if (!line.contains("--size")) {
            line.addAll(List.of("--size", SIZE));
        }
        Program.Result result = run(line);
        assertThat(result.err()).isEmpty();
        assertThat(result.exitCode()).isZero();
        return file(name);
    }

    /** Renders all bands as 1, 2, 3 and so on. */
    private String[] bands(int count, String... options) {
        String[] names = new String[count];
        for (int i = 1; i <= count; i++) {
            names[i - 1] = String.valueOf(i);
            render(names[i - 1], Stream.concat(Stream.of(options), Stream.of("--band", i + "/" + count)).toArray(String[]::new));
        }
        return names;
    }

    private Program.Result merge(String... names) {
        List<String> line = new ArrayList<>(List.of("merge", "-o", out.toString()));
        for (String name : names) {
            line.add(file(name).toString());
        }
        return run(line);
    }

    private void assertMerged(Path whole, String... names) {
        Program.Result result = merge(names);

        assertThat(result.err()).startsWith(out + ": ").hasLineCount(1);
        assertThat(result.exitCode()).isZero();
        assertThat(out).hasSameBinaryContentAs(whole);
    }

    private void assertRefused(String messages, String... names) {
        assertEnds(ExitCode.BAD_SCENE, messages, names);
    }

    /** In the messages a name in brackets stands for its file. */
    private void assertEnds(int exitCode, String messages, String... names) {
        Program.Result result = merge(names);

        assertThat(result.err()).isEqualTo(messages.replaceAll("\\[(\\w+)\\]", folder + "/$1.png"));
        assertThat(result.exitCode()).isEqualTo(exitCode);
        assertThat(out).doesNotExist();
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 2, 3, 7, 40, 41})
    void thePartsInAnyOrderAreThePicture(int count) {
        List<String> names = new ArrayList<>(List.of(bands(count)));
        Path whole = render("whole");

        assertMerged(whole, names.toArray(new String[0]));
        Collections.reverse(names);
        assertMerged(whole, names.toArray(new String[0]));
        Collections.shuffle(names, new Random(count));
        assertMerged(whole, names.toArray(new String[0]));
    }

    @ParameterizedTest
    @ValueSource(strings = {"--samples 2 --stage lighting", "--samples adaptive", "--region 3,5,20,30", "--region 3,5,20,30 --samples adaptive",
        "--camera 1,0.5,3,0,-0.2,0,50 --background 0.1,0.2,0.3 --depth 2", "--threads 3 --accel none", "--size 3000x40"})
    void theyAreRenderedWithAllOptions(String options) {
        String[] names = bands(3, options.split(" "));

        assertMerged(render("whole", options.split(" ")), names);
    }

    @Test
    void bandsOfAnyNumbersDoIfTheyAreAllRowsOnce() {
        Path whole = render("whole");
        render("upper", "--band", "1/2");
        render("three", "--band", "3/4");
        render("four", "--band", "4/4", "--threads", "3", "--accel", "none");

        assertMerged(whole, "four", "upper", "three");
    }

    @Test
    void theSceneMayLieElsewhere() throws IOException {
        Path whole = render("whole");
        render("1", "--band", "1/2");
        Path elsewhere = Files.createDirectory(folder.resolve("elsewhere")).resolve("a.scene");
        scene = Files.move(scene, elsewhere);
        render("2", "--band", "2/2");

        assertMerged(whole, "2", "1");
    }

    @Test
    void aSceneThatIsTooLongToBeCarriedNeedNotBe() throws IOException {
        Files.writeString(scene, SmallScenes.GREY + ("#" + "-".repeat(1023)).repeat(5 * 1024) + '\n');
        String[] names = bands(2);

        assertMerged(render("whole"), names);
        assertThat(Files.size(out)).isLessThan(2000);
    }

    @Test
    void itGoesToStandardOutputAndAnOldFileIsReplaced() throws IOException {
        bands(2);
        Path whole = render("whole");

        Program.Result result = run(List.of("merge", "-q", file("2").toString(), file("1").toString(), "-o", "-"));
        assertThat(result.out()).isEqualTo(Files.readAllBytes(whole));
        assertThat(result.err()).isEmpty();
        assertThat(run(List.of("merge", file("2").toString(), file("1").toString(), "-o", "-")).err()).matches("<stdout>: 33x41, .* s\n");
        Files.writeString(out, "the old one");
        assertThat(run(List.of("merge", "-q", file("2").toString(), file("1").toString(), "-o", out.toString())).err()).isEmpty();
        assertThat(out).hasSameBinaryContentAs(whole);
    }

    @Test
    void rowsThatAreMissingAreNamed() {
        bands(4);

        assertRefused("simpleray: [out]: cannot be made: rows 11 to 20 of 41 are missing (--band 2/4)\n", "4", "1", "3");
        assertRefused("simpleray: [out]: cannot be made: rows 1 to 20 of 41 are missing (--band 1/4 to 2/4)\n", "4", "3");
        assertRefused("simpleray: [out]: cannot be made: rows 1 to 10 of 41 are missing (--band 1/4)\n"
            + "simpleray: [out]: cannot be made: rows 21 to 30 of 41 are missing (--band 3/4)\n", "4", "2");
        assertRefused("simpleray: [out]: cannot be made: rows 11 to 41 of 41 are missing (--band 2/4 to 4/4)\n", "1");
        render("row", "--band", "2/41");
        render("rest", "--band", "1/41");
        assertRefused("simpleray: [out]: cannot be made: rows 3 to 10 of 41 are missing\n", "4", "3", "2", "row", "rest");
        render("third", "--band", "4/41");
        assertRefused("simpleray: [out]: cannot be made: row 3 of 41 is missing (--band 3/41)\n"
            + "simpleray: [out]: cannot be made: rows 5 to 41 of 41 are missing (--band 5/41 to 41/41)\n", "row", "rest", "third");
    }

    @Test
    void rowsThatAreThereTwiceAreNamed() throws IOException {
        bands(3);
        Files.copy(file("2"), file("copy"));
        render("half", "--band", "1/2");
        render("all", "--band", "1/1");

        assertRefused("simpleray: [2]: is there twice\n", "1", "2", "3", "2");
        assertRefused("simpleray: [copy]: has rows 14 to 27 of 41, and [2] has rows 14 to 27 of 41\n", "1", "2", "3", "copy");
        assertRefused("simpleray: [2]: has rows 14 to 27 of 41, and [half] has rows 1 to 20 of 41\n", "half", "2", "3");
        assertRefused("simpleray: [2]: has rows 14 to 27 of 41, and [all] has rows 1 to 41 of 41\n"
            + "simpleray: [3]: has rows 28 to 41 of 41, and [all] has rows 1 to 41 of 41\n", "all", "3", "2");
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {"--depth 3 | depth 3 (there 10)", "--size 33x40 | resolution 33 40 (there 33 41)",
        "--size 32x41 | resolution 32 41 (there 33 41)", "--samples 2 | samples 2 (there 1)", "--samples adaptive | samples adaptive (there 1)",
        "--stage lighting | stage lighting (there final)", "--region 0,0,33,40 | a region", "--cop 3.3 | a cop",
        "--background 1,0,0 --depth 2 | a background, depth 2 (there 10)"})
    void partsOfOtherOptionsAreRefused(String options, String difference) {
        bands(2);
        render("other", Stream.concat(Stream.of(options.split(" ")), Stream.of("--band", "2/2")).toArray(String[]::new));

        assertRefused("simpleray: [other]: is of another picture than [1]: " + difference + "\n"
            + "simpleray: [out]: cannot be made: rows 21 to 41 of 41 are missing (--band 2/2)\n", "1", "other");
        assertRefused("simpleray: [other]: is of another picture than [1]: " + difference + '\n', "1", "other", "2");
    }

    @Test
    void partsOfAnotherSceneAreRefused() throws IOException {
        bands(2);
        Files.writeString(scene, Files.readString(scene) + "# a comment\n");
        render("other", "--band", "2/2");

        assertRefused("simpleray: [other]: is of another picture than [1]: another scene\n", "1", "2", "other");
        scene = Files.copy(Project.scene("thesis"), folder.resolve("b.scene"));
        render("named", "--band", "2/2");
        assertRefused("simpleray: [named]: is of another picture than [1]: scene's name b.scene (there a.scene)\n", "1", "2", "named");
    }

    @Test
    void partsOfAnotherMeshAreRefused() throws IOException {
        Files.writeString(scene, "1  4 \"tetra.obj\" 0 0 0 1  1 1 1  0 0 0  0 0 0  1   0.5 0.5 0.5  0\n");
        Path mesh = folder.resolve("tetra.obj");
        Files.writeString(mesh, "v 1 1 1\nv -1 -1 1\nv -1 1 -1\nv 1 -1 -1\nf 1 2 3\nf 1 4 2\nf 1 3 4\nf 2 4 3\n");
        bands(2);
        Files.writeString(mesh, Files.readString(mesh) + "# more\n");
        render("other", "--band", "2/2");

        Program.Result result = merge("1", "2", "other");
        assertThat(result.err()).matches("simpleray: \\Q" + file("other") + ": is of another picture than " + file("1")
            + "\\E: mesh tetra.obj [0-9a-f]{64} \\(there [0-9a-f]{64}\\)\n");
        assertThat(result.exitCode()).isEqualTo(ExitCode.BAD_SCENE);
    }

    private void rewrite(String name, String from, String to) throws IOException {
        String text = Files.readString(file(name), StandardCharsets.ISO_8859_1);
        assertThat(text).contains(from);
        Files.write(file(name), PngSums.renewed(text.replace(from, to).getBytes(StandardCharsets.ISO_8859_1)));
    }

    @Test
    void partsOfAnotherVersionAreRefused() throws IOException {
        bands(2);
        rewrite("2", "SimpleRay 0.1.0", "SimpleRay 0.0.9");

        assertRefused("simpleray: [2]: was made by SimpleRay 0.0.9, and this is SimpleRay 0.1.0: the parts of a picture are of one version\n"
            + "simpleray: [out]: cannot be made: rows 21 to 41 of 41 are missing (--band 2/2)\n", "1", "2");
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {"depth 10 | depth 11", "rows 21 to 41 of 41 | rows 21 to 40 of 41", "band 2/2 | band 2/3"})
    void whatAPartTellsCannotBeChangedUnnoticed(String from, String to) throws IOException {
        bands(2);
        rewrite("2", from, to);

        assertRefused("simpleray: [2]: is damaged: it does not end with its checksum\n"
            + "simpleray: [out]: cannot be made: rows 21 to 41 of 41 are missing (--band 2/2)\n", "1", "2");
    }

    @Test
    void aPartThatIsNoneIsRefused() throws IOException {
        bands(2);
        render("whole");
        Files.writeString(file("text"), "no picture");
        Files.createDirectory(file("folder"));

        assertRefused("simpleray: [whole]: is no part of a picture\n", "1", "whole", "2");
        assertRefused("simpleray: [text]: is no PNG\n", "1", "text", "2");
        assertEnds(ExitCode.NO_SCENE, "simpleray: [none]: no such file\n", "1", "none", "2");
        assertEnds(ExitCode.NO_SCENE, "simpleray: [folder]: is a folder\nsimpleray: [none]: no such file\n", "folder", "none");
        assertRefused("simpleray: [none]: no such file\nsimpleray: [text]: is no PNG\nsimpleray: [folder]: is a folder\n"
            + "simpleray: [out]: cannot be made: rows 21 to 41 of 41 are missing (--band 2/2)\n", "none", "text", "1", "folder");
    }

    @Test
    void aPartThatIsCutOffAnywhereIsRefusedAndNamed() throws IOException {
        bands(2);
        byte[] whole = Files.readAllBytes(file("2"));
        for (int length = 0; length < whole.length; length += whole.length / 40) {
            Files.write(file("2"), Arrays.copyOf(whole, length));
            assertNamed("length " + length);
        }
        Files.write(file("2"), Arrays.copyOf(whole, whole.length - 1));
        assertNamed("without its last byte");
        Files.write(file("2"), Arrays.copyOf(whole, whole.length + 1));
        assertNamed("with a byte more");
    }

    @Test
    void aPartWithAnyWrongBitIsRefusedAndNamed() throws IOException {
        bands(2);
        byte[] whole = Files.readAllBytes(file("2"));
        for (int at = 0; at < whole.length; at += whole.length / 60) {
            byte[] other = whole.clone();
            other[at] ^= (byte) (1 << at % 8);
            Files.write(file("2"), other);
            assertNamed("byte " + at);
            byte[] renewed = PngSums.renewed(other);
            if (!Arrays.equals(renewed, whole)) {             // else the bit was one of a checksum
                Files.write(file("2"), renewed);
                assertNamed("byte " + at + " with a new checksum");
            }
        }
    }

    private void assertNamed(String what) {
        Program.Result result = merge("1", "2");
        assertThat(result.err()).as(what).contains(file("2") + ": ").doesNotContain("internal");
        assertThat(result.exitCode()).as(what).isEqualTo(ExitCode.BAD_SCENE);
        assertThat(out).as(what).doesNotExist();
    }

    /** Writes a band of a picture, as if it had been rendered; perhaps of another size than it tells. */
    private void write(String name, int side, Band band, int width, int height) throws IOException {
        SceneSettings settings = new SceneSettings();
        settings.resolution = new SceneSettings.Resolution(side, side);
        RenderRequest request = new RenderRequest().with(settings).with(band);
        Region whole = Region.whole(side, side);
        Picture picture = new Picture(width, height);
        picture.tell(Provenance.of(request, SceneFile.read(scene)));
        double[] light = new double[3 * width];
        try (OutputStream out = new BufferedOutputStream(Files.newOutputStream(file(name)))) {
            PngWriter png = new PngWriter(picture, out, null, band.rows(whole));
            for (int y = 0; y < height; y++) {
                Arrays.fill(light, 0, (band.of(whole).y() + y) % light.length, y % 2 == 0 ? 0.3 : 0.7);
                picture.setRow(y, light);
                png.row(y);
                picture.release(y);
            }
            png.end();
        }
    }

    @Test
    void aPartOfAnotherSizeThanItTellsIsRefused() throws IOException {
        write("1", 20, new Band(1, 2), 20, 10);
        write("2", 20, new Band(2, 2), 20, 9);
        write("wide", 20, new Band(2, 2), 21, 10);

        assertRefused("simpleray: [2]: is 20x9, and its options say 20x10\n", "1", "2");
        assertRefused("simpleray: [wide]: is 21x10, and its options say 20x10\n", "1", "wide");
        Files.writeString(out, "the old one");
        assertThat(merge("wide", "1").exitCode()).isEqualTo(ExitCode.BAD_SCENE);
        assertThat(out).hasContent("the old one");
    }

    @Test
    void aPictureOfManyTimesTheMemoryIsMerged() throws IOException, InterruptedException {
        int side = 3000;                                      // 27 MB of levels, and 216 MB of light
        write("1", side, new Band(1, 2), side, side / 2);
        write("2", side, new Band(2, 2), side, side / 2);

        Process merge = Program.program(folder, List.of("-Xmx24m"), "merge", "-q", "-o", "out.png", "2.png", "1.png").start();
        Program.Result result = Program.finish(merge, new byte[0]);

        assertThat(result.err()).isEmpty();
        assertThat(result.exitCode()).isZero();
        try (PngRowReader upper = new PngRowReader(file("1")); PngRowReader lower = new PngRowReader(file("2"));
             PngRowReader merged = new PngRowReader(out)) {
            for (int y = 0; y < side; y++) {
                if (!Arrays.equals((y < side / 2 ? upper : lower).next(), merged.next())) {
                    throw new AssertionError("row " + y + " is another");
                }
            }
            merged.end();
        }
    }

    @Test
    void theOutputIsNoneOfTheParts() throws IOException {
        bands(2);
        byte[] part = Files.readAllBytes(file("2"));

        Program.Result result = run(List.of("merge", "-o", file("2").toString(), file("1").toString(), file("2").toString()));

        assertThat(result.err()).isEqualTo("simpleray merge: the output " + file("2") + " is one of the parts (see simpleray merge --help)\n");
        assertThat(result.exitCode()).isEqualTo(ExitCode.USAGE);
        assertThat(file("2")).hasBinaryContent(part);
        assertThat(run(List.of("merge", "-o", "a.jpg", file("1").toString())).err()).startsWith("simpleray merge: pictures are written as PNG only");
        assertThat(run(List.of("merge", "-o", "a.scene", file("1").toString())).err()).startsWith("simpleray merge: pictures are written as PNG only");
        assertThat(run(List.of("merge", "-o", out.toString())).exitCode()).isEqualTo(ExitCode.USAGE);
    }

    @Test
    void aPartIsVerifiedAsSuch() throws IOException {
        bands(2);

        assertThat(InProcess.run("verify", file("2").toString(), "-q").text())
            .isEqualTo(file("2") + ": part 2/2, rows 21 to 41 of 41: good: all 693 pixels are the same\n");
        assertThat(InProcess.run("verify", file("1").toString(), "-q", "--scene", scene.toString()).text())
            .isEqualTo(file("1") + ": part 1/2, rows 1 to 20 of 41: good: all 660 pixels are the same\n");
        Files.delete(scene);
        assertThat(InProcess.run(Files.newInputStream(file("2")), OutputStream.nullOutputStream(), "verify", "-", "-q").exitCode()).isZero();
    }

    @Test
    void aDamagedPartIsNotVerified() throws IOException {
        bands(2);
        rewrite("2", "rows 21 to 41 of 41", "rows 21 to 40 of 41");

        Program.Result result = InProcess.run("verify", file("2").toString());
        assertThat(result.err()).isEqualTo("simpleray: " + file("2") + ": is damaged: it does not end with its checksum\n");
        assertThat(result.exitCode()).isEqualTo(ExitCode.BAD_SCENE);
    }

    @Test
    void aPartIsAPictureOfItsRowsAndAScene() {
        bands(2);
        render("lower", "--region", "0,20,33,21");

        assertThat(InProcess.run("compare", file("2").toString(), file("lower").toString()).exitCode()).isZero();
        assertThat(InProcess.run("check", file("2").toString()).exitCode()).isZero();
        assertThat(InProcess.run("render", file("2").toString(), "-q", "-o", out.toString()).exitCode()).isZero();
        assertThat(out).hasSameBinaryContentAs(render("whole"));
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {"0/3 | Invalid value for option '--band': bands are 1/N to N/N, such as 2/3, and this is 0/3",
        "4/3 | Invalid value for option '--band': bands are 1/N to N/N, such as 2/3, and this is 4/3",
        "2 | Invalid value for option '--band': expected a band such as 2/3, found '2'",
        "1/42 | there are more bands, 42, than rows, 41"})
    void whatIsNoBandIsWrongUsage(String band, String message) {
        Program.Result result = run(List.of("render", scene.toString(), "-o", out.toString(), "--size", SIZE, "--band", band));

        assertThat(result.err()).isEqualTo("simpleray render: " + message + " (see simpleray render --help)\n");
        assertThat(result.exitCode()).isEqualTo(ExitCode.USAGE);
        assertThat(out).doesNotExist();
    }

    @Test
    void aRegionHasAsManyBandsAsItHasRows() {
        render("row", "--region", "0,0,5,3", "--band", "3/3");

        Program.Result result = run(List.of("render", scene.toString(), "-o", out.toString(), "--size", SIZE, "--region", "0,0,5,3", "--band", "1/4"));
        assertThat(result.err()).startsWith("simpleray render: there are more bands, 4, than rows, 3");
        assertThat(run(List.of("render", scene.toString(), "-o", out.toString(), "--size", SIZE, "--region", "0,0,5,99", "--band", "1/4")).err())
            .startsWith("simpleray render: the region 0,0,5,99 is not inside the picture of 33x41");
    }
}
