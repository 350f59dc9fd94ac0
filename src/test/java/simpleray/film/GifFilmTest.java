package simpleray.film;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import javax.imageio.ImageIO;
import javax.imageio.ImageReader;
import javax.imageio.metadata.IIOMetadataNode;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.w3c.dom.NodeList;
import simpleray.image.Picture;
import simpleray.image.png.PictureFile;

/** GIFs, read back by ImageIO. */
class GifFilmTest {
    private static final int WIDTH = 12;
    private static final int HEIGHT = 5;

    @TempDir
    Path folder;

    private List<Path> frames(int count) throws IOException {
        List<Path> files = new ArrayList<>();
        for (int i = 0; i < count; i++) {
            Picture picture = new Picture(WIDTH, HEIGHT);
            for (int y = 0; y < HEIGHT; y++) {
                double[] row = new double[3 * WIDTH];
                for (int x = 0; x < WIDTH; x++) {
                    row[3 * x + i % 3] = x == i ? 1 : y / 10.0;
                }
                picture.setRow(y, row);
            }
            Path file = folder.resolve(i + ".png");
            try (PictureFile png = new PictureFile(file)) {
                png.write(picture);
            }
            files.add(file);
        }
        return files;
    }

    private static ImageReader reader(byte[] gif) throws IOException {
        ImageReader reader = ImageIO.getImageReadersByFormatName("gif").next();
        reader.setInput(ImageIO.createImageInputStream(new ByteArrayInputStream(gif)));
        return reader;
    }

    private static byte[] written(List<Path> files, double fps) throws IOException {
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        GifFilm.write(files, new FrameRate(fps), out);
        return out.toByteArray();
    }

    private static List<IIOMetadataNode> nodes(ImageReader reader, int frame, String name) throws IOException {
        IIOMetadataNode root = (IIOMetadataNode) reader.getImageMetadata(frame).getAsTree("javax_imageio_gif_image_1.0");
        NodeList all = root.getElementsByTagName(name);
        List<IIOMetadataNode> nodes = new ArrayList<>();
        for (int i = 0; i < all.getLength(); i++) {
            nodes.add((IIOMetadataNode) all.item(i));
        }
        return nodes;
    }

    @Test
    void ofFewColoursEachFrameIsAsItWas() throws IOException {
        List<Path> files = frames(7);

        ImageReader reader = reader(written(files, 24));

        assertThat(reader.getNumImages(true)).isEqualTo(7);
        for (int i = 0; i < 7; i++) {
            BufferedImage expected = ImageIO.read(files.get(i).toFile());
            BufferedImage frame = reader.read(i);
            assertThat(frame.getRGB(0, 0, WIDTH, HEIGHT, null, 0, WIDTH)).isEqualTo(expected.getRGB(0, 0, WIDTH, HEIGHT, null, 0, WIDTH));
        }
    }

    @Test
    void theFilmHasItsRateForEver() throws IOException {
        ImageReader reader = reader(written(frames(7), 24));

        List<String> delays = new ArrayList<>();
        for (int i = 0; i < 7; i++) {
            IIOMetadataNode control = nodes(reader, i, "GraphicControlExtension").get(0);
            delays.add(control.getAttribute("delayTime"));
            assertThat(control.getAttribute("disposalMethod")).isEqualTo("none");
            assertThat(control.getAttribute("transparentColorFlag")).isEqualTo("FALSE");
            assertThat(nodes(reader, i, "LocalColorTable")).as("one palette for the film").isEmpty();
        }
        assertThat(delays).containsExactly("4", "4", "5", "4", "4", "4", "4");
        IIOMetadataNode loop = nodes(reader, 0, "ApplicationExtension").get(0);
        assertThat(loop.getAttribute("applicationID") + loop.getAttribute("authenticationCode")).isEqualTo("NETSCAPE2.0");
        assertThat((byte[]) loop.getUserObject()).containsExactly(1, 0, 0);
        assertThat(nodes(reader, 1, "ApplicationExtension")).isEmpty();
    }

    /** Each frame is taken away before the next, which would else be seen through. */
    @Test
    void transparentFramesTakeTheirPlace() throws IOException {
        List<Path> files = new ArrayList<>();
        for (int i = 0; i < 2; i++) {
            Picture picture = new Picture(2, 1, Picture.RGBA);
            picture.setRow(0, i == 0 ? new double[] {1, 0, 0, 0.75, 0, 0, 0, 0} : new double[] {0, 0, 0, 0.25, 0, 1, 0, 1});
            files.add(folder.resolve("alpha" + i + ".png"));
            try (PictureFile png = new PictureFile(files.get(i))) {
                png.write(picture);
            }
        }

        ImageReader reader = reader(written(files, 24));

        assertThat(reader.read(0).getRGB(0, 0, 2, 1, null, 0, 2)).containsExactly(0xFFFF0000, 0);
        assertThat(reader.read(1).getRGB(0, 0, 2, 1, null, 0, 2)).containsExactly(0, 0xFF00FF00);
        IIOMetadataNode control = nodes(reader, 0, "GraphicControlExtension").get(0);
        assertThat(control.getAttribute("disposalMethod")).isEqualTo("restoreToBackgroundColor");
        assertThat(control.getAttribute("transparentColorFlag")).isEqualTo("TRUE");
        assertThat(control.getAttribute("transparentColorIndex")).isEqualTo("2");
    }

    @Test
    void aFilmOfOneFrameIsAGifToo() throws IOException {
        assertThat(reader(written(frames(1), 24)).getNumImages(true)).isEqualTo(1);
    }

    @Test
    void aRateThatFewProgramsShowIsNoted() {
        assertThat(GifFilm.note(new FrameRate(50))).isNull();
        assertThat(GifFilm.note(new FrameRate(60))).isEqualTo("most programs show at most 50 frames a second of a GIF, and this one has 60.0");
        assertThat(GifFilm.note(new FrameRate(51))).isNotNull();
    }

    @Test
    void aFrameThatIsShownForTooLongIsRefused() {
        assertThat(GifFilm.note(new FrameRate(100 / 65535.0))).isNull();
        assertThatThrownBy(() -> GifFilm.note(new FrameRate(0.00152))).isInstanceOf(IllegalArgumentException.class)
            .hasMessage("a GIF shows a frame for at most 655.35 s, and 0.00152 frames a second are fewer");
    }

    @Test
    void thirtyTwoBitsAndTheIndexAreHeldForEachPixel() {
        assertThat(GifFilm.bytesNeeded(100, 10)).isEqualTo(9000);
    }
}
