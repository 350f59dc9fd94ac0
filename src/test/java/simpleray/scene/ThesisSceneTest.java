package simpleray.scene;

import static org.assertj.core.api.Assertions.assertThat;
import static simpleray.text.SceneText.reader;
import static simpleray.text.SceneText.written;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import org.junit.jupiter.api.Test;
import simpleray.math.Colour;
import simpleray.math.Ray;
import simpleray.text.Diagnostic;
import simpleray.text.SceneReader;

class ThesisSceneTest {
    private static final int DEPTH = 10;
    private static final int SIDE = 64;

    @Test
    void itsInterpretationIsTheThesissToTheByte() throws IOException {
        assertThat(written(ThesisScene.read()::print))
            .isEqualTo(new String(ThesisScene.reference("thesis.interpretation.txt"), StandardCharsets.UTF_8));
    }

    @Test
    void itsThreeHeadingsAreSkippedWithAWarningEach() throws IOException {
        try (SceneReader is = ThesisScene.reader()) {
            new Scene().read(is);

            assertThat(is.warnings()).extracting(Diagnostic::toString).containsExactly("""
                thesis.scene:1:1: warning: expected a value or a comment, found the heading 'number of objects', which is skipped
                number of objects
                ^""", """
                thesis.scene:49:1: warning: expected a value or a comment, found the heading 'light 1 - point light', which is skipped
                light 1 - point light
                ^""", """
                thesis.scene:53:1: warning: expected a value or a comment, found the heading 'light 2 - directional light', which is skipped
                light 2 - directional light
                ^""");
        }
    }

    @Test
    void itsThreeTermsAddUpToItsLightingToTheLastBit() throws IOException {
        Scene scene = ThesisScene.read();
        SimpleCamera camera = new SimpleCamera(SIDE, SIDE);
        int lit = 0;
        for (int y = 0; y < SIDE; y++) {
            for (int x = 0; x < SIDE; x++) {
                Ray ray = camera.ray(x, y);
                Colour sum = Scenes.seen(scene, ray, DEPTH, new Terms(true, false, false, false, false));
                sum.add(Scenes.seen(scene, ray, DEPTH, new Terms(false, true, false, false, false)));
                Colour highlight = Scenes.seen(scene, ray, DEPTH, new Terms(false, false, true, false, false));
                sum.add(highlight);
                Colour lighting = Scenes.seen(scene, ray, DEPTH, Scenes.LIGHTING);
                assertThat(new Double[] {sum.r, sum.g, sum.b}).as("pixel (%d,%d)", x, y)
                    .isEqualTo(new Double[] {lighting.r, lighting.g, lighting.b});
                lit += highlight.isBlack() ? 0 : 1;
            }
        }
        assertThat(lit).as("pixels with a highlight").isPositive();
    }

    @Test
    void itsSideWallsShadowTheDirectionalLightEverywhere() throws IOException {
        Scene both = ThesisScene.read();
        Scene one = ThesisScene.read();
        one.setNumberLights(1);
        SimpleCamera camera = new SimpleCamera(SIDE, SIDE);
        int brighter = 0;
        for (int y = 0; y < SIDE; y++) {
            for (int x = 0; x < SIDE; x++) {
                Ray ray = camera.ray(x, y);
                assertThat(Scenes.seen(both, ray, DEPTH, Terms.ALL)).as("pixel (%d,%d)", x, y)
                    .hasToString(Scenes.seen(one, ray, DEPTH, Terms.ALL).toString());
                brighter += Scenes.seen(both, ray, DEPTH, Scenes.LIGHTING).r > Scenes.seen(one, ray, DEPTH, Scenes.LIGHTING).r ? 1 : 0;
            }
        }
        assertThat(brighter).as("pixels that it lights without shadows").isPositive();
    }

    @Test
    void itReadsBackWhatItWrites() throws IOException {
        Scene scene = ThesisScene.read();
        Scene again = new Scene();
        try (SceneReader is = reader(written(scene::write))) {
            again.read(is);
            assertThat(is.warnings()).isEmpty();
        }
        assertThat(SceneBits.of(again)).isEqualTo(SceneBits.of(scene));
    }
}
