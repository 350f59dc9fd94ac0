package simpleray.cli;

import java.io.IOException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.TreeSet;
import java.util.concurrent.Callable;
import java.util.function.Supplier;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParentCommand;
import simpleray.render.Accel;
import simpleray.render.PreparedScene;
import simpleray.render.RenderListener;
import simpleray.render.RenderRequest;
import simpleray.render.RenderSettings;
import simpleray.render.Renderer;
import simpleray.render.Stage;
import simpleray.scene.RayStats;
import simpleray.scene.Scene;
import simpleray.scene.SceneFile;
import simpleray.scene.SceneSettings;
import simpleray.scene.SimpleCamera;

/** Measures how fast the renderer is on this machine. */
@Command(mixinStandardHelpOptions = true,
    description = "Measures how fast the renderer is on this machine: rays a second by kind, how the time grows with the number of "
        + "spheres and shrinks with that of threads, what even spheres, heaps of spheres and a mesh cost beside the same without "
        + "acceleration, and how many pictures a second a window could show. Takes some minutes; for fair figures let nothing else run.")
final class BenchCommand implements Callable<Integer> {
    private static final String THESIS = "/simpleray/scenes/thesis.scene";
    private static final int[] SIZES = {100, 1000, 10_000, 100_000, 1_000_000};
    private static final int KINDS_SIZE = 10_000;
    private static final int MESH_SIZE = 200_000;
    private static final int QUICK_MESH_SIZE = 2000;
    /** About how often a ray from the eye is tested against an object with {@code --accel none}: pictures are made small enough. */
    private static final double MAX_ASKED = 2e7;
    private static final int SIDE = 400;
    private static final int QUICK_SIDE = 40;
    private static final int DEPTH = 5;
    private static final int RUNS = 5;

    @ParentCommand
    private Main main;

    @Option(names = "--quick", description = "Few spheres and small pictures: some seconds, and no figures to quote.")
    private boolean quick;

    private final int all = Runtime.getRuntime().availableProcessors();

    /** The times of a rendering, apart from each other, and its statistics, which are null with {@code --accel none}. */
    private record Run(double ready, double seconds, RayStats stats) {
    }

    @Override
    public Integer call() throws CommandException {
        say("SimpleRay on Java %s, %d processors; pictures of %d x %d, medians of %d", System.getProperty("java.version"), all,
            side(), side(), runs());
        interactive();                                        // first: in a window with one scene the JIT compiler has nothing else to do
        kinds();
        growth();
        scenes();
        threads();
        return ExitCode.DONE;
    }

    /** Measures each kind of rays: a rendering with them takes longer than the same one without. */
    private void kinds() throws CommandException {
        Scene scene = BenchScenes.even(quick ? SIZES[0] : KINDS_SIZE, false);
        Run primary = median(scene, Stage.ORIGINAL, DEPTH, 1);
        Run lit = median(scene, Stage.LIGHTING, 0, 1);
        Run shadowed = median(scene, Stage.FINAL, 0, 1);
        Run mirrored = median(scene, Stage.FINAL, DEPTH, 1);
        Scene glass = BenchScenes.even(quick ? SIZES[0] : KINDS_SIZE, true);
        Run clear = median(glass, Stage.FINAL, 0, 1);
        Run bent = median(glass, Stage.FINAL, DEPTH, 1);
        say("%nrays of one thread, %d spheres        rays   million a second", quick ? SIZES[0] : KINDS_SIZE);
        rate("primary", primary.stats.primary, primary.seconds);
        rate("shadow", shadowed.stats.shadow, shadowed.seconds - lit.seconds);
        rate("reflected, with the shadow rays of what they hit", mirrored.stats.rays() - shadowed.stats.rays(),
            mirrored.seconds - shadowed.seconds);
        rate("refracted and reflected in glass, likewise", bent.stats.rays() - clear.stats.rays(), bent.seconds - clear.seconds);
        rate("all of a finished picture", mirrored.stats.rays(), mirrored.seconds);
    }

    private void rate(String kind, long rays, double seconds) throws CommandException {
        say("%-50s %9d   %s", kind, rays, seconds > 0 ? String.format(Locale.ROOT, "%.2f", rays / seconds / 1e6) : "too fast to measure");
    }

    private void growth() throws CommandException {
        say("%n  spheres   make ready, s   render, s   rays   ns a ray   tests a ray");
        List<double[]> points = new ArrayList<>();
        for (int n : quick ? Arrays.copyOf(SIZES, 2) : SIZES) {
            Run run = median(BenchScenes.even(n, false), Stage.FINAL, DEPTH, all);
            long rays = run.stats.rays();
            say("%9d   %13.3f   %9.3f   %d   %.0f   %.1f", n, run.ready, run.seconds, rays, run.seconds / rays * 1e9,
                (double) run.stats.tests / rays);
            points.add(new double[] {Math.log(n), Math.log(run.seconds)});
        }
        say("the time to render grows as the number of spheres to the power of %.3f", slope(points));
    }

    /** Measures other scenes beside even spheres; each also with all objects tested in turn, as in the thesis. */
    private void scenes() throws CommandException {
        int n = quick ? SIZES[1] : KINDS_SIZE;
        int triangles = quick ? QUICK_MESH_SIZE : MESH_SIZE;
        say("%n%-30s   make ready, s   render, s      rays   ns a ray   tests a ray   ns a ray, --accel none", "scene");
        compare(n + " even spheres", () -> BenchScenes.even(n, false));
        compare(n + " spheres in heaps", () -> BenchScenes.clusters(n));
        if (!quick) {
            compare(SIZES[3] + " spheres in heaps", () -> BenchScenes.clusters(SIZES[3]));
        }
        compare("mesh of about " + triangles + " triangles", () -> BenchScenes.mesh(triangles));
        say("(--accel none with pictures of the size behind it; a mesh is one object, which finds its triangles by a tree of its own)");
    }

    private void compare(String name, Supplier<Scene> maker) throws CommandException {
        Scene scene = maker.get();
        RenderSettings settings = new RenderSettings(Stage.FINAL, DEPTH, 1, all);
        Run run = median(scene, settings, side());
        double ready = run(maker.get(), settings, side()).ready;   // of a new scene, since a mesh keeps its tree
        long rays = run.stats.rays();
        int none = (int) Math.min(side(), Math.sqrt(MAX_ASKED / scene.getNumberObjects()));
        long noneRays = run(scene, settings, none).stats.rays();   // not counted with --accel none
        double seconds = median(scene, new RenderSettings(Stage.FINAL, DEPTH, 1, Accel.NONE, all, null), none).seconds;
        say("%-30s   %13.3f   %9.3f   %7d   %8.0f   %11.1f   %9.0f (%d x %d)", name, ready, run.seconds, rays, run.seconds / rays * 1e9,
            (double) run.stats.tests / rays, seconds / noneRays * 1e9, none, none);
    }

    /** {@return the slope of the straight line that fits best, by least squares} */
    private static double slope(List<double[]> points) {
        double x = points.stream().mapToDouble(p -> p[0]).average().orElseThrow();
        double y = points.stream().mapToDouble(p -> p[1]).average().orElseThrow();
        return points.stream().mapToDouble(p -> (p[0] - x) * (p[1] - y)).sum()
            / points.stream().mapToDouble(p -> (p[0] - x) * (p[0] - x)).sum();
    }

    private void threads() throws CommandException {
        say("%nthreads   render, s   efficiency");
        Scene scene = BenchScenes.even(quick ? SIZES[0] : KINDS_SIZE, false);
        TreeSet<Integer> numbers = new TreeSet<>(List.of(1, all));
        for (int n = 2; n < all; n *= 2) {
            numbers.add(n);
        }
        double one = 0;
        for (int n : numbers) {
            double seconds = median(scene, Stage.FINAL, DEPTH, n).seconds;
            one = n == 1 ? seconds : one;
            say("%7d   %9.3f   %10.2f", n, seconds, one / n / seconds);
        }
    }

    private void interactive() throws CommandException {
        Scene thesis;
        try {
            thesis = SceneFile.read(BenchCommand.class.getResourceAsStream(THESIS)).scene();
        } catch (IOException e) {
            throw new CommandException(ExitCode.INTERNAL, "simpleray: the thesis's scene in the jar cannot be read: " + e.getMessage());
        }
        SceneSettings settings = new SceneSettings();
        settings.resolution = new SceneSettings.Resolution(side(), side());
        RenderRequest request = new RenderRequest(settings, Stage.FINAL, false, all);
        PreparedScene prepared = new PreparedScene(thesis);   // as in a window
        int pictures = quick ? 1 : 200;
        double[] seconds = new double[pictures];
        for (int i = -pictures; i < pictures; i++) {          // the first half warms up
            long start = System.nanoTime();
            prepared.renderer(request).render(RenderListener.NONE);
            if (i >= 0) {
                seconds[i] = (System.nanoTime() - start) / 1e9;
            }
        }
        Arrays.sort(seconds);
        say("%nthe thesis's scene, final stage, %d threads, warm: %.0f pictures a second, by the median of %d", all,
            1 / seconds[pictures / 2], pictures);
    }

    private int side() {
        return quick ? QUICK_SIDE : SIDE;
    }

    private int runs() {
        return quick ? 1 : RUNS;
    }

    private Run median(Scene scene, Stage stage, int depth, int threads) {
        return median(scene, new RenderSettings(stage, depth, 1, threads), side());
    }

    private Run median(Scene scene, RenderSettings settings, int side) {
        List<Run> runs = new ArrayList<>();
        run(scene, settings, side);
        for (int i = 0; i < runs(); i++) {
            runs.add(run(scene, settings, side));
        }
        runs.sort((a, b) -> Double.compare(a.seconds, b.seconds));
        return runs.get(runs.size() / 2);
    }

    private static Run run(Scene scene, RenderSettings settings, int side) {
        Renderer renderer = new Renderer(scene, new SimpleCamera(side, side), settings);
        renderer.render(RenderListener.NONE);
        return new Run(renderer.stats().readySeconds(), renderer.stats().renderSeconds(), renderer.stats().rays());
    }

    private void say(String format, java.lang.Object... values) throws CommandException {
        TextOutput.say(main, String.format(Locale.ROOT, format, values) + '\n');
    }
}
