package simpleray.render;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import simpleray.math.Bounds;
import simpleray.math.Colour;
import simpleray.math.Point;
import simpleray.math.Ray;
import simpleray.math.Vector;
import simpleray.scene.Camera;
import simpleray.scene.Integrator;
import simpleray.scene.Interaction;
import simpleray.scene.Intersector;
import simpleray.scene.Object;
import simpleray.scene.Plane;
import simpleray.scene.RayStats;
import simpleray.scene.Recorder;
import simpleray.scene.Scene;
import simpleray.scene.SceneFile;
import simpleray.scene.Terms;
import simpleray.scene.VisibilityTester;
import simpleray.scene.WhittedIntegrator;
import simpleray.text.Problem;
import simpleray.trace.CompiledScene;

/**
 * Finds what is odd about a scene's picture: things that make no difference to it, an eye inside something, colours that are cut off,
 * planes that may lie elsewhere than was meant. Some thousand rays are followed from the eye, the same each time; what is said is true of
 * these rays. <em>Mutable</em>, for one thread.
 */
public final class SceneWarnings {
    /** Rays from side to side of the picture: as many first, and then so many more if there is something that these did not find. */
    private static final int[] SIDES = {64, 120};
    private static final int MOST_REFLECTIONS = 4;
    /** Above it a component's level would be above 255. */
    private static final double WHITE = 255.5 / 255;
    private static final double MUCH = 0.01;
    /** Scenes with more objects take too long to be made ready for those who did not ask. */
    private static final int MOST_OBJECTS = 10_000;
    /** A plane whose normal's length is off 1 by no more is as good as where it should be: four decimals are often all that is written. */
    private static final double ROUNDED = 1e-4;
    /** A normal whose length is off 1 by no more was perhaps meant to have it. */
    private static final double NEARLY = 0.05;
    /** So many objects that are not seen have a warning each. */
    private static final int MOST_UNSEEN = 10;
    /** Crossings of an object are counted up to here; who has more is taken for outside. */
    private static final int MOST_CROSSINGS = 1000;
    /** Two directions in which nobody builds. */
    private static final List<Vector> ODD = List.of(new Vector(0.5391, 0.3175, 0.7801), new Vector(-0.2713, -0.8527, 0.4463));

    private final SceneFile file;
    private final Scene scene;
    private final String name;
    private final Camera camera;
    private final List<Problem> problems = new ArrayList<>();
    private final Seen seen;
    private final double leastClipped;                        // a share of all rays
    private int rays;
    private int clipped;
    private double brightest;
    private String where;
    private int brightestObject;

    private SceneWarnings(SceneFile file, String name, double leastClipped) {
        this.leastClipped = leastClipped;
        this.file = file;
        this.name = name;
        scene = file.scene();
        camera = scene.settings.newCamera();
        seen = new Seen(scene.getNumberLights());
    }

    /** Notes which objects rays hit, at first or after reflections, and which lights reach something there. */
    private static final class Seen implements Recorder {
        final BitSet objects = new BitSet();
        final boolean[] lights;
        /** The object that the latest ray from the eye hit, if it hit one. */
        int first;

        private boolean fromEye;

        Seen(int lights) {
            this.lights = new boolean[lights];
        }

        @Override
        public void begin(Ray ray, int depth, int level) {
            fromEye = level == 0;
        }

        @Override
        public void hit(Ray ray, Interaction at) {
            objects.set(at.place);
            first = fromEye ? at.place : first;
        }

        @Override
        public void light(int number, VisibilityTester visibility, Colour arriving, Vector halfway, double cosine, Colour diffuse,
                Colour specular) {
            lights[number] |= !arriving.isBlack();
        }
    }

    /**
     * Finds what is odd about a scene's picture, beside what {@link SceneFile#warnings} says of its file.
     *
     * @param file the scene, which must not change meanwhile; its settings say which picture
     * @param name what messages call its file
     * @return warnings, in the order of the file
     */
    public static List<Problem> of(SceneFile file, String name) {
        return file.scene().getNumberObjects() == 0 ? List.of() : new SceneWarnings(file, name, 0).find();
    }

    /**
     * Finds what is odd about a scene's picture, for those who did not ask: as {@link #of}, but bright colours only if much of the picture
     * has them, and not only its highlights.
     *
     * @param file the scene, which must not change meanwhile; its settings say which picture
     * @param name what messages call its file
     * @return warnings, in the order of the file
     */
    public static List<Problem> striking(SceneFile file, String name) {
        boolean none = file.scene().getNumberObjects() == 0 || file.scene().getNumberObjects() > MOST_OBJECTS;
        return none ? List.of() : new SceneWarnings(file, name, MUCH).find();
    }

    private List<Problem> find() {
        follow();
        for (int i = 0; i < seen.lights.length; i++) {
            if (!seen.lights[i]) {
                warn(file.lineOfLight(i), "light " + (i + 1) + (scene.getLight(i).intensity.isBlack() ? " is black"
                    : " reaches nothing of what " + rays + " rays saw"));
            }
        }
        Point eye = camera.eye();
        for (int i = 0; i < scene.getNumberObjects(); i++) {
            if (isAround(scene.getObject(i), eye)) {
                warn(file.lineOfObject(i), "object " + (i + 1) + " is around the eye, which sees it from inside");
            }
            if (scene.getObject(i) instanceof Plane plane) {
                lookAtLength(plane.normal.norm(), i);
            }
        }
        warnOfUnseen();
        if (clipped > leastClipped * rays) {
            warn(file.lineOfObject(brightestObject), String.format(Locale.ROOT, "the picture is clipped where it is brighter than 1: "
                + "%d of %d rays saw such colours, the brightest %s", clipped, rays, where));
        }
        problems.sort(Comparator.comparingInt(Problem::line));
        return problems;
    }

    private void lookAtLength(double length, int i) {
        double off = Math.abs(length - 1);
        if (off > ROUNDED && off <= NEARLY) {
            warn(file.lineOfObject(i), String.format(Locale.ROOT,
                "object %d's normal has length %.4f, nearly 1: the plane lies constant / %2$.4f along it", i + 1, length));
        }
    }

    private void warnOfUnseen() {
        int unseen = scene.getNumberObjects() - seen.objects.cardinality();
        String told = " not seen by any of " + rays + " rays";
        int i = seen.objects.nextClearBit(0);
        if (unseen > MOST_UNSEEN) {
            warn(file.lineOfObject(i), "object " + (i + 1) + " and " + (unseen - 1) + " others were" + told);
            return;
        }
        for (; i < scene.getNumberObjects(); i = seen.objects.nextClearBit(i + 1)) {
            warn(file.lineOfObject(i), "object " + (i + 1) + " was" + told);
        }
    }

    private void warn(int line, String message) {
        problems.add(new Problem(name, Math.max(1, line), 1, false, message, null));
    }

    private void follow() {
        RayStats uncounted = new RayStats();
        Intersector intersector = new CompiledScene(scene, camera.eye(), 1, (long) SIDES[0] * SIDES[0]).intersector(uncounted);
        Integrator integrator = new WhittedIntegrator(scene, intersector, Terms.ALL, uncounted, seen);
        for (int side : SIDES) {
            follow(integrator, side);
            boolean all = seen.objects.cardinality() == scene.getNumberObjects();
            for (boolean reached : seen.lights) {
                all &= reached;
            }
            if (all) {
                return;
            }
        }
    }

    private void follow(Integrator integrator, int side) {
        int asked = scene.settings.depth == null ? RenderSettings.DEFAULT_DEPTH : scene.settings.depth;
        Colour colour = new Colour();
        for (int j = 0; j < side; j++) {
            for (int i = 0; i < side; i++) {
                double px = (i + 0.5) / side * camera.width();
                double py = (j + 0.5) / side * camera.height();
                if (integrator.trace(camera.through(px, py), colour, Math.min(asked, MOST_REFLECTIONS))) {
                    noteBrightness(colour, (int) px, (int) py);
                }
            }
        }
        rays += side * side;
    }

    private void noteBrightness(Colour colour, int x, int y) {
        double most = Math.max(colour.r, Math.max(colour.g, colour.b));
        if (most > WHITE) {
            clipped++;
            if (most > brightest) {
                brightest = most;
                brightestObject = seen.first;
                where = String.format(Locale.ROOT, "%.2f %.2f %.2f on object %d (column %d, row %d)", colour.r, colour.g, colour.b,
                    brightestObject + 1, x + 1, y + 1);
            }
        }
    }

    /** {@return whether a point is inside an object}: rays from there cross its surface an odd number of times. */
    private static boolean isAround(Object object, Point eye) {
        Bounds box = object.bounds();
        return box != null && box.contains(eye) && object.isSolid()
            && ODD.stream().allMatch(direction -> crossings(object, eye, direction) % 2 != 0);
    }

    private static int crossings(Object object, Point from, Vector direction) {
        Ray ray = new Ray(new Point(from), direction.normalised());
        int crossings = 0;
        for (double t = object.intersect(ray); t >= 0 && crossings < MOST_CROSSINGS; t = object.intersect(ray)) {
            crossings++;
            ray.origin.copy(ray.getPointAt(t));
        }
        return crossings;
    }
}
