package simpleray;

import static org.assertj.core.api.Assertions.fail;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import javax.imageio.ImageIO;

/** How far two pictures differ. A pixel differs if one of its levels does by more than {@link #LEVELS}. <em>Constant.</em> */
final class PictureComparison {
    /** By how much a level may be off. */
    static final int LEVELS = 1;
    /** The share of pixels that may differ, for seams where two surfaces are hit at the same distance. */
    static final double SHARE = 0.002;
    /** What the differences are multiplied by in the picture of them. */
    private static final int MAGNIFIED = 16;
    private static final int[] SHIFTS = {24, 16, 8, 0};            // of alpha, red, green and blue

    private final BufferedImage difference;
    private final int differing;
    private final int pixels;

    private PictureComparison(BufferedImage difference, int differing, int pixels) {
        this.difference = difference;
        this.differing = differing;
        this.pixels = pixels;
    }

    /** Compares two pictures of the same size. */
    static PictureComparison of(BufferedImage expected, BufferedImage actual) {
        int width = expected.getWidth();
        int height = expected.getHeight();
        BufferedImage difference = new BufferedImage(width, height, BufferedImage.TYPE_INT_RGB);
        int differing = 0;
        for (int y = 0; y < height; y++) {
            for (int x = 0; x < width; x++) {
                int most = 0;
                int shown = 0;
                for (int shift : SHIFTS) {
                    int by = Math.abs((expected.getRGB(x, y) >> shift & 0xFF) - (actual.getRGB(x, y) >> shift & 0xFF));
                    most = Math.max(most, by);
                    shown |= Math.min(255, MAGNIFIED * by) << shift;
                }
                differing += most > LEVELS ? 1 : 0;
                difference.setRGB(x, y, shown);
            }
        }
        return new PictureComparison(difference, differing, width * height);
    }

    /** {@return whether so few pixels differ that it may be for seams} */
    boolean isClose() {
        return differing <= SHARE * pixels;
    }

    /**
     * Fails if the pictures differ in more than seams; then leaves the actual picture and one of the differences, sixteen times as bright.
     *
     * @param name the picture's name
     * @param expected the picture as it should be
     * @param png the PNG file as it is
     * @param failures the folder to leave pictures in
     */
    static void assertClose(String name, BufferedImage expected, byte[] png, Path failures) throws IOException {
        BufferedImage actual = Rendered.decoded(png);
        boolean sameSize = actual.getWidth() == expected.getWidth() && actual.getHeight() == expected.getHeight();
        PictureComparison comparison = sameSize ? of(expected, actual) : null;
        if (sameSize && comparison.isClose()) {
            return;
        }
        Files.createDirectories(failures);
        Path left = failures.resolve(name + "-actual.png");
        Files.write(left, png);
        if (!sameSize) {
            fail("%s is %dx%d and should be %dx%d: see %s", name, actual.getWidth(), actual.getHeight(), expected.getWidth(),
                expected.getHeight(), left);
        }
        Path differences = failures.resolve(name + "-difference.png");
        ImageIO.write(comparison.difference, "png", differences.toFile());
        fail("%s differs from what it should be in %d of %d pixels by more than %d level: see %s and %s", name, comparison.differing,
            comparison.pixels, LEVELS, left, differences);
    }
}
