package simpleray.scene;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static simpleray.scene.Scenes.ahead;
import static simpleray.scene.Scenes.glowing;
import static simpleray.scene.Scenes.grey;
import static simpleray.scene.Scenes.ray;
import static simpleray.scene.Scenes.seen;
import static simpleray.scene.Scenes.wall;
import static simpleray.text.SceneText.written;

import org.junit.jupiter.api.Test;

/** The thesis's setNumberObjects, setObject and their like. */
class ScenePlacesTest {
    @Test
    void objectsAndLightsStandWhereTheyWerePut() {
        Scene scene = new Scene();
        Sphere sphere = new Sphere();
        Plane plane = new Plane();
        PointLight point = new PointLight();
        DirectionalLight directional = new DirectionalLight();
        scene.setNumberObjects(2);
        scene.setNumberLights(2);
        scene.setObject(1, plane);
        scene.setObject(0, sphere);
        scene.setLight(1, directional);
        scene.setLight(0, point);

        assertThat(scene.getNumberObjects()).isEqualTo(2);
        assertThat(scene.getNumberLights()).isEqualTo(2);
        assertThat(scene.getObject(0)).isSameAs(sphere);
        assertThat(scene.getObject(1)).isSameAs(plane);
        assertThat(scene.getLight(0)).isSameAs(point);
        assertThat(scene.getLight(1)).isSameAs(directional);
    }

    @Test
    void aSmallerNumberForgetsTheLast() {
        Scene scene = Scenes.of(wall(glowing(0.5), 1), wall(glowing(0.25), 0));
        scene.ambient = grey(1);
        scene.setNumberObjects(1);
        Scenes.light(scene, new PointLight(), new PointLight());
        scene.setNumberLights(0);

        assertThat(scene.getNumberObjects()).isEqualTo(1);
        assertThat(scene.getNumberLights()).isZero();
        assertThatThrownBy(() -> scene.getObject(1)).isInstanceOf(IndexOutOfBoundsException.class);
        assertThatThrownBy(() -> scene.getLight(0)).isInstanceOf(IndexOutOfBoundsException.class);
        assertThat(seen(scene, ray(0, 0, 0.5, 0, 0, -1), 0, Terms.ALL).isBlack()).isTrue();
    }

    @Test
    void thereAreOnlyThePlacesThatWereAskedFor() {
        Scene scene = new Scene();
        scene.setNumberObjects(1);

        assertThatThrownBy(() -> scene.setObject(1, new Sphere())).isInstanceOf(IndexOutOfBoundsException.class);
        assertThatThrownBy(() -> scene.setObject(-1, new Sphere())).isInstanceOf(IndexOutOfBoundsException.class);
        assertThatThrownBy(() -> scene.setLight(0, new PointLight())).isInstanceOf(IndexOutOfBoundsException.class);
    }

    @Test
    void aSceneWithObjectsAnnouncedAndNotSetIsNotRendered() {
        Scene scene = Scenes.of(wall(glowing(0.5), 1));
        scene.setNumberObjects(3);

        assertThatThrownBy(() -> seen(scene, ahead(), 0, Terms.ALL)).isInstanceOf(IllegalStateException.class)
            .hasMessage("of 3 places in the scene only 1 are set");
        assertThatThrownBy(() -> written(scene::write)).isInstanceOf(IllegalStateException.class);
        assertThatThrownBy(() -> written(scene::print)).isInstanceOf(IllegalStateException.class);
    }

    @Test
    void norIsOneWithLights() {
        Scene scene = Scenes.of(wall(glowing(0.5), 1));
        scene.setNumberLights(2);

        assertThatThrownBy(() -> seen(scene, ahead(), 0, Terms.ALL)).isInstanceOf(IllegalStateException.class)
            .hasMessage("of 2 places in the scene only 0 are set");
    }

    @Test
    void aNumberOfThingsIsZeroOrMore() {
        assertThatThrownBy(() -> new Scene().setNumberObjects(-1)).isInstanceOf(IllegalArgumentException.class)
            .hasMessage("a number of things must be 0 or more, and is -1");
        assertThatThrownBy(() -> new Scene().setNumberLights(-1)).isInstanceOf(IllegalArgumentException.class)
            .hasMessage("a number of things must be 0 or more, and is -1");
    }
}
