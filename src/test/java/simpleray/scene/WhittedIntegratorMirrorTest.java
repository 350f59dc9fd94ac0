package simpleray.scene;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static simpleray.scene.Scenes.LIGHTING;
import static simpleray.scene.Scenes.ahead;
import static simpleray.scene.Scenes.glass;
import static simpleray.scene.Scenes.glowing;
import static simpleray.scene.Scenes.grey;
import static simpleray.scene.Scenes.light;
import static simpleray.scene.Scenes.lit;
import static simpleray.scene.Scenes.material;
import static simpleray.scene.Scenes.pointLight;
import static simpleray.scene.Scenes.ray;
import static simpleray.scene.Scenes.seen;
import static simpleray.scene.Scenes.wall;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import simpleray.math.Colour;

/** A material's {@code mirror} is the mirror ray's share in place of Ks; Ks shapes the highlight alone. */
class WhittedIntegratorMirrorTest {
    private static final int DEPTH = 10;

    private static Material shiny(double specular, Colour mirror, double shininess) {
        Material material = material(grey(0), grey(0), grey(specular), shininess);
        material.mirror = mirror;
        return material;
    }

    @Test
    void itIsTheShareOfTheMirrorRay() {
        Scene scene = lit(wall(shiny(1, new Colour(0.5, 0.25, 0), 1), 0), wall(glowing(0.5), 4));

        assertThat(seen(scene, ahead(), DEPTH, Terms.ALL)).hasToString("(0.25,0.125,0.0)");
    }

    @Test
    void aMirrorNeedsNoHighlight() {
        // the lamp at the eye has its highlight straight ahead: there is none, for Ks is black
        Scene scene = lit(wall(shiny(0, grey(0.5), 1), 0), wall(glowing(0.5), 4));
        light(scene, pointLight(0, 0, 2));

        assertThat(seen(scene, ahead(), DEPTH, Terms.ALL)).hasToString("(0.25,0.25,0.25)");
        assertThat(seen(scene, ahead(), DEPTH, LIGHTING)).hasToString("(0.0,0.0,0.0)");
    }

    @Test
    void aHighlightNeedsNoMirror() {
        Scene scene = lit(wall(shiny(0.75, grey(0), 50), 0), wall(glowing(0.5), 4));
        light(scene, pointLight(0, 0, 2));
        RayStats stats = new RayStats();
        Colour colour = new Colour();
        new WhittedIntegrator(scene, new BruteForceIntersector(scene), Terms.ALL, stats, null).trace(ahead(), colour, DEPTH);

        assertThat(colour).as("the highlight of Ks alone").hasToString("(0.75,0.75,0.75)");
        assertThat(stats.reflected).as("no ray is traced for a share of nothing").isZero();
    }

    /** Two mirrors of Ka = 1 that face each other, as in {@link WhittedIntegratorReflectionTest}. */
    @ParameterizedTest
    @CsvSource({"0, 10, 1", "1, 10, 1.5", "3, 10, 1.875", "10, 0.9, 1", "10, 1.999, 1.5", "10, 3, 1.875"})
    void depthAndShininessCountItsReflections(int depth, double shininess, double expected) {
        Material mirror = shiny(0.125, grey(0.5), shininess);
        mirror.ambient = grey(1);

        assertThat(seen(lit(wall(mirror, 0), wall(mirror, 4)), ahead(), depth, Terms.ALL).g).isEqualTo(expected);
    }

    /** The critical angle of n = 1.5 has the sine 2/3; below the glass there is a light of 0.25, above it one of 1. */
    @ParameterizedTest
    @CsvSource({"0.5, 0.125, 0.53125", "0.8, 0.125, 0.15625", "0.5, 0, 0.5", "0.8, 0, 0.125"})
    void atTotalReflectionItCarriesKtToo(double sin, double mirror, double expected) {
        Material glass = glass(0.75, 0.5, 1.5);
        glass.mirror = grey(mirror);
        Scene scene = lit(wall(glass, 0), wall(glowing(1), 5), wall(glowing(0.25), -5));
        double cos = Math.sqrt(1 - sin * sin);

        assertThat(seen(scene, ray(-sin, 0, -cos, sin, 0, cos), DEPTH, Terms.ALL).r).isEqualTo(expected, within(1e-14));
    }

    @Test
    void theRayTreeHasItsShare() {
        Scene scene = lit(wall(shiny(1, new Colour(0.5, 0.25, 0), 1), 0), wall(glowing(0.5), 4));
        RayTreeRecorder recorder = new RayTreeRecorder(scene);
        new WhittedIntegrator(scene, new BruteForceIntersector(scene), Terms.ALL, new RayStats(), recorder)
            .trace(ahead(), new Colour(), DEPTH);

        assertThat(recorder.tree().hit().mirror().share()).hasToString("(0.5,0.25,0.0)");
    }
}
