package simpleray;

import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import javax.imageio.ImageIO;
import simpleray.image.png.PngWriter;
import simpleray.render.RenderListener;
import simpleray.render.RenderSettings;
import simpleray.render.Renderer;
import simpleray.render.Stage;
import simpleray.scene.Scene;
import simpleray.scene.SceneFile;
import simpleray.scene.SimpleCamera;

/** Pictures, made by the program's classes without its command line, and looked at by other means than the program's own. */
public final class Rendered {
    private static final int SIGNATURE = 8;

    private Rendered() {
    }

    /** {@return the PNG file of a scene} */
    public static byte[] png(Scene scene, SimpleCamera camera, RenderSettings settings) throws IOException {
        return png(new Renderer(scene, camera, settings));
    }

    /** {@return the PNG file that a renderer makes} */
    public static byte[] png(Renderer renderer) throws IOException {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        PngWriter.write(renderer.render(RenderListener.NONE), bytes);
        return bytes.toByteArray();
    }

    /** {@return the PNG file of a scene file, as of a camera and settings} */
    public static byte[] png(Path scene, SimpleCamera camera, RenderSettings settings) throws IOException {
        return png(SceneFile.read(scene).scene(), camera, settings);
    }

    /** {@return settings that are the defaults but for the stage} */
    public static RenderSettings stage(Stage stage) {
        return new RenderSettings().with(stage);
    }

    /** {@return the scene that a text describes} */
    static Scene scene(String text) throws IOException {
        return SceneFile.read(new ByteArrayInputStream(text.getBytes(StandardCharsets.UTF_8))).scene();
    }

    /** {@return a PNG file without the texts that it carries} */
    public static byte[] untold(byte[] png) {
        ByteArrayOutputStream left = new ByteArrayOutputStream();
        left.write(png, 0, SIGNATURE);
        for (int at = SIGNATURE; at < png.length;) {
            int length = ByteBuffer.wrap(png, at, Integer.BYTES).getInt() + 3 * Integer.BYTES;   // with itself, the name and the sum
            if (!new String(png, at + Integer.BYTES, Integer.BYTES, StandardCharsets.US_ASCII).equals("iTXt")) {
                left.write(png, at, length);
            }
            at += length;
        }
        return left.toByteArray();
    }

    /** {@return the picture in a PNG file} */
    public static BufferedImage decoded(byte[] png) throws IOException {
        BufferedImage image = ImageIO.read(new ByteArrayInputStream(png));
        if (image == null) {
            throw new IOException("these " + png.length + " bytes are no picture");
        }
        return image;
    }

    /** {@return red, green and blue of each pixel of a PNG file, 0 to 255 each, row after row} */
    public static int[] levels(byte[] png) throws IOException {
        BufferedImage image = decoded(png);
        return image.getRaster().getPixels(0, 0, image.getWidth(), image.getHeight(), (int[]) null);
    }
}
