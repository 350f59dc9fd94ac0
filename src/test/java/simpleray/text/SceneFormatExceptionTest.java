package simpleray.text;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import org.junit.jupiter.api.Test;

class SceneFormatExceptionTest {
    private static final Diagnostic WARNING = new Diagnostic("a.obj", 1, 1, false, "odd", null);
    private static final Diagnostic ERROR = new Diagnostic("a.obj", 2, 1, true, "wrong", null);

    @Test
    void warningsThatAreToldWithAnErrorAreNotCounted() throws SceneFormatException {
        Diagnostics diagnostics = new Diagnostics("a.scene");
        diagnostics.tolerate(2);
        diagnostics.report(WARNING);
        diagnostics.report(List.of());
        diagnostics.report(List.of(WARNING, WARNING, ERROR));

        assertThat(diagnostics.warnings()).containsExactly(WARNING);
        assertThatThrownBy(diagnostics::complete).isInstanceOfSatisfying(SceneFormatException.class,
            e -> assertThat(e.problems()).containsExactly(WARNING, WARNING, ERROR)).hasMessageEndingWith("a.obj:2:1: error: wrong");
        assertThatThrownBy(() -> diagnostics.report(List.of(ERROR))).hasMessageEndingWith("error: wrong\n2 errors: reading stopped here");
    }
}
