package simpleray.scene;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import simpleray.math.Ray;
import simpleray.math.Vector;

class SimpleCameraRangesTest {
    private static final double ROUNDING = 1e-14;

    @ParameterizedTest
    @ValueSource(doubles = {0, -0.0, -2, Double.NaN, Double.POSITIVE_INFINITY, Double.NEGATIVE_INFINITY})
    void theCentreOfProjectionIsAboveZeroAndFinite(double cop) {
        SimpleCamera camera = new SimpleCamera();
        assertThatThrownBy(() -> camera.setCOP(cop)).isInstanceOf(IllegalArgumentException.class)
            .hasMessage("the centre of projection must be above 0, and is " + cop);
        assertThat(camera.ray(0, 0).origin).hasToString("[0.0,0.0,2.0]");
    }

    @ParameterizedTest
    @CsvSource({"0, 1", "1, 0", "-1, 1", "1, -1"})
    void theResolutionIsOneByOneOrMore(int width, int height) {
        SimpleCamera camera = new SimpleCamera();
        String message = "the resolution must be 1x1 or more, and is " + width + 'x' + height;
        assertThatThrownBy(() -> camera.setResolution(width, height)).isInstanceOf(IllegalArgumentException.class)
            .hasMessage(message);
        assertThatThrownBy(() -> new SimpleCamera(width, height)).hasMessage(message);
        assertThat(camera.width()).isEqualTo(200);
    }

    @ParameterizedTest
    @CsvSource({"1,1,0,1", "2,1,0,1", "0,1,1,1", "0,1,2,1", "NaN,1,0,1", "0,NaN,0,1", "0,1,NaN,1", "0,1,0,NaN", "0,Infinity,0,1",
        "0,1,-Infinity,1", "-1.0E308,1.0E308,0,1"})
    void theWindowIsNeitherEmptyNorInfinite(double xmin, double xmax, double ymin, double ymax) {
        SimpleCamera camera = new SimpleCamera();
        assertThatThrownBy(() -> camera.setVPWindow(xmin, xmax, ymin, ymax)).isInstanceOf(IllegalArgumentException.class)
            .hasMessage("the window must have xmin < xmax and ymin < ymax, and is "
                + xmin + ',' + xmax + ',' + ymin + ',' + ymax);
        sees(camera.ray(0, 0), 2, -1.99, 1.99);
    }

    /** Checks that the ray starts at the centre of projection and passes through the window at (x, y, 0). */
    private static void sees(Ray ray, double cop, double x, double y) {
        Vector d = ray.direction;
        double toWindow = -cop / d.z;
        assertThat(ray.origin).hasToString("[0.0,0.0," + cop + ']');
        assertThat(d.x * toWindow).isEqualTo(x, within(ROUNDING));
        assertThat(d.y * toWindow).isEqualTo(y, within(ROUNDING));
        assertThat(d.norm()).isEqualTo(1, within(ROUNDING));
    }
}
