package simpleray.trace;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Random;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import simpleray.Sample;
import simpleray.math.Point;
import simpleray.math.Ray;
import simpleray.math.Vector;
import simpleray.scene.BruteForceIntersector;
import simpleray.scene.Cone;
import simpleray.scene.Hit;
import simpleray.scene.Material;
import simpleray.scene.RayStats;
import simpleray.scene.Scene;
import simpleray.scene.Scenes;

/** A cone's side goes on a little beyond its rims, and there too it is found in any structure: rays from near and far, many of them grazing. */
class AcceleratedIntersectorRimsTest {
    private final Random random = new Random(17);

    private Vector direction() {
        return new Vector(random.nextGaussian(), random.nextGaussian(), random.nextGaussian()).normalised();
    }

    @ParameterizedTest
    @ValueSource(doubles = {1, 1e3, 1e5, 1e7})
    void aRayAtARimHitsTheSameInAnyStructure(double far) {
        int hits = 0;
        for (int i = 0; i < Sample.size(200, 40); i++) {
            double length = Math.pow(10, random.nextInt(5) - 3);
            Cone[] cones = new Cone[12];
            for (int k = 0; k < cones.length; k++) {
                Vector along = direction();
                Point start = new Point(3 * random.nextGaussian(), 3 * random.nextGaussian(), 3 * random.nextGaussian());
                Point end = Point.add(start, Vector.scale(along, length));
                cones[k] = new Cone(new Material(), start, random.nextInt(3) / 2.0, end, random.nextDouble());
            }
            Scene scene = Scenes.of(cones);
            for (CompiledScene.Structure structure : CompiledScene.Structure.values()) {
                CompiledScene compiled = new CompiledScene(scene, new Point(0, 0, 9), 1, structure, false);
                for (int k = 0; k < 40; k++) {
                    Cone cone = cones[random.nextInt(cones.length)];
                    Vector axis = Vector.subtract(cone.end, cone.start).normalised();
                    Vector across = Vector.cross(axis, direction()).normalised();
                    Point rim = k % 2 == 0 ? Point.add(cone.start, Vector.scale(across, cone.startRadius))
                        : Point.add(cone.end, Vector.scale(across, cone.endRadius));
                    Vector round = Vector.cross(axis, across);       // along the rim: rays there graze
                    Vector aside = Vector.scale(direction(), Math.pow(10, -random.nextInt(9)));
                    Vector d = k % 4 < 2 ? direction() : Vector.add(round, aside).normalised();
                    Ray ray = new Ray(Point.add(rim, Vector.scale(d, -far * (1 + random.nextDouble()))), d);
                    Hit expected = new Hit();
                    Hit hit = new Hit();
                    hits += new BruteForceIntersector(scene).intersect(ray, expected) ? 1 : 0;
                    compiled.intersector(new RayStats()).intersect(ray, hit);
                    assertThat(hit.place).as("scene %d, ray %d, %s", i, k, structure).isEqualTo(expected.place);
                    assertThat(hit.t).isEqualTo(expected.t);
                }
            }
        }
        assertThat(hits).isGreaterThan(100);
    }
}
