package simpleray.rays;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CancellationException;
import java.util.stream.IntStream;
import simpleray.image.Picture;
import simpleray.math.Point;
import simpleray.math.Ray;
import simpleray.render.Accel;
import simpleray.render.PreparedScene;
import simpleray.render.RenderSettings;
import simpleray.render.Stage;
import simpleray.scene.Hit;
import simpleray.scene.Intersector;
import simpleray.scene.Object;
import simpleray.scene.PerspectiveCamera;
import simpleray.scene.PerspectiveCamera.Pose;
import simpleray.scene.Plane;
import simpleray.scene.RayStats;
import simpleray.scene.Scene;
import simpleray.trace.CompiledScene;

/**
 * A scene that is seen from outside again and again. It is compiled anew only when other planes are left out than before. <em>Mutable</em>:
 * one thread's own. The scene must not change meanwhile.
 */
public final class OutsideScene {
    private final Scene scene;
    private final int threads = Runtime.getRuntime().availableProcessors();
    private List<Object> kept;                                // the objects of the prepared scene; null before the first view
    private PreparedScene prepared;
    private Scene opened;

    /**
     * Takes a scene.
     *
     * @param scene the scene
     */
    public OutsideScene(Scene scene) {
        this.scene = scene;
    }

    /**
     * Renders a view.
     *
     * @param inside the scene's own eye
     * @param pose the camera outside
     * @param width the width, 1 or more
     * @param height the height, 1 or more
     * @param density the number of pixels along each side of a square of width and height 1: below 1 for speed, 2 for a fine screen
     * @param stage {@link Stage#FINAL}, or a simpler one for speed
     * @param samples the number of samples along each side of a pixel
     * @return the view
     * @throws CancellationException if the calling thread was interrupted
     */
    public OutsideView view(Point inside, Pose pose, int width, int height, double density, Stage stage, int samples) {
        open(inside, new Point(pose.ex(), pose.ey(), pose.ez()));
        PerspectiveCamera camera = new PerspectiveCamera(pose, pixels(width, density), pixels(height, density));
        RenderSettings settings = new RenderSettings(stage, 2, samples, Accel.AUTO, threads, null);
        Picture picture = prepared.renderer(camera, settings).render(row -> { });
        return new OutsideView(new PerspectiveCamera(pose, width, height), OutsideView.faded(picture), distances(camera));
    }

    private static int pixels(int length, double density) {
        return (int) Math.max(1, Math.round(length * density));
    }

    private void open(Point inside, Point outside) {
        List<Object> wanted = new ArrayList<>();
        for (int i = 0; i < scene.getNumberObjects(); i++) {
            Object object = scene.getObject(i);
            boolean between = object instanceof Plane plane
                && (plane.normal.dot(inside) - plane.constant) * (plane.normal.dot(outside) - plane.constant) < 0;
            if (!between) {
                wanted.add(object);
            }
        }
        if (!wanted.equals(kept)) {
            kept = wanted;
            opened = scene.with(wanted);
            prepared = new PreparedScene(opened);
        }
    }

    /** {@return the objects that are seen} */
    int numberObjects() {
        return kept.size();
    }

    /** {@return the scene as it is compiled now, which stays the same as long as the same planes are left out} */
    Scene opened() {
        return opened;
    }

    /** {@return the distance of each pixel's surface from the eye; infinite if there is none} */
    private double[] distances(PerspectiveCamera camera) {
        int width = camera.width();
        double[] distances = new double[width * camera.height()];
        CompiledScene compiled = prepared.compiled(opened, camera.eye(),
            () -> new CompiledScene(opened, camera.eye(), threads, distances.length));
        Thread caller = Thread.currentThread();
        IntStream.range(0, camera.height()).parallel().filter(y -> !caller.isInterrupted()).forEach(y -> {
            Intersector intersector = compiled.intersector(new RayStats());
            Hit hit = new Hit();
            Ray ray = new Ray();
            for (int x = 0; x < width; x++) {
                camera.through(x + 0.5, y + 0.5, ray);
                distances[y * width + x] = intersector.intersect(ray, hit) ? hit.t : Double.POSITIVE_INFINITY;
            }
        });
        if (caller.isInterrupted()) {
            throw new CancellationException("the view was cancelled");
        }
        return distances;
    }
}
