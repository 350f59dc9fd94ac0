package simpleray.render;

import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.OptionalDouble;
import simpleray.image.Picture;
import simpleray.math.Colour;
import simpleray.math.Ray;
import simpleray.scene.Camera;
import simpleray.scene.Hit;
import simpleray.scene.Integrator;
import simpleray.scene.Intersector;
import simpleray.scene.RayStats;
import simpleray.scene.RayTree;
import simpleray.scene.RayTreeRecorder;
import simpleray.scene.Scene;
import simpleray.scene.WhittedIntegrator;
import simpleray.trace.CompiledScene;

/** Explains single pixels of a picture. <em>Mutable</em>: one thread's own. The scene and the camera must not change meanwhile. */
public final class Explainer {
    private final Scene scene;
    private final Camera camera;
    private final RenderSettings settings;
    private final Intersector intersector;
    private final Integrator integrator;
    private final RayStats uncounted = new RayStats();
    private final Hit hit = new Hit();
    private final Sampler sampler;

    /** Creates an explainer. If the compiled scene is null, it is compiled here, unless the settings say {@link Accel#NONE}. */
    Explainer(Scene scene, Camera camera, RenderSettings settings, CompiledScene compiled) {
        this.scene = scene;
        this.camera = camera;
        this.settings = settings;
        CompiledScene ready = compiled != null || settings.accel() == Accel.NONE ? compiled
            : new CompiledScene(scene, camera.eye(), settings.threads(), 1);
        intersector = Tracer.intersector(scene, ready, uncounted);
        integrator = Tracer.integrator(scene, intersector, settings.stage(), uncounted);
        Tracer tracer = new Tracer(integrator, camera, settings, scene.settings.isTransparent());
        sampler = settings.samples() != RenderSettings.ADAPTIVE ? new GridSampler(tracer, settings.samples())
            : new AdaptiveSampler(tracer, camera.width(), camera.height(), scene.settings.isTransparent() ? Picture.RGBA : Picture.RGB,
                Region.whole(camera.width(), camera.height()), AdaptiveSampler.rows(1, 1));
    }

    /** {@return the width of the picture in pixels} */
    public int width() {
        return camera.width();
    }

    /** {@return the height of the picture in pixels} */
    public int height() {
        return camera.height();
    }

    /**
     * Finds the object that the ray through a pixel's centre hits.
     *
     * @param x the column, 0 at the left
     * @param y the row, 0 at the top
     * @return the object; null if nothing is hit
     */
    public RayTree.Thing objectAt(int x, int y) {
        boolean hits = intersector.intersect(camera.through(x + 0.5, y + 0.5), hit);
        return hits ? RayTreeRecorder.object(scene, hit) : null;
    }

    /**
     * Explains why a pixel has its colour.
     *
     * @param x the column, 0 at the left
     * @param y the row, 0 at the top
     * @return its story, whose colour is that of the picture to the last bit
     * @throws IndexOutOfBoundsException if there is no such pixel
     * @throws java.util.concurrent.CancellationException if the calling thread is interrupted
     */
    public PixelStory story(int x, int y) {
        return story(x, y, false);
    }

    /**
     * Explains why a pixel has its colour, as {@link #story(int, int)}.
     *
     * @param x the column, 0 at the left
     * @param y the row, 0 at the top
     * @param points whether each point of an area light is told, and not only their sum
     * @return its story, whose colour is that of the picture to the last bit
     * @throws IndexOutOfBoundsException if there is no such pixel
     * @throws java.util.concurrent.CancellationException if the calling thread is interrupted
     */
    public PixelStory story(int x, int y, boolean points) {
        Objects.checkIndex(x, camera.width());
        Objects.checkIndex(y, camera.height());
        RayTreeRecorder recorder = new RayTreeRecorder(scene, points);
        Integrator recorded = new WhittedIntegrator(scene, intersector, settings.stage().terms(), uncounted, recorder);
        double[] places = sampler.points(x, y);
        boolean clamped = settings.samples() != 1;
        List<PixelStory.Sample> samples = new ArrayList<>();
        Colour colour = new Colour();
        int count = 0;
        for (int i = 0; i < places.length; i += 2) {
            Ray ray = camera.through(places[i], places[i + 1]);
            Colour seen = new Colour();
            boolean counts = recorded.trace(ray, seen, settings.depth()) || !scene.settings.isTransparent();
            count += counts ? 1 : 0;
            if (settings.stage().isView()) {
                integrator.trace(ray, seen, settings.depth());
            }
            if (clamped) {
                seen.clamp();
            }
            colour.add(seen);
            samples.add(new PixelStory.Sample(places[i], places[i + 1], clamped, counts, seen, recorder.tree()));
        }
        boolean mean = samples.size() > 1;
        double share = mean ? Sampler.mean(colour, count, samples.size()) : count;
        return new PixelStory(x, y, camera.width(), camera.height(), settings.stage(), mean, List.copyOf(samples), colour,
            scene.settings.isTransparent() ? OptionalDouble.of(share) : OptionalDouble.empty());
    }
}
