package simpleray.math;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static simpleray.text.SceneText.reader;
import static simpleray.text.SceneText.written;

import java.io.IOException;
import org.junit.jupiter.api.Test;
import simpleray.text.SceneFormatException;

class MathTextTest {
    /** Numbers that a short decimal would lose; {@code equals} of the boxed ones distinguishes -0.0 from 0.0. */
    private static final Double[] HARD = {-0.0, 1.0 / 3, Double.MIN_VALUE};

    @Test
    void aVectorReadsBackBitForBit() throws IOException {
        Vector v = new Vector();
        v.read(reader(written(new Vector(HARD[0], HARD[1], HARD[2])::write)));

        assertThat(new Double[] {v.x, v.y, v.z}).isEqualTo(HARD);
    }

    @Test
    void aPointReadsBackBitForBit() throws IOException {
        Point p = new Point();
        p.read(reader(written(new Point(HARD[0], HARD[1], HARD[2])::write)));

        assertThat(new Double[] {p.x, p.y, p.z}).isEqualTo(HARD);
    }

    @Test
    void aColourReadsBackBitForBit() throws IOException {
        Colour c = new Colour();
        c.read(reader(written(new Colour(HARD[0], HARD[1], HARD[2])::write)));

        assertThat(new Double[] {c.r, c.g, c.b}).isEqualTo(HARD);
    }

    @Test
    void threeNumbersAreWrittenWithSpacesBetween() {
        assertThat(written(new Vector(1, 2.5, -3)::write)).isEqualTo("1.0 2.5 -3.0");
        assertThat(written(new Point(1, 2.5, -3)::write)).isEqualTo("1.0 2.5 -3.0");
        assertThat(written(new Colour(1, 0.5, 0)::write)).isEqualTo("1.0 0.5 0.0");
    }

    @Test
    void vectorsAndPointsPrintInSquareBracketsAndColoursInRound() {
        assertThat(written(new Vector(1, 1e-10, -3)::print)).isEqualTo("[1.0,1.0E-10,-3.0]");
        assertThat(written(new Point(1, 1e23, -3)::print)).isEqualTo("[1.0,1.0E23,-3.0]");
        assertThat(written(new Colour(1, 0.002, 0)::print)).isEqualTo("(1.0,0.002,0.0)");
    }

    @Test
    void eachMissingValueIsNamed() {
        assertThatThrownBy(() -> new Vector().read(reader("1 *"))).hasMessage(
            "<stdin>:1:3: error: expected y, found '*'\n1 *\n  ^");
        assertThatThrownBy(() -> new Point().read(reader("1 2"))).hasMessage(
            "<stdin>:1:4: error: expected z, found the end of the file\n1 2\n   ^");
        assertThatThrownBy(() -> new Vector().read(reader(""))).hasMessage(
            "<stdin>:1:1: error: expected x, found the end of the file\n\n^");
        assertThatThrownBy(() -> new Colour().read(reader("1 2"))).hasMessage(
            "<stdin>:1:4: error: expected blue, found the end of the file\n1 2\n   ^");
    }

    @Test
    void aColourBelowZeroIsRejected() {
        assertThatThrownBy(() -> new Colour().read(reader("-0.5 0 0"))).isInstanceOf(SceneFormatException.class).hasMessage(
            "<stdin>:1:1: error: expected red of 0 or more, found '-0.5'\n-0.5 0 0\n^");
        assertThatThrownBy(() -> new Colour().read(reader("0 -1e-9 0"))).hasMessage(
            "<stdin>:1:3: error: expected green of 0 or more, found '-1e-9'\n0 -1e-9 0\n  ^");
        assertThatThrownBy(() -> new Colour().read(reader("0 0 -1"))).hasMessage(
            "<stdin>:1:5: error: expected blue of 0 or more, found '-1'\n0 0 -1\n    ^");
    }

    @Test
    void aColourAboveOneIsReadAsItIs() throws IOException {
        Colour c = new Colour();
        c.read(reader("1 7 300"));
        assertThat(c).hasToString("(1.0,7.0,300.0)");
    }
}
