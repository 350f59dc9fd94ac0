package simpleray;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.zip.CRC32;
import simpleray.image.Picture;
import simpleray.render.Accel;
import simpleray.render.RenderListener;
import simpleray.render.RenderSettings;
import simpleray.render.Renderer;
import simpleray.render.Stage;
import simpleray.scene.Scene;
import simpleray.scene.SimpleCamera;

/** Renders random scenes by the engine and by the loop over all objects. Also a program, for another Java to run. */
public final class RandomPictures {
    private static final int[] THREADS = {1, 2, 3, 7};
    private static final int SIDE = 6;
    private static final int DEPTH = 3;

    private RandomPictures() {
    }

    /**
     * Prints the sum over the pictures.
     *
     * @param args the seed and the number of scenes
     * @throws IOException if no file can be written
     */
    public static void main(String[] args) throws IOException {
        Path folder = Files.createTempDirectory("random-pictures");
        try {
            long[] sums = sums(Long.parseLong(args[0]), Integer.parseInt(args[1]), folder);
            System.out.println(sums[sums.length - 1]);
        } finally {
            try (var files = Files.list(folder)) {
                for (Path file : files.toList()) {
                    Files.delete(file);
                }
            }
            Files.delete(folder);
        }
    }

    /**
     * Renders so many scenes, and fails if a picture differs by the way it is rendered, or holds what is no number.
     *
     * @return after each picture, the sum over all until then
     */
    static long[] sums(long seed, int count, Path folder) {
        RandomScenes scenes = new RandomScenes(seed, folder);
        CRC32 sum = new CRC32();
        long[] sums = new long[count];
        for (int i = 0; i < count; i++) {
            String which = "seed " + seed + ", scene " + i;
            Scene scene = scenes.next(i % 20 == 0 ? 40 : 12);
            int samples = i % 5 == 0 ? RenderSettings.ADAPTIVE : 1 + i % 2;
            Picture plain = render(scene, new RenderSettings(Stage.FINAL, DEPTH, samples, Accel.NONE, 1, null));
            Picture fast = render(scene, new RenderSettings(Stage.FINAL, DEPTH, samples, Accel.AUTO, THREADS[i % THREADS.length], null));
            for (int y = 0; y < SIDE; y++) {
                double[] row = plain.row(y);
                if (!Arrays.equals(row, fast.row(y))) {
                    throw new AssertionError(which + ", row " + y + ": " + Arrays.toString(row) + " and " + Arrays.toString(fast.row(y)));
                }
                if (Arrays.stream(row).anyMatch(Double::isNaN)) {
                    throw new AssertionError(which + ", row " + y + ": no number in " + Arrays.toString(row));
                }
                sum.update(plain.levels(y));
            }
            sums[i] = sum.getValue();
        }
        return sums;
    }

    private static Picture render(Scene scene, RenderSettings settings) {
        return new Renderer(scene, new SimpleCamera(SIDE, SIDE), settings).render(RenderListener.NONE);
    }
}
