package simpleray.render;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import simpleray.math.Colour;
import simpleray.scene.PerspectiveCamera.Pose;
import simpleray.scene.Scene;
import simpleray.scene.SceneHash;
import simpleray.scene.SceneSettings;
import simpleray.scene.SceneSettings.Window;
import simpleray.scene.SimpleCamera;

/** All that decides a picture's pixels, as names and values: two pictures of which all are equal are the same. */
public final class PictureIdentity {
    private static final String SCENE = "scene";

    private PictureIdentity() {
    }

    /**
     * Finds what decides a picture.
     *
     * @param version the program's version
     * @param request what was asked for
     * @param scene the scene, of which {@link RenderRequest#renderer} was made
     * @return names and values, in the order in which people are told
     */
    public static Map<String, String> of(String version, RenderRequest request, Scene scene) {
        SceneSettings all = scene.settings;
        Map<String, String> identity = new LinkedHashMap<>();
        identity.put("version", version);
        identity.put(SCENE, SceneHash.of(scene));
        identity.put("size", all.resolution == null ? SimpleCamera.DEFAULT_RESOLUTION + "x" + SimpleCamera.DEFAULT_RESOLUTION
            : all.resolution.width() + "x" + all.resolution.height());
        if (request.region() != null) {
            identity.put("region", request.region().toString());
        }
        identity.put("stage", request.stage().toString());
        identity.put("depth", Integer.toString(all.depth == null ? RenderSettings.DEFAULT_DEPTH : all.depth));
        identity.put("samples", request.adaptive() ? "adaptive" : all.samples == null ? "1" : all.samples.toString());
        if (all.camera != null) {
            Pose pose = all.camera;
            identity.put("camera", numbers(pose.ex(), pose.ey(), pose.ez(), pose.lx(), pose.ly(), pose.lz(), pose.fov()));
        } else {
            Window window = all.window;
            identity.put("cop", numbers(all.cop == null ? SimpleCamera.DEFAULT_COP : all.cop));
            identity.put("window", window == null ? "default" : numbers(window.xmin(), window.xmax(), window.ymin(), window.ymax()));
        }
        Colour background = all.background == null ? new Colour() : all.background;
        identity.put("background", numbers(background.r, background.g, background.b));
        return identity;
    }

    private static String numbers(double... numbers) {
        StringBuilder text = new StringBuilder();
        for (double number : numbers) {
            text.append(text.length() == 0 ? "" : ",").append(number);
        }
        return text.toString();
    }

    /**
     * Says in what two pictures differ.
     *
     * @param was what decides one
     * @param now what decides the other
     * @return such as {@code another scene, depth 10 (now 3)}; empty if they are the same
     */
    public static String difference(Map<String, String> was, Map<String, String> now) {
        Map<String, String> names = new LinkedHashMap<>(was);
        now.forEach(names::putIfAbsent);
        List<String> differences = new ArrayList<>();
        for (String name : names.keySet()) {
            String one = was.get(name);
            String other = now.get(name);
            if (one == null || other == null) {
                differences.add((one == null ? "no " : "a ") + name);
            } else if (!one.equals(other)) {
                differences.add(name.equals(SCENE) ? "another scene" : name + ' ' + one + " (now " + other + ')');
            }
        }
        return String.join(", ", differences);
    }
}
