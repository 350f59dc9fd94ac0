package simpleray.scene;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;
import static simpleray.scene.Scenes.glass;
import static simpleray.scene.Scenes.lit;
import static simpleray.scene.Scenes.ray;
import static simpleray.text.SceneText.reader;

import java.util.ArrayList;
import java.util.List;
import org.assertj.core.data.Offset;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import simpleray.math.Colour;
import simpleray.math.Point;
import simpleray.math.Ray;

/** A bubble of air in glass is a mesh of negative scale and of the glass's index. */
class MeshBubbleTest {
    private static final Offset<Double> ROUNDING = within(1e-12);
    /** A cube from -1 to 1, its faces anticlockwise as seen from outside. */
    private static final Triangles CUBE = new Triangles(
        new double[] {-1, -1, -1, 1, -1, -1, 1, 1, -1, -1, 1, -1, -1, -1, 1, 1, -1, 1, 1, 1, 1, -1, 1, 1},
        new int[] {0, 3, 2, 0, 2, 1, 4, 5, 6, 4, 6, 7, 0, 1, 5, 0, 5, 4, 1, 2, 6, 1, 6, 5, 2, 3, 7, 2, 7, 6, 3, 0, 4, 3, 4, 7},
        new double[0], null);

    private static Mesh cube(double scale) {
        return new Mesh(glass(0, 1, 1.5), "cube.obj", new Point(), scale, CUBE);
    }

    /** {@return the rays of a path, each the next one's refracted or, where it has none, its mirror ray} */
    private static List<RayTree> path(Ray ray, Object... objects) {
        Scene scene = lit(objects);
        RayTreeRecorder recorder = new RayTreeRecorder(scene);
        new WhittedIntegrator(scene, new BruteForceIntersector(scene), Terms.ALL, new RayStats(), recorder).trace(ray, new Colour(), 10);
        List<RayTree> path = new ArrayList<>();
        for (RayTree tree = recorder.tree(); tree != null;) {
            path.add(tree);
            RayTree.Hit hit = tree.hit();
            RayTree.Next next = hit == null ? null : hit.refracted() != null ? hit.refracted() : hit.mirror();
            tree = next == null ? null : next.tree();
        }
        return path;
    }

    /** Into the glass, into the bubble, out of it, out of the glass: within the bubble the ray has its direction again. */
    @ParameterizedTest
    @ValueSource(doubles = {0, 0.1, 0.6, 0.65})
    void inTheBubbleARayHasTheDirectionThatItHasOutside(double sin) {
        double cos = Math.sqrt(1 - sin * sin);
        List<RayTree> path = path(ray(-11 * sin, 0, 9 + cos, sin, 0, -cos), cube(9), cube(-5));

        assertThat(path).hasSize(5);
        assertThat(path).extracting(tree -> tree.ray().direction.x)
            .usingComparatorForType((x, y) -> Math.abs(x - y) < 1e-12 ? 0 : 1, Double.class)
            .containsExactly(sin, sin / 1.5, sin, sin / 1.5, sin);
        assertThat(path.get(2).ray().origin.z).isEqualTo(5, ROUNDING);
        assertThat(path.get(3).ray().origin.z).isEqualTo(-5, ROUNDING);
    }

    @Test
    void ofAPositiveScaleItWouldBeGlassInGlass() {
        List<RayTree> path = path(ray(-0.6, 0, 9.8, 0.6, 0, -0.8), cube(9), cube(5));

        assertThat(path.get(2).ray().direction.x).as("bent a second time").isEqualTo(0.6 / 1.5 / 1.5, ROUNDING);
    }

    /** From within the glass, beyond the critical angle, whose sine is 1/1.5, the bubble is a mirror. */
    @Test
    void seenFromTheGlassTheBubbleMirrorsAtAFlatAngle() {
        List<RayTree> path = path(ray(-4, 0, 6, 0.8, 0, -0.6), cube(9), cube(-5));

        assertThat(path.get(1).ray().direction.z).isEqualTo(0.6, ROUNDING);
        assertThat(path.get(0).hit().refracted()).isNull();
    }

    @Test
    void anIndexBelow1PointsToWhereThisIsTold() {
        assertThatThrownBy(() -> new Scene().read(reader(
            "1\n0 0 0 0 1 0 0 0 0 0 0 0 0 0 9 transmit 1 1 1 0.667"))).hasMessageContaining("docs/pictures.md");
    }
}
