package simpleray.render;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.Comparator;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.IntStream;
import simpleray.math.Bounds;
import simpleray.math.Colour;
import simpleray.math.Point;
import simpleray.math.Ray;
import simpleray.math.Vector;
import simpleray.scene.Camera;
import simpleray.scene.Film;
import simpleray.scene.Integrator;
import simpleray.scene.Interaction;
import simpleray.scene.Intersector;
import simpleray.scene.Key;
import simpleray.scene.Material;
import simpleray.scene.Mesh;
import simpleray.scene.Object;
import simpleray.scene.Plane;
import simpleray.scene.RayStats;
import simpleray.scene.Recorder;
import simpleray.scene.Scene;
import simpleray.scene.SceneFile;
import simpleray.scene.Setting;
import simpleray.scene.Terms;
import simpleray.scene.VisibilityTester;
import simpleray.scene.WhittedIntegrator;
import simpleray.text.Diagnostic;
import simpleray.text.RoundedDecimal;
import simpleray.trace.CompiledScene;

/**
 * Finds likely mistakes in a scene: objects and lights that do not affect the picture, an eye inside an object, clipped colours, planes that
 * may lie elsewhere than intended, keys of a film that do nothing. It traces some thousand rays from the eye, the same each time; its warnings
 * hold for these rays. Of a film it looks at the first frame, and at others for what that does not show.
 * <em>Mutable</em>, for one thread.
 */
public final class SceneLint {
    /** The number of rays along each side of the picture, and that of a second try if the first does not find everything. */
    private static final int[] SIDES = {64, 120};
    /** How many digits a place has. */
    private static final int DIGITS = 6;
    private static final int MAX_REFLECTIONS = 4;
    /** The level of a brighter component would be above 255. */
    private static final double WHITE = 255.5 / 255;
    /** The least share of rays with clipped colours that is worth an unasked warning. */
    private static final double STRIKING = 0.01;
    /** The most objects of a scene that is checked unasked: larger ones take too long to compile. */
    private static final int MAX_OBJECTS = 10_000;
    /** A normal whose length differs from 1 by no more is a unit vector written with four decimals. */
    private static final double ROUNDED = 1e-4;
    /** A normal whose length differs from 1 by no more was perhaps meant to be a unit vector. */
    private static final double NEARLY = 0.05;
    /** The number of unseen objects that get a warning each. */
    private static final int MAX_UNSEEN = 10;
    /** The number of pairs of objects that overlap in a plane that get a warning each. */
    private static final int MAX_OVERLAPS = 10;
    /** The most frames of a film that are traced; and those of a scene of many objects, or unasked. */
    private static final int MAX_FRAMES = 40;
    private static final int FEW_FRAMES = 5;
    /** The number of keys that do nothing that get a warning each. */
    private static final int MAX_IDLE = 10;
    /** The most crossings of an object's surface that are counted to find whether the eye is inside. */
    private static final int MAX_CROSSINGS = 1000;
    /** Two directions that are unlikely to run along a surface. */
    private static final List<Vector> ODD = List.of(new Vector(0.5391, 0.3175, 0.7801), new Vector(-0.2713, -0.8527, 0.4463));

    private final SceneFile file;
    private final Film film;
    private final Scene scene;
    private final String name;
    private final Camera camera;
    private final List<Diagnostic> problems = new ArrayList<>();
    private final Seen seen = new Seen();
    private List<Bounds> bending;
    private int rays;
    private int frames;
    private int clipped;
    private double brightest = WHITE;
    private int brightestObject;
    private String brightestPixel;

    private SceneLint(SceneFile file, String name) {
        this.file = file;
        this.name = name;
        film = file.scene().film();
        scene = film.still(0);
        camera = scene.settings.newCamera();
    }

    /** Notes the objects that rays hit, at first or after reflections, and the lights that reach these hits. */
    private static final class Seen implements Recorder {
        final BitSet objects = new BitSet();
        final BitSet lights = new BitSet();
        /** What blocks lights that reach nothing, by the lights' indices. */
        final Map<Integer, LightBlockers> blocked = new HashMap<>();
        private Interaction latest;
        /** The object that the latest ray from the eye hit; below 0 if none. */
        int first;

        @Override
        public void hit(Ray ray, Interaction at) {
            objects.set(at.place);
            first = first < 0 ? at.place : first;
            latest = at;
        }

        @Override
        public void light(int number, VisibilityTester visibility, Colour arriving, Vector halfway, double cosine, Colour diffuse,
                Colour specular) {
            if (!arriving.isBlack()) {
                lights.set(number);
                blocked.remove(number);
            } else if (visibility.facing > 0 && !lights.get(number)) {
                blocked.computeIfAbsent(number, light -> new LightBlockers()).add(latest, visibility);
            }
        }
    }

    /**
     * Finds all likely mistakes in a scene's picture. {@link SceneFile#warnings} has those of its file.
     *
     * @param file the scene, which must not change meanwhile, with the settings of the picture
     * @param name the file's name in messages
     * @return warnings, in the order of the file
     */
    public static List<Diagnostic> all(SceneFile file, String name) {
        return file.scene().getNumberObjects() == 0 ? List.of() : new SceneLint(file, name).find(0);
    }

    /**
     * Finds the likely mistakes that a user is told unasked: as {@link #all}, but bright colours only if they are more than highlights,
     * overlapping surfaces only if they may be seen, and nothing about keys and large scenes.
     *
     * @param file the scene, which must not change meanwhile, with the settings of the picture
     * @param name the file's name in messages
     * @return warnings, in the order of the file
     */
    public static List<Diagnostic> striking(SceneFile file, String name) {
        int objects = file.scene().getNumberObjects();
        return objects == 0 || objects > MAX_OBJECTS ? List.of() : new SceneLint(file, name).find(STRIKING);
    }

    private List<Diagnostic> find(double tolerated) {
        warnOfOverlaps(tolerated == 0);
        trace();
        int raysOfFirst = rays;
        traceOthers(tolerated == 0 ? MAX_FRAMES : FEW_FRAMES);
        for (int i = seen.lights.nextClearBit(0); i < scene.getNumberLights(); i = seen.lights.nextClearBit(i + 1)) {
            warn(file.lineOfLight(i), frames == 1 && scene.getLight(i).intensity.isBlack() ? "light " + (i + 1) + " is black" : unlit(i));
        }
        Point eye = middle().origin;
        for (int i = 0; i < scene.getNumberObjects(); i++) {
            if (isAround(scene.getObject(i), eye)) {
                warn(file.lineOfObject(i), "object " + (i + 1) + " is around the eye, which sees it from inside");
            }
            if (scene.getObject(i) instanceof Plane plane && isNearlyUnit(plane.normal.norm())) {
                warn(file.lineOfObject(i), String.format(Locale.ROOT,
                    "object %d's normal has length %.4f, nearly 1: the plane lies constant / %2$.4f along it", i + 1, plane.normal.norm()));
            }
        }
        warnOfUnseen();
        if (tolerated == 0) {
            warnOfIdleKeys();
        }
        if (clipped > tolerated * raysOfFirst) {
            warn(file.lineOfObject(brightestObject), "the picture is clipped where it is brighter than 1: " + clipped + " of "
                + raysOfFirst + " rays saw such colours, the brightest " + brightestPixel);
        }
        problems.sort(Comparator.comparingInt(Diagnostic::line));
        return problems;
    }

    /** {@return the ray through the middle of the picture} */
    private Ray middle() {
        return camera.through(camera.width() / 2.0, camera.height() / 2.0);
    }

    /** {@return why a light makes no difference} */
    private String unlit(int light) {
        int line = file.lineOfLight(light);
        String told = "light " + (light + 1) + (line > 0 ? " (line " + line + ")" : "") + " lights nothing that is seen" + inFrames();
        LightBlockers between = seen.blocked.get(light);
        return seen.objects.isEmpty() || frames > 1 ? told
            : told + ": " + (between == null ? "all of that is turned away from it" : between.told(scene));
    }

    private void warnOfUnseen() {
        int unseen = scene.getNumberObjects() - seen.objects.cardinality();
        String what = " not seen by any of " + rays();
        int i = seen.objects.nextClearBit(0);
        if (unseen > MAX_UNSEEN) {
            warn(file.lineOfObject(i), "object " + (i + 1) + " and " + (unseen - 1) + " others were" + what);
            return;
        }
        for (; i < scene.getNumberObjects(); i = seen.objects.nextClearBit(i + 1)) {
            warn(file.lineOfObject(i), "object " + (i + 1) + " was" + what);
        }
    }

    private String rays() {
        return rays + " rays" + inFrames();
    }

    private String inFrames() {
        return frames > 1 ? " in " + (frames == film.frames() ? "all " + frames : frames + " of " + film.frames()) + " frames" : "";
    }

    private void warnOfIdleKeys() {
        List<Film.Idle> idle = film.idle();
        for (Film.Idle one : idle.subList(0, Math.min(MAX_IDLE, idle.size()))) {
            warn(file.lineOfKey(one.key()), one.message());
        }
        if (idle.size() > MAX_IDLE) {
            warn(file.lineOfKey(idle.get(MAX_IDLE).key()), idle.size() - MAX_IDLE + " more keys do nothing");
        }
    }

    private void warnOfOverlaps(boolean hiddenToo) {
        Map<Integer, Boolean> solid = new HashMap<>();
        List<CoplanarSurfaces.Pair> pairs = new ArrayList<>(CoplanarSurfaces.find(scene, (one, other) -> isSeen(one, other, solid)));
        pairs.sort(Comparator.comparingInt(CoplanarSurfaces.Pair::second).thenComparingInt(CoplanarSurfaces.Pair::first));
        List<CoplanarSurfaces.Pair> seen = pairs.stream().filter(CoplanarSurfaces.Pair::seen).toList();
        for (CoplanarSurfaces.Pair pair : seen.subList(0, Math.min(MAX_OVERLAPS, seen.size()))) {
            warnOfOverlap(pair, ": rounding decides which is seen, so leave a gap or drop one");
        }
        if (seen.size() > MAX_OVERLAPS) {
            warn(file.lineOfObject(seen.get(MAX_OVERLAPS).second()), others(seen.size() - MAX_OVERLAPS) + " overlap in one plane");
        }
        int hidden = pairs.size() - seen.size();
        if (hiddenToo && hidden > 0) {
            warnOfOverlap(pairs.stream().filter(pair -> !pair.seen()).findFirst().orElseThrow(), ", where opaque bodies hide it"
                + (hidden > 1 ? "; so do " + others(hidden - 1) : ""));
        }
    }

    private void warnOfOverlap(CoplanarSurfaces.Pair pair, String rest) {
        String first = place(pair.first(), pair.firstFace());
        String second = place(pair.second(), pair.secondFace());
        String both = second == null || second.equals(first) ? first : first + " and " + second;   // of one mesh
        String who = pair.first() == pair.second() ? "faces of object " + named(pair.first(), both)
            : "objects " + named(pair.first(), first) + " and " + named(pair.second(), second);
        Point at = pair.place();
        warn(file.lineOfObject(pair.second()), who + " overlap in one plane, as at ("
            + RoundedDecimal.of(at.x, at.y, at.z, DIGITS) + ')' + rest);
    }

    private static String others(int pairs) {
        return pairs + (pairs == 1 ? " more pair" : " more pairs") + " of objects";
    }

    /** {@return where a face stands in a mesh's OBJ; null if it is of no OBJ} */
    private String place(int object, int face) {
        return scene.getObject(object) instanceof Mesh mesh ? mesh.place(face) : null;
    }

    private String named(int object, String place) {
        int line = file.lineOfObject(object);
        String where = (line > 0 ? "line " + line : "") + (line > 0 && place != null ? ", " : "") + (place == null ? "" : place);
        return object + 1 + (where.isEmpty() ? "" : " (" + where + ')');
    }

    /**
     * {@return whether an overlap of two faces may be seen} From a side on which an opaque body of another object lies on it, it is not. The
     * eye is on one side; the other is seen by what mirrors or bends a ray there, unless an endless opaque plane is between.
     */
    private boolean isSeen(CoplanarSurfaces.Face one, CoplanarSurfaces.Face other, Map<Integer, Boolean> solid) {
        boolean[] hidden = new boolean[2];                    // from below and from above, as the one's normal has it
        for (CoplanarSurfaces.Face face : List.of(one, other)) {
            if (!CoplanarSurfaces.isClear(scene, face) && solid.computeIfAbsent(face.object(), i -> scene.getObject(i).isSolid())) {
                hidden[face.normal().dot(one.normal()) > 0 ? 0 : 1] = true;
            }
        }
        Point from = camera.eye();
        int eye = (from != null ? one.normal().dot(from) > one.offset() : one.normal().dot(middle().direction) < 0) ? 1 : 0;
        return one.object() == other.object() || !hidden[eye] || !hidden[1 - eye] && !isEndless(one) && !isEndless(other)
            && bending().stream().anyMatch(box -> box == null || reaches(box, one, eye == 0));
    }

    private boolean isEndless(CoplanarSurfaces.Face face) {
        return face.corners().length == 0 && !CoplanarSurfaces.isClear(scene, face);
    }

    /** {@return whether a box reaches above or below a face's plane} */
    private static boolean reaches(Bounds box, CoplanarSurfaces.Face face, boolean above) {
        double[] sides = new double[6];
        box.get(sides);
        double height = -face.offset();
        double rounding = 0;
        for (int axis = 0; axis < 3; axis++) {
            double along = axis == 0 ? face.normal().x : axis == 1 ? face.normal().y : face.normal().z;
            height += along * sides[along > 0 == above ? axis + 3 : axis];
            rounding += Math.abs(sides[axis]) + Math.abs(sides[axis + 3]);
        }
        return (above ? height : -height) > Object.THRESHOLD + CoplanarSurfaces.ROUNDINGS * (rounding + Math.abs(face.offset()));
    }

    /** {@return the boxes of the objects that mirror or transmit rays, null for an infinite one} */
    private List<Bounds> bending() {
        if (bending == null) {
            bending = new ArrayList<>();
            for (int i = 0; i < scene.getNumberObjects(); i++) {
                Object object = scene.getObject(i);
                if (IntStream.range(0, object.parts()).mapToObj(object::material).anyMatch(SceneLint::bends)) {
                    bending.add(object.bounds());
                }
            }
        }
        return bending;
    }

    private static boolean bends(Material material) {
        return material.reflections() > 0 && !(material.mirrored().isBlack() && material.transmission.isBlack());
    }

    private void warn(int line, String message) {
        problems.add(new Diagnostic(name, Math.max(1, line), 1, false, message, null));
    }

    private void trace() {
        Integrator integrator = integrator(scene, camera);
        for (int side : SIDES) {
            if (!isAllSeen()) {
                trace(integrator, camera, side, true);
            }
        }
        frames = 1;
    }

    /** Looks for what was not seen in frames that are spread evenly over the film, the last one among them, and then near keys. */
    private void traceOthers(int most) {
        int parts = 0;
        for (int i = 0; i < scene.getNumberObjects() && parts <= MAX_OBJECTS; i++) {
            parts += scene.getObject(i).parts();
        }
        int count = Math.min(film.frames(), parts > MAX_OBJECTS ? FEW_FRAMES : most);
        Set<Double> traced = new HashSet<>(Set.of(0.0));
        for (int i = 1; i < count; i++) {
            traceFrame(Math.rint((film.frames() - 1.0) * i / (count - 1)), traced);
        }
        if (!isAllSeen()) {
            nearKeysOfUnseen().stream().filter(frame -> !traced.contains(frame)).limit(count).forEach(frame -> traceFrame(frame, traced));
        }
    }

    /** {@return the frames at the keys of objects that were not seen, and half-way between these} */
    private Set<Double> nearKeysOfUnseen() {
        TreeSet<Double> keys = new TreeSet<>();
        for (Key key : file.scene().settings.keys == null ? List.<Key>of() : file.scene().settings.keys) {
            if (key.thing().kind() == Key.Kind.OBJECT && !seen.objects.get(key.thing().number() - 1)) {
                keys.add(Math.rint(key.frame()));
            }
        }
        Set<Double> frames = new LinkedHashSet<>(keys);
        for (double key : keys) {
            Double next = keys.higher(key);
            frames.add(next == null ? key : Math.rint((key + next) / 2));
        }
        return frames;
    }

    private void traceFrame(double frame, Set<Double> traced) {
        if (!isAllSeen()) {
            traced.add(frame);
            Scene still = film.still(frame);
            Camera moved = still.settings.newCamera();
            trace(integrator(still, moved), moved, SIDES[0], false);
            frames++;
        }
    }

    private boolean isAllSeen() {
        return seen.objects.cardinality() == scene.getNumberObjects() && seen.lights.cardinality() == scene.getNumberLights();
    }

    private Integrator integrator(Scene still, Camera eye) {
        RayStats uncounted = new RayStats();
        Intersector intersector = new CompiledScene(still, eye.eye(), 1, (long) SIDES[0] * SIDES[0]).intersector(uncounted);
        return new WhittedIntegrator(still, intersector, Terms.ALL, uncounted, seen);
    }

    private void trace(Integrator integrator, Camera eye, int side, boolean bright) {
        int depth = Math.min(MAX_REFLECTIONS, Setting.DEPTH.in(scene.settings));
        Colour colour = new Colour();
        for (int j = 0; j < side; j++) {
            for (int i = 0; i < side; i++) {
                double px = (i + 0.5) / side * eye.width();
                double py = (j + 0.5) / side * eye.height();
                seen.first = -1;
                if (integrator.trace(eye.through(px, py), colour, depth) && bright) {
                    noteBrightness(colour, (int) px, (int) py);
                }
            }
        }
        rays += side * side;
    }

    private void noteBrightness(Colour colour, int x, int y) {
        double brightness = Math.max(colour.r, Math.max(colour.g, colour.b));
        clipped += brightness > WHITE ? 1 : 0;
        if (brightness > brightest) {
            brightest = brightness;
            brightestObject = seen.first;
            brightestPixel = String.format(Locale.ROOT, "%.2f %.2f %.2f on object %d (column %d, row %d)", colour.r, colour.g, colour.b,
                brightestObject + 1, x + 1, y + 1);
        }
    }

    private static boolean isNearlyUnit(double length) {
        double off = Math.abs(length - 1);
        return off > ROUNDED && off <= NEARLY;
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
        for (double t = object.intersect(ray); t >= 0 && crossings < MAX_CROSSINGS; t = object.intersect(ray)) {
            crossings++;
            ray.origin.copy(ray.getPointAt(t));
        }
        return crossings;
    }
}
