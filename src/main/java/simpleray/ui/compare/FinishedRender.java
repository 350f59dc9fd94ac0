package simpleray.ui.compare;

import java.awt.image.BufferedImage;
import java.io.File;
import java.lang.ref.SoftReference;
import java.nio.file.Path;
import java.time.LocalTime;
import java.time.format.DateTimeFormatter;
import java.util.List;
import simpleray.image.Picture;
import simpleray.render.Progress;
import simpleray.render.RenderRequest;
import simpleray.ui.file.SceneSource;
import simpleray.ui.picture.CommandWords;
import simpleray.ui.widget.Chequers;

/**
 * A finished picture with its request and its time. <em>Constant</em>, except that the garbage collector takes the pixels when memory is
 * short.
 */
final class FinishedRender {
    private static final DateTimeFormatter CLOCK = DateTimeFormatter.ofPattern("HH:mm:ss");
    private static final int LEVELS = 0xFFFFFF;

    private final SceneSource source;
    private final RenderRequest request;
    private final int width;
    private final int height;
    private final String label;
    private final Histogram histogram = new Histogram();
    private final SoftReference<int[]> pixels;
    private SoftReference<BufferedImage> marks = new SoftReference<>(null);

    /** Looks at every pixel of a picture, all rows of which are set; not for the event thread. */
    FinishedRender(Picture picture, SceneSource source, RenderRequest request, double seconds, LocalTime time) {
        this.source = source;
        this.request = request;
        width = picture.width();
        height = picture.height();
        label = request.stage() + ", " + new File(source.name()).getName() + ", " + width + " \u00D7 " + height + ", "
            + Progress.time(seconds) + ", at " + CLOCK.format(time);
        pixels = new SoftReference<>(packed(picture));
    }

    private int[] packed(Picture picture) {
        int[] packed = new int[Math.multiplyExact(width, height)];
        for (int y = 0; y < height; y++) {
            double[] light = picture.row(y);
            int[] argb = Picture.packed(picture.levels(y), picture.channels());
            for (int x = 0; x < width; x++) {
                int i = picture.channels() * x;
                if (!picture.hasAlpha() || light[i + Picture.RGB] > 0) {
                    histogram.add(light[i], light[i + 1], light[i + 2]);
                }
                int rgb = picture.hasAlpha() ? Chequers.over(argb[x], x, y) : argb[x] & LEVELS;
                packed[y * width + x] = Clipped.flags(light[i], light[i + 1], light[i + 2]) | rgb;
            }
        }
        return packed;
    }

    /** {@return whether a picture is small enough to be kept} */
    static boolean canKeep(Picture picture) {
        return (long) picture.width() * picture.height() <= Integer.MAX_VALUE / 2;
    }

    /** {@return its pixels, packed, with the flags of {@link Clipped}; null if they are gone} */
    int[] pixels() {
        return pixels.get();
    }

    /** {@return the marks of its clipped pixels, to be painted over it; null if the pixels are gone} Not for the event thread at first. */
    synchronized BufferedImage marks() {
        BufferedImage made = marks.get();
        int[] packed = pixels();
        if (made == null && packed != null) {
            made = Clipped.marks(packed, width, height);
            marks = new SoftReference<>(made);
        }
        return made;
    }

    /** Drops the pixels, as the garbage collector does when memory is short. */
    void drop() {
        pixels.clear();
    }

    /** {@return the memory of the pixels} */
    long bytes() {
        return (long) Integer.BYTES * width * height;
    }

    int width() {
        return width;
    }

    int height() {
        return height;
    }

    Histogram histogram() {
        return histogram;
    }

    /** {@return the request as options of the command line} */
    String options() {
        List<String> words = CommandWords.render(Path.of(""), "", request);
        return source.name() + " " + String.join(" ", words.subList(4, words.size()));
    }

    /** {@return its stage, scene, size, duration and time} */
    @Override
    public String toString() {
        return label;
    }
}
