package simpleray.scene;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import simpleray.math.Point;

/** Which kinds of objects have an inside. */
class ObjectTest {
    private static final double[] CORNERS = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};
    /** Each corner of a cube cut off: four triangles that look outward. */
    private static final int[] CLOSED = {0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3};

    @Test
    void spheresAndCylindersHaveAnInsidePlanesTrianglesAndConesNone() {
        assertThat(new Sphere().isSolid()).isTrue();
        assertThat(new Cylinder().isSolid()).isTrue();
        assertThat(new Plane().isSolid()).isFalse();
        assertThat(new Triangle().isSolid()).isFalse();
        assertThat(new Cone().isSolid()).isFalse();
    }

    @Test
    void aMeshHasAnInsideIfEachEdgeIsThereInBothDirections() {
        assertThat(mesh(new Triangles(CORNERS, CLOSED, new double[0], null)).isSolid()).isTrue();
        for (int left = 0; left < 12; left += 3) {
            int[] open = new int[9];
            System.arraycopy(CLOSED, 0, open, 0, left);
            System.arraycopy(CLOSED, left + 3, open, left, 9 - left);
            assertThat(mesh(new Triangles(CORNERS, open, new double[0], null)).isSolid()).isFalse();
            int[] turned = CLOSED.clone();
            turned[left] = CLOSED[left + 1];
            turned[left + 1] = CLOSED[left];
            assertThat(mesh(new Triangles(CORNERS, turned, new double[0], null)).isSolid()).isFalse();
        }
    }

    private static Mesh mesh(Triangles triangles) {
        return new Mesh(new Material(), "a.obj", new Point(), 1, triangles);
    }
}
