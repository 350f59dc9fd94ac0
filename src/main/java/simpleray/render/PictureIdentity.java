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
    private static final String SCENE = "scene";

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
