package simpleray.scene;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

class HitTest {
    private final Hit hit = new Hit();

    @Test
    void anyHitComesBeforeNone() {
        assertThat(hit.accepts(0, 9)).isTrue();
        assertThat(hit.accepts(1e300, 0)).isTrue();
        assertThat(hit.accepts(-1, 0)).as("a miss").isFalse();
        assertThat(hit.accepts(Double.NaN, 0)).isFalse();
    }

    @Test
    void theNearerHitComesFirstAndOfTwoAlikeTheObjectListedFirst() {
        hit.part = 3;
        hit.set(2, 5);

        assertThat(hit.part).isZero();
        assertThat(hit.accepts(1.9, 9)).isTrue();
        assertThat(hit.accepts(2.1, 0)).isFalse();
        assertThat(hit.accepts(2, 4)).isTrue();
        assertThat(hit.accepts(2, 5)).isFalse();
        assertThat(hit.accepts(2, 6)).isFalse();
    }
}
