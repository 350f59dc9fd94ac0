package simpleray.cli;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.stream.Collectors;
import simpleray.render.RenderStats;
import simpleray.scene.RayStats;

/** The statistics that {@code render --stats} prints. <em>Constant.</em> */
final class Stats {
    /** The format of the output. */
    enum Format {
        /** A line for each figure. */
        TEXT,
        /** One JSON object. */
        JSON;

        @Override
        public String toString() {
            return name().toLowerCase(Locale.ROOT);
        }
    }

    private final Map<String, Number> rays = new LinkedHashMap<>();
    private final Map<String, Number> seconds = new LinkedHashMap<>();
    private long[] depths = {};

    /**
     * Collects the statistics.
     *
     * @param readSeconds the time to read the scene
     * @param render the statistics of the rendering
     */
    Stats(double readSeconds, RenderStats render) {
        RayStats stats = render.rays();
        if (stats != null) {
            rays.put("primary", stats.primary);
            rays.put("reflected", stats.reflected);
            rays.put("refracted", stats.refracted);
            rays.put("shadow", stats.shadow);
            rays.put("testsPerRay", stats.rays() == 0 ? 0 : rounded((double) stats.tests / stats.rays()));
            rays.put("stepsPerRay", stats.rays() == 0 ? 0 : rounded((double) stats.steps / stats.rays()));
            depths = stats.depths.clone();
        }
        seconds.put("read", rounded(readSeconds));
        seconds.put("prepare", rounded(render.readySeconds()));
        seconds.put("renderAndWrite", rounded(render.renderSeconds()));
    }

    private static double rounded(double d) {
        return Math.rint(d * 1000) / 1000;
    }

    /** {@return the text, with its line ends} */
    String text(Format format) {
        return format == Format.JSON ? json() : lines();
    }

    private String json() {
        return "{\"rays\":" + (rays.isEmpty() ? "null" : object(rays)) + ",\"raysByDepth\":"
            + (rays.isEmpty() ? "null" : Arrays.stream(depths).mapToObj(Long::toString).collect(Collectors.joining(",", "[", "]")))
            + ",\"seconds\":" + object(seconds) + "}\n";
    }

    private static String object(Map<String, Number> map) {
        return map.entrySet().stream().map(e -> '"' + e.getKey() + "\":" + e.getValue()).collect(Collectors.joining(",", "{", "}"));
    }

    private String lines() {
        List<String> lines = new ArrayList<>();
        if (rays.isEmpty()) {
            lines.add("rays are not counted with --accel none");
        }
        rays.forEach((name, value) -> lines.add(switch (name) {
            case "testsPerRay" -> line("objects asked, a ray", value);
            case "stepsPerRay" -> line("cells or boxes passed, a ray", value);
            default -> line(name + " rays", value);
        }));
        for (int depth = 0; depth < depths.length; depth++) {
            lines.add(line("rays after " + depth + (depth == 1 ? " reflection" : " reflections"), depths[depth]));
        }
        lines.add(line("seconds to read the scene", seconds.get("read")));
        lines.add(line("seconds to prepare it", seconds.get("prepare")));
        lines.add(line("seconds to render and write", seconds.get("renderAndWrite")));
        return lines.stream().collect(Collectors.joining("\n", "", "\n"));
    }

    private static String line(String what, Number value) {
        return String.format(Locale.ROOT, "%-32s %12s", what, value);
    }
}
