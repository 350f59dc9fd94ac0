package simpleray.scene;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import simpleray.math.Vector;

class UnitVectorTest {
    /** It remembers the one before, which must not be taken for another. */
    @Test
    void itIsThatOfTheVectorAlsoIfOneComponentChanges() {
        UnitVector unit = new UnitVector();
        for (Vector v : new Vector[] {new Vector(3, 4, 0), new Vector(3, 4, 0), new Vector(-3, 4, 0), new Vector(-3, -4, 0),
            new Vector(-3, -4, 12), new Vector(0, 0, 2)}) {
            Vector out = new Vector();
            unit.of(v, out);
            assertThat(out).hasToString(v.normalised().toString());
        }
    }
}
