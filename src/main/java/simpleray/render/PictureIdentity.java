package simpleray.render;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import simpleray.scene.Scene;
import simpleray.scene.SceneHash;
import simpleray.scene.SceneSettings;
import simpleray.scene.Setting;

/** All that decides a picture's pixels, as names and values: two pictures of which all are equal are the same. */
public final class PictureIdentity {
    /** The name of the value that stands for the scene. */
    static final String SCENE = "scene";

    private PictureIdentity() {
    }

    /**
     * Finds what decides a picture.
     *
     * @param version the program's version
     * @param request what was asked for
     * @param scene the scene, with its own settings
     * @return names and values, in the order in which people are told
     */
    public static Map<String, String> of(String version, RenderRequest request, Scene scene) {
        SceneSettings all = scene.settings.under(request.settings());
        Map<String, String> identity = new LinkedHashMap<>();
        identity.put("version", version);
        identity.put(SCENE, SceneHash.of(scene));
        for (Setting<?> setting : Setting.ALL) {
            String value = setting == Setting.SAMPLES && request.adaptive() ? "adaptive" : setting.identity(all);
            if (value != null) {
                identity.put(setting.name(), value);
            }
            if (setting == Setting.RESOLUTION) {
                if (request.region() != null) {
                    identity.put("region", request.region().toString());
                }
                if (request.band() != null) {
                    identity.put("band", request.band().toString());
                }
                identity.put("stage", request.stage().toString());
            }
        }
        return identity;
    }

    /**
     * Says in what two pictures differ.
     *
     * @param was what decides one
     * @param now what decides the other
     * @return such as {@code another scene, depth 10 (now 3)}; empty if they are the same
     */
    public static String difference(Map<String, String> was, Map<String, String> now) {
        return difference(was, now, "now");
    }

    /**
     * Says in what two pictures differ.
     *
     * @param one what decides one
     * @param other what decides the other
     * @param where what stands before the values of the other
     * @return such as {@code another scene, depth 10 (there 3)}; empty if they are the same
     */
    public static String difference(Map<String, String> one, Map<String, String> other, String where) {
        Map<String, String> names = new LinkedHashMap<>(one);
        other.forEach(names::putIfAbsent);
        List<String> differences = new ArrayList<>();
        for (String name : names.keySet()) {
            String here = one.get(name);
            String there = other.get(name);
            if (here == null || there == null) {
                differences.add((here == null ? "no " : "a ") + name);
            } else if (!here.equals(there)) {
                differences.add(name.equals(SCENE) ? "another scene" : name + ' ' + here + " (" + where + ' ' + there + ')');
            }
        }
        return String.join(", ", differences);
    }
}
