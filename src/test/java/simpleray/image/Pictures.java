package simpleray.image;

import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.util.Arrays;
import java.util.Random;
import javax.imageio.ImageIO;
import simpleray.image.png.PngWriter;

/** Pictures to be written, and a look at what was written. */
public final class Pictures {
    private Pictures() {
    }

    /** {@return a picture of random levels, which no compression makes smaller} */
    public static Picture noise(int width, int height, long seed) {
        Random random = new Random(seed);
        Picture picture = new Picture(width, height);
        for (int y = 0; y < height; y++) {
            picture.setRow(y, random.doubles(3L * width).toArray());
        }
        return picture;
    }

    /** {@return a picture of random levels with random alpha, each pixel at least a little opaque} */
    public static Picture alphaNoise(int width, int height, long seed) {
        Random random = new Random(seed);
        Picture picture = new Picture(width, height, Picture.RGBA);
        for (int y = 0; y < height; y++) {
            picture.setRow(y, random.doubles(4L * width, 0.01, 1).toArray());
        }
        return picture;
    }

    /** {@return a picture of one colour} */
    public static Picture plain(int width, int height, double light) {
        Picture picture = new Picture(width, height);
        for (int y = 0; y < height; y++) {
            double[] row = new double[3 * width];
            Arrays.fill(row, light);
            picture.setRow(y, row);
        }
        return picture;
    }

    /** {@return the picture as PNG} */
    public static byte[] png(Picture picture) throws IOException {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        PngWriter.write(picture, bytes);
        return bytes.toByteArray();
    }

    /** {@return the levels of each pixel of an image file, row after row} */
    public static int[][] decoded(byte[] file) throws IOException {
        BufferedImage image = ImageIO.read(new ByteArrayInputStream(file));
        int[][] rows = new int[image.getHeight()][];
        for (int y = 0; y < rows.length; y++) {
            rows[y] = image.getRaster().getPixels(0, y, image.getWidth(), 1, (int[]) null);
        }
        return rows;
    }

    /** {@return the levels that the picture's file should have} */
    public static int[][] expected(Picture picture) {
        int[][] rows = new int[picture.height()][];
        for (int y = 0; y < rows.length; y++) {
            byte[] levels = picture.levels(y);
            rows[y] = new int[levels.length];
            for (int i = 0; i < levels.length; i++) {
                rows[y][i] = levels[i] & 0xFF;
            }
        }
        return rows;
    }
}
