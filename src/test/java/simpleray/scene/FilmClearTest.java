package simpleray.scene;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import simpleray.math.Point;
import simpleray.math.Vector;

/** Which frames between two keys need not be computed to know that they are right. */
class FilmClearTest {
    private static final Key.Thing CAMERA = new Key.Thing(Key.Kind.CAMERA, 0);
    private static final Key.Thing COLOUR = new Key.Thing(Key.Kind.COLOUR, 1);
    private static final Key.Thing OBJECT = new Key.Thing(Key.Kind.OBJECT, 1);
    private static final Key.Thing LIGHT = new Key.Thing(Key.Kind.LIGHT, 1);

    /** {@return whether the frames between the first two keys are clear; the keys are at 0, 1, 2 …} */
    private static boolean isClear(Scene scene, Curve curve, Key.Thing thing, double[]... values) {
        List<Key> keys = new ArrayList<>();
        for (double[] value : values) {
            keys.add(new Key(keys.size(), thing, Arrays.stream(value).boxed().toList()));
        }
        scene.settings.curve = curve;
        return new Film(scene).isClear(Track.of(keys).get(0), 0);
    }

    private static boolean isClear(Object object, double[]... offsets) {
        return isClear(Scenes.of(object), Curve.LINEAR, OBJECT, offsets);
    }

    private static double[] v(double... values) {
        return values;
    }

    @Test
    void aColourIsClearIfItsBoundsAre0OrMore() {
        Scene lamp = new Scene();

        assertThat(isClear(lamp, Curve.LINEAR, COLOUR, v(0, 0, 0), v(1, 2, 3))).isTrue();
        for (int c = 0; c < 3; c++) {
            double[] up = {0, 0, 0};
            up[c] = 1;
            assertThat(isClear(lamp, Curve.SMOOTH, COLOUR, v(0, 0, 0), v(0, 0, 0), up)).isFalse();
            assertThat(isClear(lamp, Curve.LINEAR, COLOUR, v(0, 0, 0), v(0, 0, 0), up)).isTrue();
            double[] far = {1, 1, 1};
            far[c] = Double.MAX_VALUE;
            assertThat(isClear(lamp, Curve.SMOOTH, COLOUR, far, far, v(0, 0, 0))).as("an infinite bound").isFalse();
        }
    }

    /** The bounds of 10, 10, 70 go from 10 - 30 / 3 to 10. */
    @ParameterizedTest
    @CsvSource({"10, 70, false", "10, 69.9, true", "170, 110, false", "170, 110.1, true"})
    void aFieldOfViewIsClearIfItsBoundsAreWithinItsRange(double first, double last, boolean clear) {
        double[] middle = v(0, 0, 5, 0, 0, 0, first);

        assertThat(isClear(new Scene(), Curve.SMOOTH, CAMERA, middle, middle, v(0, 0, 5, 0, 0, 0, last))).isEqualTo(clear);
    }

    @ParameterizedTest
    @ValueSource(ints = {0, 1, 2})
    void aCameraIsClearIfEyeAndLookAtPointAreApartAlongAnAxis(int axis) {
        for (double other : new double[] {-1, 1}) {
            double[] apart = v(1, 1, 1, 1, 1, 1, 40);
            apart[axis] = 1 + other;
            assertThat(isClear(new Scene(), Curve.LINEAR, CAMERA, apart, apart)).isTrue();
            double[] through = apart.clone();
            through[axis] = 1 - other;
            assertThat(isClear(new Scene(), Curve.LINEAR, CAMERA, apart, through)).isFalse();
            double[] near = v(1, 1, 1, 1, 1, 1, 40);
            double gap = 1e-9 * 1000;
            near[(axis + 1) % 3] = 1000;
            near[(axis + 1) % 3 + 3] = 1000;
            near[axis] = 0;
            near[axis + 3] = gap;
            assertThat(isClear(new Scene(), Curve.LINEAR, CAMERA, near, near)).isFalse();
            near[axis + 3] = Math.nextUp(gap);
            assertThat(isClear(new Scene(), Curve.LINEAR, CAMERA, near, near)).isTrue();
        }
    }

    /** From (0, 0, 5) the view goes on to (0, 0, 0), from (0, 4, 5) too: all views between lie in the plane x = 0, from 0 to 38.7 degrees down. */
    @Test
    void aCameraIsClearIfNoViewCanBeAlongUp() {
        double[] low = v(0, 0, 5, 0, 0, 0, 40);
        double[] high = v(0, 4, 5, 0, 0, 0, 40);
        for (double sign : new double[] {-1e300, 1}) {
            assertThat(isClear(withUp(0, sign, 0), Curve.LINEAR, CAMERA, low, high)).isTrue();
            assertThat(isClear(withUp(sign, 0, 0), Curve.LINEAR, CAMERA, low, high)).isTrue();
            assertThat(isClear(withUp(sign, 4 * sign, 10 * sign), Curve.LINEAR, CAMERA, low, high)).isTrue();
            assertThat(isClear(withUp(0, -4 * sign, 10 * sign), Curve.LINEAR, CAMERA, low, high)).isTrue();
            assertThat(isClear(withUp(0, 4 * sign, 10 * sign), Curve.LINEAR, CAMERA, low, high)).as("that of frame 0.5").isFalse();
            assertThat(isClear(withUp(0, 0, sign), Curve.LINEAR, CAMERA, low, high)).as("that of frame 0").isFalse();
        }
    }

    private static Scene withUp(double x, double y, double z) {
        Scene scene = new Scene();
        scene.settings.up = new Vector(x, y, z);
        return scene;
    }

    /** With room for four times as much: 4 · 2.5e99 = 1e100. */
    @Test
    void anObjectIsClearIfThereIsRoomForMore() {
        Sphere ball = new Sphere(null, new Point(), 1);
        for (int c = 0; c < 3; c++) {
            double[] t = {0, 0, 0};
            t[c] = 2.5e99;
            assertThat(isClear(ball, v(0, 0, 0), t)).isTrue();
            t[c] = -2.5e99;
            assertThat(isClear(ball, t, v(0, 0, 0))).isTrue();
            t[c] = 2.500001e99;
            assertThat(isClear(ball, v(0, 0, 0), t)).isFalse();
            t[c] = -2.500001e99;
            assertThat(isClear(ball, v(0, 0, 0), t)).isFalse();
        }
    }

    @ParameterizedTest
    @ValueSource(ints = {0, 1, 2})
    void roomIsNeededOnBothSidesOfEachAxis(int axis) {
        double[] n = {0, 0, 0};
        n[axis] = 1;
        Vector normal = new Vector(n[0], n[1], n[2]);

        assertThat(isClear(new Plane(null, normal, 0), v(0, 0, 0), v(1e99, 0, 0))).isTrue();
        assertThat(isClear(new Plane(null, normal, 1e100), v(0, 0, 0), v(1e99, 0, 0))).isFalse();
        assertThat(isClear(new Plane(null, normal, -1e100), v(0, 0, 0), v(1e99, 0, 0))).isFalse();
    }

    @Test
    void aLightIsClearIfThereIsRoomForMore() {
        Scene lamp = new Scene();
        Scenes.light(lamp, new PointLight(new Point(0, 0, 0)));

        assertThat(isClear(lamp, Curve.LINEAR, LIGHT, v(0, 0, 0), v(0, 4e307, 0))).isTrue();
        assertThat(isClear(lamp, Curve.LINEAR, LIGHT, v(0, 0, 0), v(0, 5e307, 0))).isFalse();
    }

    /** One to begin with, eight to see that there is room, and one for the end; else all frames. */
    @Test
    void framesThatAreClearAreNotComputed() {
        int[] moves = {0};
        Object counting = new StandIn() {
            @Override
            public Object moved(Vector t) {
                moves[0]++;
                if (Math.abs(t.x) > 8) {
                    throw new IllegalArgumentException("less");
                }
                return this;
            }
        };
        Scene scene = Scenes.of(counting);
        scene.settings.frames = new SceneSettings.Frames(1001, 25);
        scene.settings.keys = List.of(new Key(0, OBJECT, List.of(1.0, 0.0, 0.0)), new Key(1000, OBJECT, List.of(2.0, 0.0, 0.0)));

        assertThat(new Film(scene).faults()).isEmpty();
        assertThat(moves[0]).isEqualTo(10);

        moves[0] = 0;
        scene.settings.keys = List.of(new Key(0, OBJECT, List.of(1.0, 0.0, 0.0)), new Key(1000, OBJECT, List.of(3.0, 0.0, 0.0)));
        assertThat(new Film(scene).faults()).isEmpty();
        assertThat(moves[0]).isEqualTo(1 + 1 + 1001 + 1);
    }

    @Test
    void aFramesNumberHasNoFractionIfItIsWhole() {
        double[] frames = {0, -0.0, 12, -3, 2.5, 2147483646.0, 2147483647.0};

        assertThat(Arrays.stream(frames).mapToObj(Film::text)).containsExactly("0", "0", "12", "-3", "2.5", "2147483646", "2.147483647E9");
    }
}
