package simpleray.image.png;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import org.junit.jupiter.api.Test;
import simpleray.image.Picture;
import simpleray.image.Pictures;

class RowsCheckTest {
    @Test
    void aCheckFindsTheFirstPixelThatDiffersInWhateverOrderTheRowsCome() throws IOException {
        byte[] file = Pictures.png(Pictures.plain(3, 4, 0.5));
        Picture picture = Pictures.plain(3, 4, 0.5);
        picture.setRow(2, new double[] {0.5, 0.5, 0.5, 0.5, 1, 0.5, 0.5, 0.5, 0.5});
        picture.setRow(3, new double[9]);
        RowsCheck check = new RowsCheck(picture, PngReader.open(new ByteArrayInputStream(file), "a.png"));

        for (int y : new int[] {3, 1, 0, 2}) {
            check.row(y);
        }

        assertThat(check.different()).isEqualTo(4);
        assertThat(check.first()).isEqualTo(new RowsCheck.Pixel(1, 2, "128,128,128", "128,255,128"));
    }
}
