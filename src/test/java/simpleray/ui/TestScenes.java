package simpleray.ui;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import java.util.concurrent.CountDownLatch;
import java.util.function.Consumer;
import java.util.function.Function;
import simpleray.image.Picture;
import simpleray.math.Ray;
import simpleray.render.RenderListener;
import simpleray.render.RenderRequest;
import simpleray.render.RenderSettings;
import simpleray.render.Renderer;
import simpleray.render.Stage;
import simpleray.scene.Scene;
import simpleray.scene.SceneFile;
import simpleray.scene.SimpleCamera;
import simpleray.ui.file.SceneSource;

/** Scenes for windows, and their pictures made without one. */
public final class TestScenes {
    public static final Path THESIS = Path.of(System.getProperty("simpleray.scenes"), "thesis.scene");
    public static final Path MIRRORS = Path.of(System.getProperty("simpleray.scenes"), "facing-mirrors.scene");

    private TestScenes() {
    }

    /** {@return what the screen should show: the levels of the picture that rendering without a window makes} */
    public static BufferedImage rendered(Path scene, int width, int height, Stage stage) {
        return rendered(scene, read -> new Renderer(read, new SimpleCamera(width, height), new RenderSettings().with(stage)));
    }

    /** {@return what the screen should show in the end of a request} */
    public static BufferedImage rendered(Path scene, RenderRequest request) {
        return rendered(scene, request::renderer);
    }

    private static BufferedImage rendered(Path scene, Function<Scene, Renderer> renderer) {
        try {
            return shown(renderer.apply(SceneFile.read(scene).scene()).render(RenderListener.NONE));
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    /** {@return the levels of a picture} */
    public static BufferedImage shown(Picture picture) {
        BufferedImage image = new BufferedImage(picture.width(), picture.height(), BufferedImage.TYPE_INT_RGB);
        for (int y = 0; y < picture.height(); y++) {
            byte[] levels = picture.levels(y);
            for (int x = 0; x < picture.width(); x++) {
                image.setRGB(x, y, (levels[3 * x] & 0xFF) << 16 | (levels[3 * x + 1] & 0xFF) << 8 | levels[3 * x + 2] & 0xFF);
            }
        }
        return image;
    }

    /** {@return whether two pictures of one size have the same pixels} */
    public static boolean sameAs(BufferedImage one, BufferedImage other) {
        return Screen.shows(one, 0, 0, other, 0, other.getHeight());
    }

    public static BufferedImage rendered(Path scene, int width, int height) {
        return rendered(scene, width, height, Stage.FINAL);
    }

    /** Writes a scene that is one colour all over. */
    public static Path plain(Path file, double red, double green, double blue) {
        return write(file, String.format(Locale.ROOT, "1%n1  0 0 1 -1  %s %s %s  0 0 0  0 0 0  0%n1 1 1%n0%n", red, green, blue));
    }

    public static Path write(Path file, String text) {
        try {
            return Files.write(file, text.getBytes(StandardCharsets.UTF_8));
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    /** {@return the scene with something that is told of every ray} Its picture is the same. */
    public static SceneSource watched(Path scene, Consumer<Ray> task) {
        return new SceneSource() {
            @Override
            public String name() {
                return scene.toString();
            }

            @Override
            public SceneFile read() throws IOException {
                SceneFile file = SceneFile.read(scene);
                Scene read = file.scene();
                int last = read.getNumberObjects();
                read.setNumberObjects(last + 1);
                read.setObject(last, new Watcher(task));
                return file;
            }
        };
    }

    /** {@return the thesis's scene, after something was done on the thread that reads it} */
    public static SceneSource read(Runnable before) {
        return new SceneSource() {
            @Override
            public String name() {
                return THESIS.toString();
            }

            @Override
            public SceneFile read() throws IOException {
                before.run();
                return SceneFile.read(THESIS);
            }
        };
    }

    /** {@return the scene, each ray of which takes its time: a picture of 200 by 200 takes many seconds} */
    public static SceneSource slow(Path scene) {
        return watched(scene, ray -> {
            long begin = System.nanoTime();
            while (System.nanoTime() - begin < 200_000) {
                Thread.onSpinWait();
            }
        });
    }

    /** Holds rays from the eye until it is opened: so mid-render is a state that stays. */
    public static final class Gate implements Consumer<Ray> {
        private final CountDownLatch open = new CountDownLatch(1);
        private final double below;
        private final int side;                               // of the picture; 0 to hold all its rays

        /** Holds rays whose direction has a y below this: 0 for the lower half of the picture. */
        public Gate(double below) {
            this(below, 0);
        }

        /** Holds of these rays only those of a square picture's last pass: coarse blocks of 2 by 2 pixels come through. */
        public Gate(double below, int side) {
            this.below = below;
            this.side = side;
        }

        @Override
        public void accept(Ray ray) {
            boolean fromTheEye = ray.origin.x == 0 && ray.origin.y == 0 && ray.origin.z == SimpleCamera.DEFAULT_COP;
            if (fromTheEye && ray.direction.y < below && (side == 0 || isOfLastPass(ray))) {
                try {
                    open.await();
                } catch (InterruptedException e) {
                    throw new IllegalStateException(e);
                }
            }
        }

        private boolean isOfLastPass(Ray ray) {
            double across = ray.direction.x / -ray.direction.z;   // -1 to 1, as the eye is as far away as the window is half wide
            double down = ray.direction.y / ray.direction.z;
            return ((int) ((across + 1) / 2 * side) | (int) ((down + 1) / 2 * side)) % 2 != 0;
        }

        public void open() {
            open.countDown();
        }
    }
}
