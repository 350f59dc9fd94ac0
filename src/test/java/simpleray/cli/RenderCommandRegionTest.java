package simpleray.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import simpleray.Project;
import simpleray.Rendered;

/** {@code --region}: a piece of the picture, and the same pixels. */
class RenderCommandRegionTest {
    private static final String THESIS = Project.scene("thesis").toString();

    @TempDir
    Path folder;

    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {"17,9,30,21 | 1", "17,9,30,21 | 3", "17,9,30,21 | adaptive", "0,0,1,1 | adaptive", "63,47,1,1 | 2",
        "0,0,64,48 | adaptive", "5,0,59,48 | adaptive", "0,40,64,8 | 1"})
    void itIsCutOutOfTheWholePicture(String region, String samples) throws IOException {
        BufferedImage whole = Rendered.decoded(picture("--samples", samples));
        int[] r = List.of(region.split(",")).stream().mapToInt(Integer::parseInt).toArray();
        byte[] piece = picture("--samples", samples, "--region", region, "--threads", "1");

        BufferedImage decoded = Rendered.decoded(piece);
        assertThat(levels(decoded, 0, 0, decoded.getWidth(), decoded.getHeight())).isEqualTo(levels(whole, r[0], r[1], r[2], r[3]));
        assertThat(picture("--samples", samples, "--region", region, "--threads", "3")).isEqualTo(piece);
    }

    @Test
    void aSceneFilesResolutionIsThatOfTheWhole() throws IOException {
        Path small = folder.resolve("small.scene");
        Files.writeString(small, Files.readString(Path.of(THESIS)) + "\nresolution 32 24\n");

        assertThat(Rendered.decoded(picture(small.toString(), "--region", "4,5,20,10"))).extracting(BufferedImage::getWidth,
            BufferedImage::getHeight).containsExactly(20, 10);
        assertThat(refused(small.toString(), "13,0,20,24")).isEqualTo("simpleray render: the region 13,0,20,24 is not inside the picture "
            + "of 32x24 (see simpleray render --help)\n");
    }

    @ParameterizedTest
    @ValueSource(strings = {"200,0,1,1", "0,200,1,1", "150,150,51,50", "150,150,50,51", "1,1,2147483647,2147483647"})
    void whereThePictureHasNoSuchPieceThatIsSaidAndNoFileIsLeft(String region) {
        assertThat(refused(THESIS, region)).isEqualTo("simpleray render: the region " + region
            + " is not inside the picture of 200x200 (see simpleray render --help)\n");
        assertThat(folder.resolve("piece.png")).doesNotExist();
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {
        "1,2,3 | expected four whole numbers such as 100,50,64,48, found '1,2,3'",
        "1,2,3,4,5 | expected four whole numbers such as 100,50,64,48, found '1,2,3,4,5'",
        "1,2,3,half | expected four whole numbers such as 100,50,64,48, found '1,2,3,half'",
        "1,2,0,4 | a region begins at 0 or more and is 1 pixel wide and high or more, and is 1,2,0,4",
        "1,-2,3,4 | a region begins at 0 or more and is 1 pixel wide and high or more, and is 1,-2,3,4"})
    void whatIsNoRegionIsWrongUsage(String region, String message) {
        assertThat(refused(THESIS, region)).isEqualTo("simpleray render: Invalid value for option '--region': " + message
            + " (see simpleray render --help)\n");
    }

    private String refused(String scene, String region) {
        Program.Result result = InProcess.run("render", scene, "-o", folder.resolve("piece.png").toString(), "--region", region);

        assertThat(result.exitCode()).isEqualTo(ExitCode.USAGE);
        return result.err();
    }

    private byte[] picture(String... options) throws IOException {
        List<String> line = new ArrayList<>(List.of("render", "-q", "-o", folder.resolve("piece.png").toString()));
        if (options[0].startsWith("--")) {
            line.addAll(List.of(THESIS, "--size", "64x48"));
        }
        line.addAll(List.of(options));
        Program.Result result = InProcess.run(line.toArray(new String[0]));

        assertThat(result.err()).isEmpty();
        assertThat(result.exitCode()).isZero();
        return Files.readAllBytes(folder.resolve("piece.png"));
    }

    private static int[] levels(BufferedImage image, int x, int y, int width, int height) {
        return image.getRaster().getPixels(x, y, width, height, (int[]) null);
    }
}
