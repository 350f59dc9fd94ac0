package simpleray.scene;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;

import java.util.List;
import org.junit.jupiter.api.Test;

class KeyTest {
    private static final Key.Thing BALL = new Key.Thing(Key.Kind.OBJECT, 3);

    @Test
    void aKeyIsWrittenAsItIsRead() {
        assertThat(new Key(1.5, BALL, List.of(1.0, 2.0, 3.0)).words()).containsExactly(1.5, "object", 3, 1.0, 2.0, 3.0);
        assertThat(new Key(0, new Key.Thing(Key.Kind.CAMERA, 0), List.of(1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0)).words())
            .containsExactly(0.0, "camera", 1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0);
    }

    @Test
    void thingsAreNamedByTheirWordsInAFile() {
        assertThat(BALL).hasToString("object 3");
        assertThat(new Key.Thing(Key.Kind.COLOUR, 1)).hasToString("colour 1");
        assertThat(new Key.Thing(Key.Kind.CAMERA, 0)).hasToString("camera");
        assertThat(Curve.LINEAR).hasToString("linear");
        assertThat(Curve.SMOOTH).hasToString("smooth");
    }

    @Test
    void frame0HasOneSign() {
        assertThat(new Key(-0.0, BALL, List.of(1.0, 2.0, 3.0))).isEqualTo(new Key(0, BALL, List.of(1.0, 2.0, 3.0)));
    }

    @Test
    void eachChannelHasAValue() {
        assertThatIllegalArgumentException().isThrownBy(() -> new Key(0, BALL, List.of(1.0))).withMessage("a key of object 3 has 3 values, not 1");
    }
}
