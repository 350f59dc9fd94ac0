package simpleray.scene;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;

class TrackTest {
    private static final Key.Thing BALL = new Key.Thing(Key.Kind.OBJECT, 1);

    /** {@return the track of keys such as {@code 0:1 5:2}: at frame 0 x is 1, at frame 5 it is 2} */
    private static Track track(String keys) {
        List<Key> all = new ArrayList<>();
        for (String key : keys.split(" ")) {
            String[] parts = key.split(":");
            all.add(new Key(Double.parseDouble(parts[0]), BALL, List.of(7.0, Double.parseDouble(parts[1]), -3.0)));
        }
        return Track.of(all).get(0);
    }

    @Test
    void keysAreInTheOrderOfTheirFramesAndKnowTheirPlaces() {
        Track track = track("5:1 0:2 2.5:3");

        assertThat(track.size()).isEqualTo(3);
        assertThat(List.of(track.frame(0), track.frame(1), track.frame(2))).containsExactly(0.0, 2.5, 5.0);
        assertThat(List.of(track.place(0), track.place(1), track.place(2))).containsExactly(1, 2, 0);
        assertThat(track.firstPlace()).isZero();
        assertThat(List.of(track.before(-1), track.before(0), track.before(2.4), track.before(2.5), track.before(5), track.before(9)))
            .containsExactly(-1, 0, 0, 1, 2, 2);
    }

    /** 1e17 would swallow the others, so there is no formula at a key. */
    @ParameterizedTest
    @EnumSource(Curve.class)
    void atAKeyTheValueIsTheKeysToTheLastBit(Curve curve) {
        Track track = track("0:0.7 2.7:0.1 7:1e17 8:0.3");
        double[] at = new double[3];
        for (int key = 0; key < 4; key++) {
            track.at(track.frame(key), curve, at);
            assertThat(at).containsExactly(7, new double[] {0.7, 0.1, 1e17, 0.3}[key], -3);
        }
    }

    @Test
    void eachThingHasItsTrackInTheOrderOfTheFile() {
        Key.Thing lamp = new Key.Thing(Key.Kind.LIGHT, 1);
        List<Double> values = List.of(0.0, 0.0, 0.0);
        List<Key> keys = List.of(new Key(1, lamp, values), new Key(0, BALL, values), new Key(0, lamp, values));

        assertThat(Track.of(keys)).extracting(track -> track.thing).containsExactly(lamp, BALL);
        assertThat(Track.of(List.of())).isEmpty();
    }

    /** Smooth 0, 3, 1: at 2 the slope is 1 / 4, and the control points are 0, 0, 3 - 2 (1/4) / 3 and 3; then 3, 3 + 1/6, 1, 1. */
    @Test
    void betweenTwoKeysAChannelIsWithinItsControlPoints() {
        double[] low = new double[3];
        double[] high = new double[3];

        track("0:0 2:3 4:1").bounds(0, Curve.SMOOTH, low, high);
        assertThat(low).containsExactly(7, 0, -3);
        assertThat(high).containsExactly(7, 3, -3);
        track("0:0 2:3 4:1").bounds(1, Curve.SMOOTH, low, high);
        assertThat(low[1]).isEqualTo(1);
        assertThat(high[1]).isEqualTo(3 + 2.0 / 3 * 0.25);
        track("0:0 2:3 4:9").bounds(1, Curve.SMOOTH, low, high);
        assertThat(low[1]).isEqualTo(3);
        assertThat(high[1]).isEqualTo(9);
        track("0:1 2:1 4:-3").bounds(0, Curve.SMOOTH, low, high);
        assertThat(low[1]).isEqualTo(1);
        assertThat(high[1]).isEqualTo(1 + 2.0 / 3);
        track("0:0 2:3 4:1").bounds(1, Curve.LINEAR, low, high);
        assertThat(low[1]).isEqualTo(1);
        assertThat(high[1]).isEqualTo(3);
    }

    @Test
    void aTrackMayAlwaysBeTheSame() {
        assertThat(track("0:2 5:2").isAlways(7, 2, -3)).isTrue();
        assertThat(track("0:2 5:2").isAlways(7, 2, 3)).isFalse();
        assertThat(track("0:2 5:2.1").isAlways(7, 2, -3)).isFalse();
    }

    /** Counted from 0, in the order of the frames. */
    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {"0:1 | LINEAR | ", "0:1 5:2 | LINEAR | ", "0:1 5:1 | LINEAR | 1", "0:1 5:1 | SMOOTH | 1",
        "0:1 5:1 8:1 | SMOOTH | 1 2", "0:0 5:5 10:10 | LINEAR | 1", "0:0 5:5 10:10 | SMOOTH | ", "0:0 5:5.000001 10:10 | LINEAR | ",
        "0:0 5:5 10:5 | LINEAR | 2", "0:0 5:5 10:5 | SMOOTH | ", "0:5 5:5 10:0 | LINEAR | 0", "0:5 5:5 10:0 | SMOOTH | ",
        "0:0 1:1 2:2 3:3 4:4 5:5 6:6 | LINEAR | 1 2 3 4 5", "0:0 1:1 2:2 3:3 4:2 5:1 6:0 | LINEAR | 1 2 4 5", "0:0 3:0.3 10:1 | LINEAR | 1",
        "0:0 1:0 2:0 3:0 4:0 5:0 6:0 7:1 | SMOOTH | 0 1 2 3 4"})
    void aKeyWithoutWhichTheTrackIsTheSameIsIdle(String keys, Curve curve, String idle) {
        assertThat(track(keys).idle(curve).stream().map(String::valueOf)).containsExactly(idle == null ? new String[0] : idle.split(" "));
    }

    @Test
    void withoutIdleKeysATrackIsTheSame() {
        String keys = "0:0 1:0 2:0 3:0 4:0 5:0 6:0 7:1";
        Track all = track(keys);
        Track fewer = track("5:0 6:0 7:1");
        double[] one = new double[3];
        double[] other = new double[3];
        for (double f = 0; f <= 8; f += 0.125) {
            all.at(f, Curve.SMOOTH, one);
            fewer.at(f, Curve.SMOOTH, other);
            assertThat(one).isEqualTo(other);
        }
    }
}
