package simpleray.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import simpleray.Rendered;
import simpleray.image.Picture;
import simpleray.image.png.PngWriter;

class CompareCommandTest {
    @TempDir
    Path folder;
    private String one;
    private String other;

    @BeforeEach
    void writePictures() throws IOException {
        one = write("one.png", 2, 100, 100);
        other = write("other.png", 2, 100, 103);
    }

    /** {@return a picture of one row of greys} */
    private String write(String name, int width, int... levels) throws IOException {
        Picture picture = new Picture(width, 1);
        double[] row = new double[3 * width];
        for (int i = 0; i < row.length; i++) {
            row[i] = levels[i / 3] / 255.0;
        }
        picture.setRow(0, row);
        try (OutputStream out = Files.newOutputStream(folder.resolve(name))) {
            PngWriter.write(picture, out);
        }
        return folder.resolve(name).toString();
    }

    private static void assertEnds(int exitCode, String out, String err, String... args) {
        Program.Result result = InProcess.run(args);

        assertThat(result.err()).isEqualTo(err);
        assertThat(result.text()).isEqualTo(out);
        assertThat(result.exitCode()).isEqualTo(exitCode);
    }

    @Test
    void equalPicturesAre0() {
        assertEnds(0, one + " and " + one + " are the same: 2x1\n"
            + "largest difference     0 levels\n"
            + "RMSE                   0.000000 levels\n"
            + "PSNR                   infinite\n"
            + "SSIM                   1.000000\n"
            + "pixels beyond 1 level  0 of 2\n", "", "compare", one, one);
        assertEnds(0, "{\"same\":true,\"width\":2,\"height\":1,\"maximum\":0,\"rmse\":0.0,\"psnr\":null,\"ssim\":1.0,"
            + "\"beyondOneLevel\":0,\"pixels\":2}\n", "", "compare", one, one, "--format", "json");
    }

    /**
     * The differences 0 and 3 have the mean square 4.5. Means 100 and 101.5, variances 0 and 2.25, covariance 0: the similarity is
     * (2 * 10150 + 6.5025) / (10000 + 10302.25 + 6.5025) * 58.5225 / (2.25 + 58.5225) = 0.962870.
     */
    @Test
    void differentPicturesAre1() {
        assertEnds(ExitCode.DIFFERENT, one + " and " + other + " are different: 2x1\n"
            + "largest difference     3 levels\n"
            + "RMSE                   2.121320 levels\n"
            + "PSNR                   41.5987 dB\n"
            + "SSIM                   0.962870\n"
            + "pixels beyond 1 level  1 of 2\n", "", "compare", one, other);
        assertThat(InProcess.run("compare", one, other, "--format", "json").text()).startsWith(
            "{\"same\":false,\"width\":2,\"height\":1,\"maximum\":3,\"rmse\":2.1213203435")
            .endsWith(",\"beyondOneLevel\":1,\"pixels\":2}\n");
    }

    @Test
    void theHeatMapShowsWhere() throws IOException {
        Path map = folder.resolve("map.png");
        assertThat(InProcess.run("compare", one, other, "--heatmap", map.toString()).exitCode()).isEqualTo(ExitCode.DIFFERENT);

        // log 3 / log 255 = 0.198: red 0.397, blue 0.603
        assertThat(Rendered.levels(Files.readAllBytes(map))).containsExactly(0, 0, 0, 101, 0, 154);
    }

    /** Of ten pixels two differ, by 3 and by 1 level. */
    @ParameterizedTest
    @CsvSource({"--tolerance 3, 0", "--tolerance 2, 1", "--tolerance 2 --pixels 0.1, 0", "--tolerance 2 --pixels 10%, 0",
        "--tolerance 2 --pixels 9.9%, 1", "--tolerance 1 --pixels 0.1, 0", "--tolerance 0 --pixels 0.1, 1", "--pixels 0.2, 0",
        "--pixels 2e-1, 0", "--pixels 0.19, 1", "--pixels 1, 0", "--pixels 100%, 0", "--tolerance 255, 0", "--pixels 0, 1", "--tolerance 0 --pixels 0, 1"})
    void asManyPixelsMayDifferByMoreThanSoManyLevelsAsTheShareSays(String options, int exitCode) throws IOException {
        String ten = write("ten.png", 10, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9);
        String near = write("near.png", 10, 0, 1, 2, 6, 4, 5, 6, 7, 8, 10);
        List<String> line = new ArrayList<>(List.of("compare", ten, near));
        line.addAll(List.of(options.split(" ")));

        Program.Result result = InProcess.run(line.toArray(new String[0]));

        assertThat(result.exitCode()).isEqualTo(exitCode);
        assertThat(result.text()).startsWith(ten + " and " + near + " are " + (exitCode == 0 ? "alike enough" : "different") + ": 10x1\n");
    }

    /** 29 of 100: the double nearest to 0.29 times 100 is below 29. */
    @Test
    void aShareIsTakenAsItIsWritten() throws IOException {
        int[] levels = new int[100];
        String hundred = write("hundred.png", 100, levels);
        Arrays.fill(levels, 0, 29, 9);
        String near = write("near.png", 100, levels);

        assertThat(InProcess.run("compare", hundred, near, "--pixels", "0.29").exitCode()).isZero();
        assertThat(InProcess.run("compare", hundred, near, "--pixels", "29%").exitCode()).isZero();
        assertThat(InProcess.run("compare", hundred, near, "--pixels", "28.999%").exitCode()).isEqualTo(1);
    }

    @Test
    void whatIsAllowedIsSaid() {
        assertThat(InProcess.run("compare", one, other, "--tolerance", "2", "--pixels", "50%").text()).endsWith(
            "allowed                50% of the pixels beyond 2 levels; these are 1\n");
        assertThat(InProcess.run("compare", one, other, "--tolerance", "3").text()).endsWith(
            "allowed                none of the pixels beyond 3 levels; these are 0\n");
        assertThat(InProcess.run("compare", one, other, "--tolerance", "2", "--pixels", "50%", "--format", "json").text()).endsWith(
            "\"beyondOneLevel\":1,\"pixels\":2,\"tolerance\":2,\"share\":0.50,\"beyondTolerance\":1,\"within\":true}\n");
    }

    @ParameterizedTest
    @CsvSource({"--tolerance, -1", "--tolerance, 256", "--tolerance, 1.5", "--tolerance, x", "--tolerance, 3%"})
    void aToleranceIsOneOfTheLevels(String option, String value) {
        assertEnds(ExitCode.USAGE, "", "simpleray compare: --tolerance must be 0 to 255, and is '" + value + "' (see simpleray compare --help)\n",
            "compare", one, other, option + '=' + value);
    }

    @ParameterizedTest
    @ValueSource(strings = {"-0.1", "1.1", "100.1%", "-1%", "%", "x", "NaN", "1e999", "0.5%%", "0x1p-1"})
    void aShareIsAPartOfTheWhole(String value) {
        assertEnds(ExitCode.USAGE, "", "simpleray compare: --pixels must be 0 to 1, or 0% to 100%, and is '" + value
            + "' (see simpleray compare --help)\n", "compare", one, other, "--pixels=" + value);
    }

    @Test
    void alphaIsAFourthLevel() throws IOException {
        String half = writeAlpha("half.png", 1, 1, 1, 0.5);
        String most = writeAlpha("most.png", 1, 1, 1, 0.75);
        String opaque = write("opaque.png", 1, 255);

        assertThat(InProcess.run("compare", half, half).text()).startsWith(half + " and " + half + " are the same: 1x1, with alpha\n");
        // 128 and 191: 63 levels of one channel in four
        assertThat(InProcess.run("compare", half, most).text()).startsWith(half + " and " + most + " are different: 1x1, with alpha\n"
            + "largest difference     63 levels\nRMSE                   31.500000 levels\n");
        assertThat(InProcess.run("compare", opaque, half).text()).startsWith(opaque + " and " + half + " are different: 1x1, with alpha ("
            + opaque + " has none: opaque)\nlargest difference     127 levels\n");
        assertThat(InProcess.run("compare", half, opaque, "--format", "json").text()).contains("\"height\":1,\"alpha\":true,\"maximum\":127,");
    }

    @Test
    void anOpaquePictureIsTheSameWithAndWithoutAlpha() throws IOException {
        assertThat(InProcess.run("compare", writeAlpha("alpha.png", 1, 1, 1, 1), write("plain.png", 1, 255)).exitCode()).isZero();
    }

    private String writeAlpha(String name, double... pixel) throws IOException {
        Picture picture = new Picture(1, 1, Picture.RGBA);
        picture.setRow(0, pixel);
        try (OutputStream out = Files.newOutputStream(folder.resolve(name))) {
            PngWriter.write(picture, out);
        }
        return folder.resolve(name).toString();
    }

    @Test
    void picturesOfDifferentSizesAre2AndBothAreTold() throws IOException {
        String wide = write("wide.png", 3, 1, 2, 3);

        assertEnds(2, "", "simpleray: " + one + " is 2x1, and " + wide + " is 3x1\n", "compare", one, wide);
    }

    @Test
    void whatCannotBeReadIs2() throws IOException {
        Path none = folder.resolve("none.png");
        Path text = Files.writeString(folder.resolve("text.png"), "no picture");

        assertEnds(2, "", "simpleray: " + none + ": no such file\n", "compare", one, none.toString());
        assertEnds(2, "", "simpleray: " + folder + ": is a folder\n", "compare", folder.toString(), one);
        assertEnds(2, "", "simpleray: " + text + ": is no PNG\n", "compare", one, text.toString());
        byte[] file = Files.readAllBytes(Path.of(one));
        file[file.length - 20]++;                             // in its last chunk of pixels
        Files.write(text, file);
        assertThat(InProcess.run("compare", one, text.toString()).err()).startsWith("simpleray: " + text + ": is ");
    }

    @Test
    void aHeatMapThatCannotBeMadeIs73AndOneOnAPictureIs2() {
        Path lost = folder.resolve("none").resolve("map.png");

        assertEnds(ExitCode.NO_OUTPUT, "", "simpleray: " + lost + ": cannot be created: there is no folder "
                + folder.resolve("none") + "\n",
            "compare", one, other, "--heatmap", lost.toString());
        assertEnds(ExitCode.USAGE, "", "simpleray compare: the output " + one + " is one of the pictures (see simpleray compare --help)\n",
            "compare", one, other, "--heatmap", one);
        assertThat(folder).isDirectoryNotContaining(file -> file.getFileName().toString().startsWith("."));
    }

    @Test
    void oneMayComeFromStandardInput() throws IOException {
        Program.Result result = InProcess.run(Files.newInputStream(Path.of(one)), new ByteArrayOutputStream(), "compare", "-", other);

        assertThat(result.err()).isEmpty();
        assertThat(result.exitCode()).isEqualTo(ExitCode.DIFFERENT);
    }
}
