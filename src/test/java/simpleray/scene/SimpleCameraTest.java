package simpleray.scene;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import simpleray.math.Ray;
import simpleray.math.Vector;

class SimpleCameraTest {
    private static final double ROUNDING = 1e-14;

    @Test
    void theDefaultsAre200By200AndACentreOfProjectionAtTwo() {
        SimpleCamera camera = new SimpleCamera();

        assertThat(camera.width()).isEqualTo(200);
        assertThat(camera.height()).isEqualTo(200);
        assertThat(camera.ray(0, 0).origin).hasToString("[0.0,0.0,2.0]");
    }

    @Test
    void theFirstRayIsThatOfTheUpperLeftCorner() {
        // a cell is 4 / 200 = 0.02 wide, so its centre is 0.01 from the edges
        sees(new SimpleCamera().ray(0, 0), 2, -1.99, 1.99);
    }

    @Test
    void theLastRayIsThatOfTheLowerRightCorner() {
        sees(new SimpleCamera().ray(199, 199), 2, 1.99, -1.99);
    }

    @Test
    void xGoesRightAndYGoesDown() {
        sees(new SimpleCamera().ray(199, 0), 2, 1.99, 1.99);
        sees(new SimpleCamera().ray(150, 20), 2, 1.01, 1.59);
    }

    @Test
    void theCentreRayOfAnOddResolutionLooksStraightAhead() {
        assertThat(new SimpleCamera(3, 5).ray(1, 2).direction.z).isEqualTo(-1);
    }

    @Test
    void directionsHaveLengthOne() {
        // cells of 2: the centres at ±1, and 2 deep: (-1,1,-2) is √6 long
        Ray ray = new SimpleCamera(2, 2).ray(0, 0);
        assertThat(ray.direction.x).isEqualTo(-1 / Math.sqrt(6), within(ROUNDING));
        assertThat(ray.direction.y).isEqualTo(1 / Math.sqrt(6), within(ROUNDING));
        assertThat(ray.direction.z).isEqualTo(-2 / Math.sqrt(6), within(ROUNDING));
    }

    @Test
    void theWindowGrowsSidewaysForAWidePicture() {
        // 400 × 200: [-4,4] × [-2,2], cells of 0.02
        SimpleCamera camera = new SimpleCamera(400, 200);
        sees(camera.ray(0, 0), 2, -3.99, 1.99);
        sees(camera.ray(399, 199), 2, 3.99, -1.99);
    }

    @Test
    void theWindowGrowsUpAndDownForATallPicture() {
        // 200 × 300: [-2,2] × [-3,3], cells of 0.02
        SimpleCamera camera = new SimpleCamera(200, 300);
        sees(camera.ray(0, 0), 2, -1.99, 2.99);
        sees(camera.ray(199, 299), 2, 1.99, -2.99);
    }

    @Test
    void aWindowThatWasAskedForIsStretched() {
        // [0,1] × [-1,3] over 4 × 2: cells of 0.25 × 2
        SimpleCamera camera = new SimpleCamera(4, 2);
        camera.setVPWindow(0, 1, -1, 3);
        sees(camera.ray(0, 0), 2, 0.125, 2);
        sees(camera.ray(3, 1), 2, 0.875, 0);
    }

    @Test
    void settersMayBeCalledInAnyOrder() {
        SimpleCamera one = new SimpleCamera();
        one.setVPWindow(0, 1, -1, 3);
        one.setCOP(8);
        one.setResolution(4, 2);
        SimpleCamera other = new SimpleCamera();
        other.setResolution(4, 2);
        other.setCOP(8);
        other.setVPWindow(0, 1, -1, 3);

        sees(one.ray(3, 0), 8, 0.875, 2);
        sees(other.ray(3, 0), 8, 0.875, 2);
    }

    @Test
    void aLaterResolutionMakesTheDefaultWindowFitAgain() {
        SimpleCamera camera = new SimpleCamera(400, 200);
        camera.setResolution(200, 200);
        sees(camera.ray(0, 0), 2, -1.99, 1.99);
    }

    @Test
    void theWindowStaysWhenTheCentreOfProjectionMoves() {
        SimpleCamera camera = new SimpleCamera();
        camera.setCOP(0.5);
        sees(camera.ray(0, 0), 0.5, -1.99, 1.99);
    }

    @Test
    void initBasicSetsAllElseBackToTheDefaults() {
        SimpleCamera camera = new SimpleCamera();
        camera.setVPWindow(0, 1, -1, 3);
        camera.setCOP(8);
        camera.initBasic(400, 200);

        assertThat(camera.width()).isEqualTo(400);
        assertThat(camera.height()).isEqualTo(200);
        sees(camera.ray(0, 0), 2, -3.99, 1.99);
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
