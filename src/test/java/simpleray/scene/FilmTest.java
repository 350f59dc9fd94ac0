package simpleray.scene;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.offset;
import static simpleray.text.SceneText.reader;
import static simpleray.text.SceneText.written;

import java.io.IOException;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import simpleray.SettingSamples;
import simpleray.math.Point;

/** What the things of a film are at its frames (the scene format's rules, with values computed by hand). */
class FilmTest {
    private static final String GREY = "  0 0 0 0.5 0.5 0.5 0 0 0 0\n";
    /** Sphere, plane, triangle and cylinder; a point light and a directional one. */
    private static final String SCENE = "4\n0 1 2 3 0.5" + GREY + "1 0 2 0 -3" + GREY + "2 0 0 0 1 0 0 0 1 0" + GREY + "3 0 0 0 0 1 0 0.25" + GREY
        + "0.1 0.1 0.1\n2\n0 1 0.5 0.25 4 5 6\n1 0.5 0.5 0.5 0 -1 0\n";

    private static Scene scene(String lines) throws IOException {
        Scene scene = new Scene();
        scene.read(reader(SCENE + lines));
        return scene;
    }

    private static double x(Scene film, double frame) {
        return ((Sphere) film.still(frame).getObject(0)).centre.x - 1;
    }

    private static String still(String lines, double frame) throws IOException {
        return written(scene(lines).still(frame)::write);
    }

    @Test
    void aSceneWithoutFramesIsAFilmOfOneFrame() throws IOException {
        Scene scene = scene("");

        assertThat(scene.film().frames()).isOne();
        assertThat(scene.film().rate()).isEqualTo(25);
        assertThat(scene.still(0)).isSameAs(scene);
        assertThat(scene.still(-0.0)).isSameAs(scene);
        assertThatIllegalArgumentException().isThrownBy(() -> scene.still(0.5)).withMessage("the frame must be from 0 to 0, and is 0.5");
    }

    @Test
    void aFilmHasItsFramesAndItsRate() throws IOException {
        Film film = scene("frames 48 23.976").film();

        assertThat(film.frames()).isEqualTo(48);
        assertThat(film.rate()).isEqualTo(23.976);
        assertThat(film.has(0)).isTrue();
        assertThat(film.has(-0.0)).isTrue();
        assertThat(film.has(46.5)).isTrue();
        assertThat(film.has(47)).isTrue();
        assertThat(film.has(Math.nextUp(47.0))).isFalse();
        assertThat(film.has(-Double.MIN_VALUE)).isFalse();
        assertThat(film.has(Double.NaN)).isFalse();
    }

    @ParameterizedTest
    @ValueSource(doubles = {-1, 48, 47.25, Double.NaN, Double.POSITIVE_INFINITY})
    void aFrameThatTheFilmDoesNotHaveIsRefused(double frame) throws IOException {
        Scene scene = scene("frames 48 24");

        assertThatIllegalArgumentException().isThrownBy(() -> scene.still(frame))
            .withMessage("the frame must be from 0 to 47, and is " + (frame == Math.rint(frame) && frame < 99 ? String.valueOf((int) frame) : frame));
    }

    @Test
    void aStillHasNeitherFramesNorKeysNorCurve() throws IOException {
        String other = "background 0.25 0.5 1.0\nresolution 4 3\ndepth 2\nsamples 3\n";

        assertThat(still(other + "frames 5 25\ncurve linear\nkey 1 object 1 1 1 1", 0)).isEqualTo(still(other + "frames 1 1", 0).replace(
            "1.0 2.0 3.0 0.5", "2.0 3.0 4.0 0.5")).endsWith("0.0 -1.0 0.0\n" + other);
    }

    /** With u = (f - 2) / 4: 10 + 20 u. */
    @ParameterizedTest
    @CsvSource({"0, 10", "2, 10", "3, 15", "4.5, 22.5", "5, 25", "6, 30", "7.5, 30", "9, 30"})
    void aLinearChannelGoesStraightFromKeyToKeyAndIsConstantOutside(double frame, double x) throws IOException {
        assertThat(x(scene("frames 10 25\ncurve linear\nkey 6 object 1 30 0 0\nkey 2 object 1 10 0 0"), frame)).isEqualTo(x);
    }

    /** Both tangents are 0: at u = 1/4 it is 10 + 20 (3/16 - 2/64) = 13.125. */
    @ParameterizedTest
    @CsvSource({"0, 10", "2, 10", "3, 13.125", "4, 20", "5, 26.875", "6, 30", "9, 30"})
    void aSmoothChannelOfTwoKeysBeginsAndEndsAtRest(double frame, double x) throws IOException {
        for (String curve : new String[] {"", "curve smooth\n"}) {
            assertThat(x(scene("frames 10 25\n" + curve + "key 2 object 1 10 0 0\nkey 6 object 1 30 0 0"), frame)).isEqualTo(x);
        }
    }

    /**
     * Keys 0 at 0, 4 at 2, 4 at 8: the tangent at 2 is (4 - 0) / (8 - 0) = 1/2. At 1, u = 1/2: 4/2 - 1/8 · 2 · 1/2 = 1.875. At 5, u = 1/2: 4 + 1/8 · 6 ·
     * 1/2 = 4.375. At 3.5, u = 1/4: 4 + (1/64 - 2/16 + 1/4) · 6 · 1/2 = 4.421875.
     */
    @ParameterizedTest
    @CsvSource({"0, 0", "1, 1.875", "2, 4", "3.5, 4.421875", "5, 4.375", "8, 4", "9, 4"})
    void aSmoothChannelPassesAKeyWithTheSlopeOfItsNeighbours(double frame, double x) throws IOException {
        assertThat(x(scene("frames 10 25\nkey 8 object 1 4 0 0\nkey 0 object 1 0 0 0\nkey 2 object 1 4 0 0"), frame)).isEqualTo(x);
    }

    @Test
    void theTermsOfTheHermiteFormulaAreThoseOfTheScenesFormat() {
        double[] v = {0.3, -1.7, 2.9, 0.4};
        for (double u = 0.015625; u < 1; u += 0.015625) {
            double cube = u * u * u;
            double square = u * u;
            double expected = (2 * cube - 3 * square + 1) * v[0] + (cube - 2 * square + u) * 7 * v[1] + (-2 * cube + 3 * square) * v[2]
                + (cube - square) * 7 * v[3];
            assertThat(Curve.SMOOTH.between(u, 7, v[0], v[1], v[2], v[3])).isCloseTo(expected, offset(1e-13));
            assertThat(Curve.LINEAR.between(u, 7, v[0], v[1], v[2], v[3])).isEqualTo(v[0] + u * (v[2] - v[0]));
        }
    }

    @Test
    void equalKeysLeaveAChannelTheSameToTheLastBitAllTheWay() throws IOException {
        Scene film = scene("frames 1001 25\nkey 0 object 1 0.1 0.3 0.7\nkey 1000 object 1 0.1 0.3 0.7");

        for (int f = 0; f <= 1000; f++) {
            assertThat(((Sphere) film.still(f).getObject(0)).centre.equals(new Point(1.1, 2.3, 3.7))).isTrue();
        }
    }

    @Test
    void atAKeyTheValueIsTheKeysToTheLastBit() throws IOException {
        for (String curve : new String[] {"linear", "smooth"}) {
            Scene film = scene("frames 9 25\ncurve " + curve + "\nkey 0 colour 1 0.7 0.5 0.5\nkey 2.7 colour 1 0.1 0.2 0.3\nkey 7 colour 1 0.9 0.2 0.3\n"
                + "key 8 colour 1 0.3 0.2 0.3");
            assertThat(film.still(2.7).getLight(0).intensity).hasToString("(0.1,0.2,0.3)");
            assertThat(film.still(7).getLight(0).intensity).hasToString("(0.9,0.2,0.3)");
            assertThat(film.still(8).getLight(0).intensity).hasToString("(0.3,0.2,0.3)");
            assertThat(film.still(0).getLight(0).intensity).hasToString("(0.7,0.5,0.5)");
        }
    }

    @Test
    void everythingIsMovedByWhatItIsMadeOf() throws IOException {
        String text = still("frames 2 25\nkey 0 object 1 0.5 0.25 -1\nkey 0 object 2 9 0.25 9\nkey 0 object 3 1 2 3\nkey 0 object 4 1 2 3\nkey 0 light 1 1 2 3", 1);

        assertThat(text.lines().filter(line -> !line.startsWith("#")).map(line -> line.replaceAll("  0.0 0.0 0.0  0.5.*", ""))).containsExactly("4",
            "0  1.5 2.25 2.0 0.5", "1  0.0 2.0 0.0 -2.5", "2  1.0 2.0 3.0  2.0 2.0 3.0  1.0 3.0 3.0", "3  1.0 2.0 3.0  1.0 3.0 3.0  0.25",
            "0.1 0.1 0.1", "2", "0  1.0 0.5 0.25  5.0 7.0 9.0", "1  0.5 0.5 0.5  0.0 -1.0 0.0");
    }

    @Test
    void aLightsPlaceAndColourGoTheirOwnWays() throws IOException {
        Scene film = scene("frames 3 25\ncurve linear\nkey 0 colour 1 0 0 0\nkey 0 light 1 0 0 0\nkey 2 light 1 4 0 0\nkey 2 colour 1 1 0.5 0\nkey 1 colour 2 0.25 0.5 1");
        Light lamp = film.still(1).getLight(0);

        assertThat(lamp.intensity).hasToString("(0.5,0.25,0.0)");
        assertThat(((PointLight) lamp).origin.equals(new Point(6, 5, 6))).isTrue();
        assertThat(film.still(2).getLight(1).intensity).hasToString("(0.25,0.5,1.0)");
        assertThat(((DirectionalLight) film.still(2).getLight(1)).direction).isSameAs(((DirectionalLight) film.getLight(1)).direction);
        assertThat(film.getLight(0).intensity).as("the film's own").hasToString("(1.0,0.5,0.25)");
    }

    /** Each of the seven numbers is a channel. */
    @Test
    void theCameraGoesFromKeyToKey() throws IOException {
        Scene film = scene("frames 5 25\ncurve linear\nkey 4 camera 4 5 6 8 9 10 80\nkey 0 camera 0 1 2 0 -3 -6 40");

        assertThat(film.still(1).settings.lines()).isEqualTo("camera 1.0 2.0 3.0 2.0 0.0 -2.0 50.0\n");
        assertThat(film.still(4).settings.lines()).isEqualTo("camera 4.0 5.0 6.0 8.0 9.0 10.0 80.0\n");
    }

    @Test
    void keysOfTheCameraTakeThePlaceOfTheFilesCamera() throws IOException {
        assertThat(scene("camera 0 0 9 0 0 0 20\nframes 2 25\nkey 1 camera 0 0 5 0 0 0 30").still(0).settings.lines())
            .isEqualTo("camera 0.0 0.0 5.0 0.0 0.0 0.0 30.0\n");
    }

    @Test
    void anOptionForTheCameraWinsOverItsKeysAndLeavesTheOthers() throws IOException {
        Scene film = scene("frames 2 25\nkey 0 camera 0 0 5 0 0 0 30\nkey 0 object 1 1 0 0");
        for (Setting<?> option : List.of(Setting.CAMERA, Setting.COP, Setting.WINDOW)) {
            SceneSettings asked = SettingSamples.only(option);
            Scene still = film.with(film.settings.under(asked)).still(0);

            assertThat(still.settings.lines()).isEqualTo(asked.lines()).isEqualTo(film.still(0).settings.under(asked).lines());
            assertThat(((Sphere) still.getObject(0)).centre.x).isEqualTo(2);
        }
        assertThat(film.settings.under(SettingSamples.only(Setting.DEPTH)).lines()).contains("key 0.0 camera", "key 0.0 object", "depth");
        assertThat(film.settings.keys).hasSize(2);
    }

    @Test
    void keysThatAreAskedForAreThoseOfTheFilm() throws IOException {
        SceneSettings asked = scene("frames 3 5\nkey 0 camera 0 0 5 0 0 0 30").settings;

        assertThat(scene("cop 3\nframes 2 25\nkey 0 object 1 1 0 0").settings.under(asked).keys).isEqualTo(asked.keys);
    }

    @Test
    void whatDoesNotMoveIsTheSameAndNotACopy() throws IOException {
        Scene film = scene("frames 3 25\nkey 0 object 1 0 0 0\nkey 2 object 1 1 0 0\nkey 0 light 1 0 -0.0 0\nkey 2 light 1 0 1 0");
        Scene first = film.still(0);
        Scene last = film.still(2);

        for (int i = 0; i < 4; i++) {
            assertThat(first.getObject(i)).isSameAs(film.getObject(i));
        }
        assertThat(last.getObject(0)).isNotSameAs(film.getObject(0));
        assertThat(last.getObject(0).surfaceMaterial).isSameAs(film.getObject(0).surfaceMaterial);
        assertThat(last.getObject(1)).isSameAs(film.getObject(1));
        assertThat(first.getLight(0)).isSameAs(film.getLight(0));
        assertThat(first.getLight(1)).isSameAs(film.getLight(1));
        assertThat(last.getLight(0)).isNotSameAs(film.getLight(0));
        assertThat(first.ambient).isSameAs(film.ambient);
        for (String axis : new String[] {"1 0 0", "0 1 0", "0 0 1"}) {
            Scene along = scene("frames 1 25\nkey 0 object 1 " + axis + "\nkey 0 light 1 " + axis);
            assertThat(along.still(0).getObject(0)).isNotSameAs(along.getObject(0));
            assertThat(along.still(0).getLight(0)).isNotSameAs(along.getLight(0));
        }
    }

    @Test
    void aStillKnowsTheLinesOfItsObjectsAndLights() throws IOException {
        Scene still = scene("frames 1 1\nkey 0 object 2 0 1 0\nkey 0 light 1 1 1 1").still(0);

        assertThat(still.objectLine(1)).isEqualTo(3);
        assertThat(still.lightLine(0)).isEqualTo(8);
        assertThat(still.lightLine(1)).isEqualTo(9);
    }

    @Test
    void aStillThatIsWrittenIsReadAsTheSame() throws IOException {
        Scene film = scene("resolution 8 6\nframes 11 25\nkey 0 object 1 0.1 0.2 0.3\nkey 10 object 1 3 1e-9 -7\nkey 0 camera 0 0 5 0 0 0 30\n"
            + "key 10 camera 0.1 0.2 5 0.3 0 0 31");
        for (double f : new double[] {0, 1, 3.3, 7, 10}) {
            Scene still = film.still(f);
            Scene again = new Scene();
            again.read(reader(written(still::write)));

            assertThat(SceneBits.of(again)).isEqualTo(SceneBits.of(still));
            assertThat(written(again::write)).isEqualTo(written(still::write)).doesNotContain("frames", "key", "curve");
        }
    }

    /** The second object moves between frames 2 and 4, the light's colour between 3 and 5. */
    @ParameterizedTest
    @CsvSource({"0, 2, true", "1.5, 0, true", "2, 3, false", "4, 5, false", "5, 9, true", "2.5, 2.5, true"})
    void framesBetweenWhichNothingChangesAreTheSame(double one, double other, boolean same) throws IOException {
        Film film = scene("frames 10 25\nkey 2 object 2 0 0 0\nkey 4 object 2 0 1 0\nkey 3 colour 1 1 1 1\nkey 5 colour 1 1 0 1\n").film();

        assertThat(film.areSame(one, other)).isEqualTo(same);
        assertThat(scene("frames 10 25").film().areSame(0, 9)).isTrue();
    }
}
