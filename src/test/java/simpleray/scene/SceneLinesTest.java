package simpleray.scene;

import static org.assertj.core.api.Assertions.assertThat;
import static simpleray.text.SceneText.reader;

import java.io.IOException;
import org.junit.jupiter.api.Test;

/** On which line of its file each object and light begins. */
class SceneLinesTest {
    private static final String MATERIAL = "  1 1 1  1 1 1  0 0 0  1\n";

    @Test
    void theLineIsThatOfTheCodeOfItsKind() throws IOException {
        Scene scene = new Scene();
        scene.read(reader("# a comment\n3 0 0 0 0 1" + MATERIAL + "a heading\n1\n0 1 0 2\n" + MATERIAL + "\n0 # here\n0 0 0 1" + MATERIAL
            + "1 1 1\n2\n0 1 1 1 0 0 0 1 1 1 1\n0 0 1\n"));

        assertThat(new int[] {scene.objectLine(0), scene.objectLine(1), scene.objectLine(2)}).containsExactly(2, 4, 8);
        assertThat(new int[] {scene.lightLine(0), scene.lightLine(1)}).containsExactly(12, 12);
    }

    @Test
    void whatIsPutInAnObjectsPlaceIsFromNoFile() throws IOException {
        Scene scene = new Scene();
        scene.read(reader("2 0 0 0 0 1" + MATERIAL + "0 0 0 0 1" + MATERIAL + "1 1 1  1  0 1 1 1 0 0 0"));
        scene.setObject(0, new Plane());
        scene.setLight(0, new PointLight());
        scene.setNumberObjects(3);
        scene.setObject(2, new Plane());

        assertThat(new int[] {scene.objectLine(0), scene.objectLine(1), scene.objectLine(2)}).containsExactly(0, 2, 0);
        assertThat(scene.lightLine(0)).isZero();
    }

    @Test
    void anotherFileHasOtherLines() throws IOException {
        Scene scene = new Scene();
        scene.read(reader("1 0 0 0 0 1" + MATERIAL + "1 1 1  0"));
        scene.read(reader("\n\n1\n0 0 0 0 1" + MATERIAL + "1 1 1  0"));

        assertThat(scene.objectLine(0)).isEqualTo(4);
    }

    @Test
    void anObjectIsNamedByNumberKindAndLineAndAForeignOneByItsClass() throws IOException {
        Scene scene = new Scene();
        scene.read(reader("1\n1 0 0 1 0" + MATERIAL + "1 1 1  0"));
        scene.setNumberObjects(2);
        scene.setObject(1, new StandIn());

        assertThat(RayTreeRecorder.object(scene, 0)).isEqualTo(new RayTree.Thing(1, "plane", 2));
        assertThat(RayTreeRecorder.object(scene, 1)).isEqualTo(new RayTree.Thing(2, "StandIn", 0));
    }
}
