package simpleray.ui.picture;

import java.awt.image.BufferedImage;
import java.util.concurrent.CancellationException;
import java.util.concurrent.ExecutorService;
import javax.swing.SwingUtilities;
import simpleray.render.Explainer;
import simpleray.scene.RayTree;

/**
 * Lights up an object in the picture by its outline, so that its colours stay as they are. It finds on a thread of its own which pixels
 * show it. For the event thread.
 */
public final class ObjectOutline {
    /** The most pixels that are asked for their object; in a larger picture each stands for some. */
    private static final int MAX_ASKED = 400_000;
    private static final int EDGE = 0xFFFFC800;

    private final ViewerContext window;
    private final ExecutorService worker;
    private int wanted;                                       // the object's number; 0 for none
    private volatile RenderJob asked;                                  // whose pixels are known or asked for
    private Pixels known;                                     // of that rendering; null until they are there
    private int painted;                                      // the number that is lit up in these pixels; 0 for none

    /** The object of each pixel, or of squares of them. */
    private record Pixels(int width, int height, int square, int columns, int[] objects) {
        int at(int x, int y) {
            return objects[y / square * columns + x / square];
        }
    }

    /**
     * Creates one that lights up nothing.
     *
     * @param window the window
     */
    public ObjectOutline(ViewerContext window) {
        this.window = window;                                 // it has no picture yet
        worker = window.workers().stopping("simpleray-outline");
    }

    /**
     * Lights up another object.
     *
     * @param number the object's number, from 1; 0 for none
     */
    public void show(int number) {
        if (number != wanted) {
            wanted = number;
            update(window.picture().job());
        }
    }

    /**
     * Takes notice of a rendering, whose picture may have the object elsewhere.
     *
     * @param job the rendering
     */
    public void update(RenderJob job) {
        boolean there = job != null && job.snapshot().picture() != null && job.snapshot().progress().finished() > 0;
        boolean hides = wanted == 0 || !there || job != asked;
        if (hides ? painted != 0 : known != null && painted != wanted) {
            painted = hides ? 0 : wanted;
            window.picture().setLit(hides ? null : image(known));
        }
        if (wanted != 0 && there && job != asked) {
            asked = job;
            known = null;
            worker.execute(() -> find(job));
        }
    }

    private void find(RenderJob job) {
        Pixels found;
        try {
            found = pixels(job);
        } catch (CancellationException e) {                   // another rendering has begun
            return;
        }
        SwingUtilities.invokeLater(() -> {
            if (job == asked) {
                known = found;
                update(job);
            }
        });
    }

    private Pixels pixels(RenderJob job) {
        Explainer explainer = job.snapshot().explainer();
        if (explainer == null) {
            throw new CancellationException();
        }
        int width = explainer.width();
        int height = explainer.height();
        int square = (int) Math.ceil(Math.sqrt(Math.max(1, (double) width * height / MAX_ASKED)));
        int columns = (width + square - 1) / square;
        int rows = (height + square - 1) / square;
        int[] objects = new int[columns * rows];
        for (int i = 0; i < objects.length; i++) {
            if (asked != job || Thread.interrupted()) {
                throw new CancellationException();
            }
            int x = Math.min(width - 1, i % columns * square + square / 2);
            int y = Math.min(height - 1, i / columns * square + square / 2);
            RayTree.Thing thing = explainer.objectAt(x, y);
            objects[i] = thing == null ? 0 : thing.number();
        }
        return new Pixels(width, height, square, columns, objects);
    }

    private BufferedImage image(Pixels pixels) {
        BufferedImage image = new BufferedImage(pixels.width, pixels.height, BufferedImage.TYPE_INT_ARGB);
        for (int y = 0; y < pixels.height; y++) {
            for (int x = 0; x < pixels.width; x++) {
                if (pixels.at(x, y) == wanted && isEdge(pixels, x, y)) {
                    image.setRGB(x, y, EDGE);
                }
            }
        }
        return image;
    }

    private boolean isEdge(Pixels pixels, int x, int y) {
        int by = Math.max(pixels.square, 2);
        return x < by || y < by || x >= pixels.width - by || y >= pixels.height - by
            || pixels.at(x - by, y) != wanted || pixels.at(x + by, y) != wanted
            || pixels.at(x, y - by) != wanted || pixels.at(x, y + by) != wanted;
    }
}
