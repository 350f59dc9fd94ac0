package simpleray.scene;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static simpleray.text.SceneText.reader;
import static simpleray.text.SceneText.written;

import java.io.IOException;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Objects of one file whose materials are equal have one material. */
class MaterialsTest {
    private static final String MATT = "1 1 1  0.5 0.5 0.5  0 0 0  2";

    @Test
    void objectsOfAnyKindShareEqualMaterials() throws IOException {
        Scene scene = read("5\n0 0 0 0 1 " + MATT + "\n0 5 0 0 2 1.0 1e0 1  .5 0.50 5e-1  0 0 0  2.0\n1 0 1 0 0 " + MATT
            + "\n2 0 0 0 1 0 0 0 1 0 " + MATT + "\n3 0 0 0 1 0 0 1 " + MATT + "\n0 0 0\n0\n");

        assertThat(materials(scene)).hasSize(5).containsOnly(scene.getObject(0).surfaceMaterial);
        assertThat(SceneBits.of(scene.getObject(4).surfaceMaterial)).isEqualTo(SceneBits.of(material(MATT)));
    }

    @ParameterizedTest
    @ValueSource(strings = {"0.9 1 1  0.5 0.5 0.5  0 0 0  2", "1 1 0.9  0.5 0.5 0.5  0 0 0  2", "1 1 1  0.5 0.4 0.5  0 0 0  2",
        "1 1 1  0.5 0.5 0.5  0 0 0.1  2", "1 1 1  0.5 0.5 0.5  0 -0.0 0  2", "1 1 1  0.5 0.5 0.5  0 0 0  2.0000000000000004",
        MATT + " transmit 0 0 0 1.5", MATT + " transmit 0 0.5 0 1", MATT + " transmit -0.0 0 0 1", MATT + " mirror 0 0 0",
        MATT + " mirror 0 0 0.5"})
    void whatDiffersInOneBitIsNotShared(String other) throws IOException {
        Scene scene = read("3\n0 0 0 0 1 " + MATT + "\n0 0 0 0 1 " + other + "\n0 0 0 0 1 " + MATT + "\n0 0 0\n0\n");

        assertThat(scene.getObject(1).surfaceMaterial).isNotSameAs(scene.getObject(0).surfaceMaterial);
        assertThat(scene.getObject(2).surfaceMaterial).isSameAs(scene.getObject(0).surfaceMaterial);
        assertThat(SceneBits.of(scene.getObject(1).surfaceMaterial)).isEqualTo(SceneBits.of(material(other)));
        assertThat(SceneBits.of(scene.getObject(2).surfaceMaterial)).isEqualTo(SceneBits.of(material(MATT)));
    }

    @Test
    void twoFilesShareNothing() throws IOException {
        String file = "1\n0 0 0 0 1 " + MATT + "\n0 0 0\n0\n";

        assertThat(read(file).getObject(0).surfaceMaterial).isNotSameAs(read(file).getObject(0).surfaceMaterial);
    }

    @Test
    void aSceneIsWrittenTheSameWhetherItsObjectsShareOrNot() throws IOException {
        Scene apart = Scenes.of(new Sphere(), new Plane(), new Cylinder());
        Scene shared = read(written(apart::write));

        assertThat(new HashSet<>(materials(apart))).hasSize(3);
        assertThat(new HashSet<>(materials(shared))).hasSize(1);
        assertThat(written(shared::write)).isEqualTo(written(apart::write));
    }

    @Test
    void thousandsOfMaterialsAreEachThereOnce() throws IOException {
        int many = 3000;
        StringBuilder file = new StringBuilder(2 * many + "\n");
        for (int i = 0; i < 2 * many; i++) {
            file.append("0 0 0 0 1 1 1 1 1 1 1 0 0 0.").append(1000 + i % many).append(" 2\n");
        }
        List<Material> materials = materials(read(file + "0 0 0\n0\n"));

        assertThat(new HashSet<>(materials)).hasSize(many);
        for (int i = 0; i < many; i++) {
            assertThat(materials.get(many + i)).isSameAs(materials.get(i));
            assertThat(materials.get(i).specular.b).isEqualTo(Double.parseDouble("0." + (1000 + i)));
        }
    }

    @Test
    void materialsThatAllCollideAreReadAndNotAllShared() throws IOException {
        int many = 300;
        List<String> colliding = new ArrayList<>();
        for (int i = 0; colliding.size() < many; i++) {
            String text = "1 1 1 1 1 1 0 0 0 " + i;
            Material material = new Material();
            material.shininess = i;
            if ((Materials.hash(material) & 1023) == 0) {
                colliding.add(text);
            }
        }
        String spheres = "0 0 0 0 1 " + String.join("\n0 0 0 0 1 ", colliding) + '\n';
        List<Material> materials = materials(read(2 * many + "\n" + spheres + spheres + "0 0 0\n0\n"));

        Set<Material> distinct = new HashSet<>(materials);
        assertThat(distinct).hasSizeBetween(many + 1, 2 * many - 1);
        for (int i = 0; i < many; i++) {
            assertThat(materials.get(many + i).shininess).isEqualTo(materials.get(i).shininess);
            assertThat(written(materials.get(i)::write)).isEqualTo(written(material(colliding.get(i))::write));
        }
    }

    @Test
    void anErrorAmongTwentyThousandObjectsIsFoundWhereItIs() {
        int many = 20_000;
        int bad = 17_654;
        String sphere = "0 0.25 -1.5e2 7 0.5  " + MATT + '\n';
        String file = many + "\n" + sphere.repeat(bad - 1) + "0 0.25 -1.5e2 7 0.5  1 1 1  0.5 ab 0.5  0 0 0  2\n"
            + sphere.repeat(many - bad) + "0 0 0\n0\n";

        assertThatThrownBy(() -> read(file)).hasMessage("<stdin>:17655:33: error: expected object 17654's diffuse green, found 'ab'\n"
            + "0 0.25 -1.5e2 7 0.5  1 1 1  0.5 ab 0.5  0 0 0  2\n" + " ".repeat(32) + '^');
    }

    @Test
    void readingAMaterialAnewForgetsItsTransmission() throws IOException {
        Material material = material(MATT + " transmit 1 1 1 1.5");
        material.read(reader(MATT));

        assertThat(SceneBits.of(material)).isEqualTo(SceneBits.of(material(MATT)));
    }

    private static List<Material> materials(Scene scene) {
        List<Material> materials = new ArrayList<>();
        for (int i = 0; i < scene.getNumberObjects(); i++) {
            materials.add(scene.getObject(i).surfaceMaterial);
        }
        return materials;
    }

    private static Material material(String text) throws IOException {
        Material material = new Material();
        material.read(reader(text));
        return material;
    }

    private static Scene read(String text) throws IOException {
        Scene scene = new Scene();
        scene.read(reader(text));
        return scene;
    }
}
