package simpleray.scene;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.assertj.core.data.Offset;
import org.junit.jupiter.api.Test;
import simpleray.math.Point;
import simpleray.math.Vector;

class EyePathTest {
    private static final Offset<Double> ROUNDING = within(1e-9);
    private static final double MARGIN = 0.1;

    /** A floor at y = 0. */
    private final Scene floor = scene(new Plane(new Material(), new Vector(0, 1, 0), 0));
    /** That floor and a wall at x = 5. */
    private final Scene corner = scene(new Plane(new Material(), new Vector(0, 1, 0), 0),
        new Plane(new Material(), new Vector(1, 0, 0), 5));

    @Test
    void aFreeWayIsGoneToItsEnd() {
        assertEnd(floor, new Point(0, 1, 0), new Point(3, 2, 1), new Point(3, 2, 1));
        assertEnd(floor, new Point(0, 1, 0), new Point(0, 1, 0), new Point(0, 1, 0));
    }

    @Test
    void theEyeStopsBeforeASurfaceWhicheverSideItComesFrom() {
        assertEnd(floor, new Point(0, 1, 0), new Point(0, -1, 0), new Point(0, MARGIN, 0));
        assertEnd(floor, new Point(0, -1, 0), new Point(0, 1, 0), new Point(0, -MARGIN, 0));
        assertEnd(floor, new Point(0, 1, 0), new Point(0, 0.05, 0), new Point(0, MARGIN, 0));
    }

    @Test
    void itSlidesAlongASurface() {
        assertEnd(floor, new Point(0, 1, 0), new Point(3, -1, 2), new Point(3, MARGIN, 2));
    }

    @Test
    void itSlidesIntoACornerAndStaysThere() {
        assertEnd(corner, new Point(0, 1, 0), new Point(9, -3, 2), new Point(5 - MARGIN, MARGIN, 2));
    }

    @Test
    void anEyeThatIsNearerThanTheMarginComesNoNearerAndMayLeave() {
        assertEnd(floor, new Point(0, 0.01, 0), new Point(1, -1, 0), new Point(1, 0.01, 0));
        assertEnd(floor, new Point(0, 0.01, 0), new Point(1, 2, 0), new Point(1, 2, 0));
    }

    private static void assertEnd(Scene scene, Point from, Point to, Point expected) {
        Point end = EyePath.end(scene, from, to, MARGIN);
        assertThat(end.x).isCloseTo(expected.x, ROUNDING);
        assertThat(end.y).isCloseTo(expected.y, ROUNDING);
        assertThat(end.z).isCloseTo(expected.z, ROUNDING);
    }

    private static Scene scene(Object... objects) {
        Scene scene = new Scene();
        scene.setNumberObjects(objects.length);
        List<Object> all = List.of(objects);
        all.forEach(object -> scene.setObject(all.indexOf(object), object));
        return scene;
    }
}
