package simpleray.pov;

import java.io.IOException;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.TreeSet;
import simpleray.math.Bounds;
import simpleray.math.Colour;
import simpleray.math.Point;
import simpleray.scene.AreaLight;
import simpleray.scene.Camera;
import simpleray.scene.Light;
import simpleray.scene.Mesh;
import simpleray.scene.Object;
import simpleray.scene.PointLight;
import simpleray.scene.Scene;
import simpleray.text.SceneWriter;

/**
 * Writes a scene for POV-Ray 3.7, as the final stage renders it. <em>Constant</em>; the scene is referenced, and must not change.
 *
 * <p>Light passes through our glass and is dimmed once for each object, in POV-Ray once for each surface. So what is seen of an object
 * that dims light casts no shadow there, and a twin that nobody sees casts it. Open things of one glass, such as triangles, are
 * written as one body: for POV-Ray a ray enters at its first hit and leaves at the next.
 */
public final class PovExporter {
    /** The most that POV-Ray lets one ask for: a ray from the eye counts too. */
    private static final int MAX_DEPTH = 255;
    /** How many objects a warning names. */
    private static final int MAX_NAMED = 8;

    private final Scene scene;
    private final Camera camera;
    private final PovChannel shown;
    private final List<Object> objects = new ArrayList<>();   // of a mesh of many materials a piece for each
    private final List<Integer> places = new ArrayList<>();   // their indices in the scene
    private final List<PovMaterial> materials = new ArrayList<>();
    private final List<String> warnings = new ArrayList<>();
    private final int depth;

    /**
     * Prepares a scene.
     *
     * @param scene the scene; of its settings only the background counts
     * @param camera the camera
     * @param depth the most reflections of a ray from the eye
     * @param shown which colour channels are shown
     */
    public PovExporter(Scene scene, Camera camera, int depth, PovChannel shown) {
        this.scene = scene;
        this.camera = camera;
        this.shown = shown;
        for (int i = 0; i < scene.getNumberObjects(); i++) {
            Object object = scene.getObject(i);
            for (Object piece : object instanceof Mesh mesh ? mesh.pieces() : List.of(object)) {
                objects.add(piece);
                places.add(i);
                materials.add(new PovMaterial(piece.surfaceMaterial, scene.ambient, shown, depth));
            }
        }
        this.depth = commonDepth(depth);
        warnOfColours();
        warnOfGlass();
    }

    /** {@return the differences of POV-Ray's picture from ours, a sentence each} */
    public List<String> warnings() {
        return List.copyOf(warnings);
    }

    /**
     * Writes the scene.
     *
     * @param os where to
     * @throws IOException if it cannot be written
     * @throws UnsupportedOperationException if an object or a light has no form in POV-Ray; the message names it
     */
    public void write(SceneWriter os) throws IOException {
        int width = camera.width();
        int height = camera.height();
        os.writeString("// Written by SimpleRay for POV-Ray 3.7 (channels shown: " + shown + "). Render it with:\n"
            + "// povray +IFILE.pov +OFILE.png +W" + width + " +H" + height + " -A -D +FN8 File_Gamma=1.0"
            + (scene.settings.isTransparent() ? " +UA" : "") + "\n#version 3.7;\n"
            + "global_settings { assumed_gamma 1 max_trace_level " + (depth + 1) + " adc_bailout 0 ambient_light rgb 1 }\n");
        Colour background = scene.settings.background == null ? new Colour() : scene.settings.background;
        PovWriter.colour(os, "background { ", shown.of(background));
        os.writeString(scene.settings.isTransparent() ? " transmit 1 }\n" : " }\n");
        PovWriter.camera(os, camera);
        for (int i = 0; i < scene.getNumberLights(); i++) {
            PovWriter.light(os, scene.getLight(i), i, shown.of(scene.getLight(i).intensity));
        }
        Map<String, String> names = new HashMap<>();
        Map<String, List<Integer>> panes = new LinkedHashMap<>();
        for (int i = 0; i < materials.size(); i++) {
            PovMaterial material = materials.get(i);
            Object object = objects.get(i);
            String look = declared(os, names, material.look());
            if (material.dims()) {                            // the twin first: of things around the eye, the last counts
                String shade = declared(os, names, material.shade(object.isSolid()));
                PovWriter.shape(os, object, places.get(i));
                os.writeString(" material { " + shade + " } no_image no_reflection }\n");
            }
            if (isPane(i)) {
                panes.computeIfAbsent(look, k -> new ArrayList<>()).add(i);
                continue;
            }
            PovWriter.shape(os, object, places.get(i));
            os.writeString(" material { " + look + (material.transmits ? " } no_shadow }\n" : " } }\n"));
        }
        for (Map.Entry<String, List<Integer>> body : panes.entrySet()) {
            os.writeString("union {\n");
            for (int i : body.getValue()) {
                PovWriter.shape(os, objects.get(i), places.get(i));
                os.writeString(" }\n");
            }
            os.writeString("material { " + body.getKey() + " } no_shadow }\n");
        }
    }

    /** {@return whether an object bends rays and is not closed itself: those of one material are taken for one closed body} */
    private boolean isPane(int i) {
        Object object = objects.get(i);
        return materials.get(i).bends() && !object.isSolid() && object.bounds() != null;
    }

    /** {@return the name of a material, which is declared when it first comes} */
    private static String declared(SceneWriter os, Map<String, String> names, String text) throws IOException {
        String name = names.get(text);
        if (name == null) {
            name = "M" + (names.size() + 1);
            names.put(text, name);
            os.writeString("#declare " + name + " = material { " + text + " }\n");
        }
        return name;
    }

    /** Finds the depth that stands for those that the materials grant; POV-Ray has one for all of them. */
    private int commonDepth(int most) {
        TreeMap<Integer, List<Integer>> granted = new TreeMap<>();
        for (int i = 0; i < materials.size(); i++) {
            if (materials.get(i).follows) {
                int grants = Math.min(most, objects.get(i).surfaceMaterial.reflections());
                granted.computeIfAbsent(grants, k -> new ArrayList<>()).add(i);
            }
        }
        if (granted.isEmpty()) {
            return 0;
        }
        int common = granted.lastKey();
        granted.headMap(common).forEach((grants, which) -> warn(which, "grants", "grant", grants
            + " reflections by shininess, and other materials " + common + ": POV-Ray has one depth for all. With --depth "
            + granted.firstKey() + " both make the same picture"));
        if (common > MAX_DEPTH) {
            warnings.add("POV-Ray follows " + MAX_DEPTH + " reflections at most, and here are " + common);
            return MAX_DEPTH;
        }
        return common;
    }

    private void warnOfColours() {
        List<Integer> which = new ArrayList<>();
        for (int i = 0; i < materials.size(); i++) {
            if (!materials.get(i).isExact()) {
                which.add(i);
            }
        }
        warn(which, "has", "have", "a coloured highlight, or glass that scatters light: POV-Ray takes a mean of the colours. "
            + "With --channel r, g and b it is exact");
    }

    private void warnOfGlass() {
        List<Integer> clear = new ArrayList<>();
        List<Integer> open = new ArrayList<>();
        List<Integer> lit = new ArrayList<>();
        List<Integer> seenThrough = new ArrayList<>();
        for (int i = 0; i < materials.size(); i++) {
            if (isPane(i)) {
                open.add(i);
            } else if (materials.get(i).bends()) {
                clear.add(i);
            }
            if (materials.get(i).dims() && holdsLight(objects.get(i))) {
                lit.add(i);
            }
            if (materials.get(i).transmits && scene.settings.isTransparent()) {
                seenThrough.add(i);
            }
        }
        warn(open, "is", "are", "open glass, maybe: those of one material are taken for one closed body, for in POV-Ray a ray "
            + "enters at the first hit and leaves at the next, from whichever side");
        warn(lit, "may hold", "may hold", "a light inside: in POV-Ray glass dims only light from outside");
        warn(seenThrough, "lets", "let", "light through: POV-Ray's picture is transparent where nothing is behind, and here the surface itself is seen");
        warn(touching(clear), "lies", "lie", "in or across other glass, maybe: in POV-Ray a ray then goes from glass to glass, "
            + "here always to or from air");
    }

    private boolean holdsLight(Object object) {
        Bounds box = object.bounds();
        for (int i = 0; i < scene.getNumberLights() && object.isSolid(); i++) {
            Light light = scene.getLight(i);
            if (light instanceof PointLight lamp && (box == null || box.contains(lamp.origin))
                    || light instanceof AreaLight area && meet(box, bounds(area))) {
                return true;
            }
        }
        return false;
    }

    private static Bounds bounds(AreaLight area) {
        Point other = Point.add(area.corner, area.u);
        return Bounds.of(area.corner, other, Point.add(area.corner, area.v), Point.add(other, area.v));
    }

    /** {@return those whose boxes meet the box of another} */
    private List<Integer> touching(List<Integer> which) {
        TreeSet<Integer> found = new TreeSet<>();
        for (int i : which) {
            for (int j : which) {
                if (i < j && meet(objects.get(i).bounds(), objects.get(j).bounds())) {
                    found.add(i);
                    found.add(j);
                }
            }
        }
        return List.copyOf(found);
    }

    private static boolean meet(Bounds a, Bounds b) {
        return a == null || b == null || a.xmin() <= b.xmax() && b.xmin() <= a.xmax() && a.ymin() <= b.ymax() && b.ymin() <= a.ymax()
            && a.zmin() <= b.zmax() && b.zmin() <= a.zmax();
    }

    /** Notes a warning about objects; about none of them there is none. */
    private void warn(List<Integer> pieces, String verb, String verbs, String what) {
        if (pieces.isEmpty()) {
            return;
        }
        List<Integer> which = pieces.stream().map(places::get).distinct().toList();
        StringBuilder line = new StringBuilder(which.size() == 1 ? "object " : "objects ");
        for (int k = 0; k < Math.min(which.size(), MAX_NAMED); k++) {
            line.append(k == 0 ? "" : ", ").append(which.get(k) + 1);
        }
        line.append(which.size() > MAX_NAMED ? " and " + (which.size() - MAX_NAMED) + " more " : " ");
        warnings.add(line.append(which.size() == 1 ? verb : verbs).append(' ').append(what).toString());
    }
}
