package simpleray.film;

import java.awt.image.BufferedImage;
import java.awt.image.IndexColorModel;
import java.awt.image.WritableRaster;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Path;
import java.util.List;
import javax.imageio.IIOImage;
import javax.imageio.ImageIO;
import javax.imageio.ImageTypeSpecifier;
import javax.imageio.ImageWriteParam;
import javax.imageio.ImageWriter;
import javax.imageio.metadata.IIOMetadata;
import javax.imageio.metadata.IIOMetadataNode;
import javax.imageio.stream.ImageOutputStream;
import javax.imageio.stream.MemoryCacheImageOutputStream;

/**
 * Writes a film as GIF, by ImageIO: all frames whole and with one {@link Palette}, shown for ever. A GIF counts in hundredths of a second, see
 * {@link FrameRate#hundredths}.
 */
public final class GifFilm {
    /** The longest that a frame is shown, in hundredths of a second. */
    private static final int MAX_DELAY = 65535;
    /** A frame that is shown for fewer hundredths is shown for ten by most programs. */
    private static final int MIN_DELAY = 2;
    /** Bytes for each pixel of a frame: as it is, once more while it is read, and its index. */
    private static final int PIXEL_BYTES = 4 + 4 + 1;
    private static final String FORMAT = "javax_imageio_gif_image_1.0";
    /** Netscape's block that says how often the film is shown: 1, and 0 times, which is without end. */
    private static final byte[] FOR_EVER = {1, 0, 0};

    private GifFilm() {
    }

    /**
     * Estimates the memory that writing takes.
     *
     * @param width a frame's width in pixels
     * @param height its height
     * @return the number of bytes
     */
    public static long bytesNeeded(int width, int height) {
        return (long) PIXEL_BYTES * width * height;
    }

    /**
     * Tells whether a GIF can have a rate.
     *
     * @param rate the rate
     * @return what most programs make of it; null if they show it as it is
     * @throws IllegalArgumentException if no GIF can have it
     */
    public static String note(FrameRate rate) {
        if (rate.hundredths(0) > MAX_DELAY) {
            throw new IllegalArgumentException("a GIF shows a frame for at most 655.35 s, and " + rate.fps() + " frames a second are fewer");
        }
        return rate.hundredths(0) >= MIN_DELAY && 100 / rate.fps() >= MIN_DELAY ? null
            : "most programs show at most 50 frames a second of a GIF, and this one has " + rate.fps();
    }

    /**
     * Writes a film. The stream is flushed and stays open.
     *
     * @param frames the frames' pictures, PNG files of one size
     * @param rate how many are shown a second
     * @param out where to write to
     * @throws IOException if a picture cannot be read, or the film not be written
     */
    public static void write(List<Path> frames, FrameRate rate, OutputStream out) throws IOException {
        Palette palette = new Palette();
        int[] pixels = null;
        for (Path frame : frames) {
            pixels = pixels(read(frame), pixels);
            palette.count(pixels);
        }
        IndexColorModel colours = palette.make();
        ImageWriter writer = ImageIO.getImageWritersByFormatName("gif").next();
        try (ImageOutputStream stream = new MemoryCacheImageOutputStream(out)) {
            writer.setOutput(stream);
            ImageWriteParam param = writer.getDefaultWriteParam();
            param.setProgressiveMode(ImageWriteParam.MODE_DISABLED);
            writer.prepareWriteSequence(null);
            for (int i = 0; i < frames.size(); i++) {
                BufferedImage image = read(frames.get(i));
                pixels = pixels(image, pixels);
                BufferedImage indexed = indexed(image.getWidth(), image.getHeight(), pixels, palette, colours);
                IIOMetadata told = writer.getDefaultImageMetadata(new ImageTypeSpecifier(indexed), param);
                told.mergeTree(FORMAT, metadata((int) rate.hundredths(i), colours.getTransparentPixel(), i == 0));
                writer.writeToSequence(new IIOImage(indexed, null, told), param);
                stream.flushBefore(stream.getStreamPosition());
            }
            writer.endWriteSequence();
        } finally {
            writer.dispose();
        }
        out.flush();
    }

    private static BufferedImage read(Path frame) throws IOException {
        return ImageIO.read(frame.toFile());
    }

    private static int[] pixels(BufferedImage image, int[] reused) {
        return image.getRGB(0, 0, image.getWidth(), image.getHeight(), reused, 0, image.getWidth());
    }

    private static BufferedImage indexed(int width, int height, int[] pixels, Palette palette, IndexColorModel colours) {
        BufferedImage image = new BufferedImage(width, height, BufferedImage.TYPE_BYTE_INDEXED, colours);
        WritableRaster raster = image.getRaster();
        int[] row = new int[width];
        for (int y = 0; y < height; y++) {
            for (int x = 0; x < width; x++) {
                row[x] = palette.index(pixels[y * width + x]);
            }
            raster.setSamples(0, y, width, 1, 0, row);
        }
        return image;
    }

    /** A frame with transparent pixels, whose index is not -1, is taken away before the next. */
    private static IIOMetadataNode metadata(int delay, int transparent, boolean first) {
        IIOMetadataNode control = new IIOMetadataNode("GraphicControlExtension");
        control.setAttribute("disposalMethod", transparent < 0 ? "none" : "restoreToBackgroundColor");
        control.setAttribute("userInputFlag", "FALSE");
        control.setAttribute("transparentColorFlag", transparent < 0 ? "FALSE" : "TRUE");
        control.setAttribute("transparentColorIndex", Integer.toString(Math.max(0, transparent)));
        control.setAttribute("delayTime", Integer.toString(delay));
        IIOMetadataNode root = new IIOMetadataNode(FORMAT);
        root.appendChild(control);
        if (first) {
            IIOMetadataNode netscape = new IIOMetadataNode("ApplicationExtension");
            netscape.setAttribute("applicationID", "NETSCAPE");
            netscape.setAttribute("authenticationCode", "2.0");
            netscape.setUserObject(FOR_EVER);
            IIOMetadataNode all = new IIOMetadataNode("ApplicationExtensions");
            all.appendChild(netscape);
            root.appendChild(all);
        }
        return root;
    }
}
