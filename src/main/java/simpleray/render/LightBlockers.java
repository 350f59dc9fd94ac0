package simpleray.render;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;
import simpleray.math.Point;
import simpleray.math.Ray;
import simpleray.math.Vector;
import simpleray.scene.Hit;
import simpleray.scene.Interaction;
import simpleray.scene.RayTree;
import simpleray.scene.RayTreeRecorder;
import simpleray.scene.Scene;
import simpleray.scene.VisibilityTester;

/** The shadow rays towards one light that were blocked, and what blocked them. <em>Mutable</em>, for one thread. */
final class LightBlockers {
    private static final int MAX = 256;

    private final List<Shadow> kept = new ArrayList<>();
    private int count;
    private int stride = 1;                                   // of how many one is kept

    /** A point that is turned to the light, the unit vector towards that, and how far something may block it. */
    private record Shadow(Point from, Vector towards, double end) {
    }

    /** Notes a blocked shadow ray; if there are many, some from all over the picture are kept. */
    void add(Interaction at, VisibilityTester visibility) {
        if (count++ % stride == 0) {
            if (kept.size() == MAX) {
                for (int i = MAX / 2; i > 0; i--) {
                    kept.remove(2 * i - 1);
                }
                stride *= 2;
            }
            kept.add(new Shadow(new Point(at.point), new Vector(visibility.towards), visibility.end));
        }
    }

    /** {@return what is in the way: the object that blocks most of the shadow rays, and whether there are others} */
    String told(Scene scene) {
        int[] blocked = IntStream.range(0, scene.getNumberObjects()).map(i -> blocked(scene, i)).toArray();
        int most = IntStream.range(0, blocked.length).reduce(0, (one, other) -> blocked[other] > blocked[one] ? other : one);
        RayTree.Thing thing = RayTreeRecorder.object(scene, most);
        return "object " + thing.number() + " (" + thing.kind() + (thing.line() > 0 ? ", line " + thing.line() : "")
            + (blocked[most] == kept.size() ? ") is in the way" : ") and others are in the way");
    }

    private int blocked(Scene scene, int object) {
        return (int) kept.stream().filter(shadow ->
            scene.getObject(object).occludes(new Ray(shadow.from, shadow.towards), shadow.end, new Hit())).count();
    }
}
