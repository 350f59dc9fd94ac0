package simpleray.scene;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import simpleray.math.Point;
import simpleray.math.Ray;
import simpleray.math.Vector;

/** A wall with a doorway: as one concave polygon, and as its three convex parts. */
class MeshConcaveTest {
    private static final String CORNERS = "v -2 -1 0\nv -0.5 -1 0\nv -0.5 0.5 0\nv 0.5 0.5 0\nv 0.5 -1 0\nv 2 -1 0\nv 2 1.5 0\nv -2 1.5 0\n";
    private static final String PARTS = "f 1 2 3 8\nf 3 4 7 8\nf 4 5 6 7\n";
    private static final String BACKWARDS = "f 8 3 2 1\nf 8 7 4 3\nf 7 6 5 4\n";
    private static final double ERROR = 1e-12;

    private static Mesh mesh(String obj, double scale) throws IOException {
        Triangles triangles = ObjReader.read(new ByteArrayInputStream(obj.getBytes(StandardCharsets.UTF_8)), "wall.obj", warning -> {
            throw new AssertionError(warning);
        });
        return new Mesh(new Material(), "", new Point(0.25, -0.5, 1), scale, triangles);
    }

    @ParameterizedTest
    @CsvSource({"f 1 2 3 4 5 6 7 8, false, 1", "f 5 6 7 8 1 2 3 4, false, -3", "f 8 7 6 5 4 3 2 1, true, 1e-3", "f 3 2 1 8 7 6 5 4, true, -0.5"})
    void itIsHitWhereItsPartsAre(String polygon, boolean backwards, double scale) throws IOException {
        Mesh wall = mesh(CORNERS + polygon, scale);
        Mesh parts = mesh(CORNERS + (backwards ? BACKWARDS : PARTS), scale);
        for (int i = 0; i < 2500; i++) {
            Point from = new Point(0.25 + (i % 50 / 10.0 - 2.5) * scale, -0.5 + (i / 50 / 10.0 - 2.5) * scale, 8);
            Ray ray = new Ray(from, new Vector(0.01 * scale, 0.02 * scale, -1).normalised());
            Hit hit = new Hit();
            Hit expected = new Hit();
            wall.intersect(ray, 0, hit);
            parts.intersect(ray, 0, expected);

            assertThat(hit.place).as("ray %s", i).isEqualTo(expected.place);
            if (hit.place != Hit.NONE) {
                assertThat(hit.t).isCloseTo(expected.t, within(ERROR));
                Interaction at = new Interaction();
                at.set(ray, hit, wall);
                Vector outward = new Vector(at.outward);
                at.set(ray, expected, parts);
                assertThat(outward.dot(at.outward)).as("the side that is outside").isCloseTo(1, within(ERROR));
            }
        }
    }

    /** No ray passes between the triangles, wherever they are cut. */
    @ParameterizedTest
    @CsvSource({"f 1 2 3 4 5 6 7 8", "f 4 3 2 1 8 7 6 5"})
    void itHasNoSeams(String polygon) throws IOException {
        String tilted = CORNERS.replaceAll("v (\\S+) (\\S+) 0", "v $1 $2 $1");
        Mesh wall = mesh(tilted + polygon, 1);
        int[] corners = wall.mesh().triangles.corners();
        for (int i = 0; i < corners.length; i++) {
            Point a = wall.vertex(i / 3, i % 3);
            Point b = wall.vertex(i / 3, (i + 1) % 3);
            for (int k = 1; k < 100; k++) {
                Vector to = new Vector(a.x + (b.x - a.x) * k / 100, a.y + (b.y - a.y) * k / 100 - 1, a.z + (b.z - a.z) * k / 100 - 9);
                boolean border = Math.abs(corners[i] - corners[i - i % 3 + (i + 1) % 3]) % 6 == 1;
                assertThat(border || wall.intersect(new Ray(new Point(0, 1, 9), to.normalised())) > 0).isTrue();
            }
        }
    }
}
