package simpleray.scene;

import static org.assertj.core.api.Assertions.assertThat;
import static simpleray.scene.Scenes.grey;
import static simpleray.scene.Scenes.material;
import static simpleray.scene.Scenes.wall;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import simpleray.math.Colour;
import simpleray.math.Point;
import simpleray.math.Ray;

/** What a storyteller asks of its probe, which may answer by where a ray comes from. */
class StoryProbeTest {
    private final List<String> asked = new ArrayList<>();

    private Story told(Scene scene, int depth) {
        Probe plain = Probe.of(scene);
        return new Storyteller(scene, new Probe() {
            @Override
            public int nearest(Ray ray, int level, boolean refracted) {
                asked.add(level + (refracted ? " refracted" : ""));
                return plain.nearest(ray, level, refracted);
            }

            @Override
            public double distance() {
                return plain.distance();
            }

            @Override
            public void dim(Colour light, Ray towards, double distance, int number) {
                plain.dim(light, towards, distance, number);
            }

            @Override
            public int[] between(Ray towards, double distance, int number) {
                return plain.between(towards, distance, number);
            }
        }, Terms.ALL).tell(Scenes.ahead(), depth);
    }

    @Test
    void eachReflectionIsALevelFartherFromTheEye() {
        told(Scenes.of(wall(material(grey(0), grey(0), grey(1), 9), 0), wall(material(grey(0), grey(0), grey(1), 9), 3)), 3);

        assertThat(asked).containsExactly("0", "1", "2", "3");
    }

    @Test
    void soIsEachRefraction() {
        Story story = told(Scenes.of(new Sphere(Scenes.glass(0, 1, 1.5), new Point(), 1)), 5);

        assertThat(asked).containsExactly("0", "1 refracted", "2 refracted");
        assertThat(story.hit().mirror()).as("a mirror ray that counts nothing").isNull();
        assertThat(story.hit().refracted().story().hit().mirror()).isNull();
    }
}
