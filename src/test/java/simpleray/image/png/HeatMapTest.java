package simpleray.image.png;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import org.junit.jupiter.api.Test;

class HeatMapTest {
    @Test
    void theHeatMapIsBlackWithoutDifferenceAndGoesFromBlueOverRedToYellow() throws IOException {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        HeatMap map = new HeatMap(4, 1, bytes);
        map.row(0, new int[] {0, 1, 16, 255});                // 16 is nearly the root of 255
        map.end();

        try (PngReader rows = PngReader.open(new ByteArrayInputStream(bytes.toByteArray()), "map")) {
            assertThat(rows.next()).containsExactly(0, 0, 0, 0, 0, -1, -1, 0, 0, -1, -1, 0);
        }
    }
}
