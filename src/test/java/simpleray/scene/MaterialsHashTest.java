package simpleray.scene;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.function.BiConsumer;
import org.junit.jupiter.api.Test;
import simpleray.math.Colour;

/** Equal materials have one hash, and each number has its part in it. */
class MaterialsHashTest {
    private static final List<BiConsumer<Material, Double>> NUMBERS = List.of((m, d) -> m.ambient.r = d, (m, d) -> m.ambient.g = d,
        (m, d) -> m.ambient.b = d, (m, d) -> m.diffuse.r = d, (m, d) -> m.diffuse.g = d, (m, d) -> m.diffuse.b = d,
        (m, d) -> m.specular.r = d, (m, d) -> m.specular.g = d, (m, d) -> m.specular.b = d, (m, d) -> m.shininess = d,
        (m, d) -> m.transmission.r = d, (m, d) -> m.transmission.g = d, (m, d) -> m.transmission.b = d, (m, d) -> m.index = d,
        (m, d) -> m.mirror = new Colour(d, 0, 0), (m, d) -> m.mirror = new Colour(0, d, 0), (m, d) -> m.mirror = new Colour(0, 0, d));

    @Test
    void equalMaterialsHaveOneHash() {
        assertThat(Materials.hash(new Material())).isEqualTo(Materials.hash(new Material(new Material())));
    }

    @Test
    void eachNumberCounts() {
        for (BiConsumer<Material, Double> number : NUMBERS) {
            Material material = new Material();
            number.accept(material, 0.75);
            assertThat(Materials.hash(material)).isNotEqualTo(Materials.hash(new Material()));
        }
    }
}
