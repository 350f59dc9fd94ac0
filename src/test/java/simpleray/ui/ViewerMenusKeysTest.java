package simpleray.ui;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.event.KeyEvent;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import simpleray.render.Stage;
import simpleray.ui.file.SceneSource;
import simpleray.ui.picture.RenderJob;

/** The keys, pressed on a keyboard. */
class ViewerMenusKeysTest {
    private OpenWindow window;

    @BeforeEach
    void finishThePicture() {
        window = new OpenWindow(SceneSource.file(TestScenes.THESIS), 90, 60);
        window.untilState(RenderJob.State.FINISHED);
    }

    @AfterEach
    void close() {
        window.close();
    }

    @ParameterizedTest
    @CsvSource({"1, ORIGINAL, Original Scene", "2, LIGHTING, With Lighting", "3, FINAL, With Shadows and Reflections",
        "A, AMBIENT, Ambient Term", "D, DIFFUSE, Diffuse Term", "S, SPECULAR, Specular Term", "N, NORMALS, Normals", "Z, DEPTH, Depth",
        "O, OBJECTS, Object Numbers", "R, BOUNCES, Bounces of Rays", "M, SHADOWS, Shadows"})
    void aKeyShowsTheStageAndTicksItInTheMenu(char key, Stage stage, String item) {
        window.screen.press(KeyEvent.getExtendedKeyCodeForChar(Character.toLowerCase(key)));

        window.untilShown("stage " + stage, TestScenes.rendered(TestScenes.THESIS, 90, 60, stage));
        window.untilState(RenderJob.State.FINISHED);
        assertThat(window.label("size")).isEqualTo("90 × 60, " + stage);
        assertThat(OpenWindow.ask(window.item(item)::isSelected)).isTrue();
    }

    @ParameterizedTest
    @ValueSource(strings = {"F5", "control R"})
    void reloadHasTwoKeys(String key) {
        RenderJob before = window.job();
        if (key.equals("F5")) {
            window.screen.press(KeyEvent.VK_F5);
        } else {
            window.screen.press(KeyEvent.VK_CONTROL, KeyEvent.VK_R);
        }

        assertThat(window.job()).isNotSameAs(before);
        window.untilState(RenderJob.State.FINISHED);
        window.untilShown("the picture", TestScenes.rendered(TestScenes.THESIS, 90, 60));
    }

    @Test
    void escapeDoesNothingToAFinishedPicture() {
        window.screen.press(KeyEvent.VK_ESCAPE);

        assertThat(window.job().state()).isEqualTo(RenderJob.State.FINISHED);
        assertThat(window.status()).startsWith("Finished: 5,400 rays");
    }

    @Test
    void controlQQuits() {
        window.screen.press(KeyEvent.VK_CONTROL, KeyEvent.VK_Q);

        assertThat(window.closed).isTrue();
        assertThat(OpenWindow.ask(window.frame::isDisplayable)).isFalse();
    }
}
