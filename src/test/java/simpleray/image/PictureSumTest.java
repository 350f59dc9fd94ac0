package simpleray.image;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;

/** Light added to light. */
class PictureSumTest {
    @Test
    void theSumIsNotClamped() {
        Picture sum = Picture.sum(List.of(Pictures.plain(2, 3, 0.5), Pictures.plain(2, 3, 0.25), Pictures.plain(2, 3, 0.75)));

        assertThat(sum.width()).isEqualTo(2);
        assertThat(sum.height()).isEqualTo(3);
        assertThat(sum.row(0)).containsExactly(1.5, 1.5, 1.5, 1.5, 1.5, 1.5);
        assertThat(sum.row(2)).isEqualTo(sum.row(0));
    }

    @Test
    void picturesAreAddedInTheirOrder() {
        Picture large = Pictures.plain(1, 1, 1);
        Picture small = Pictures.plain(1, 1, Math.ulp(1.0) / 2);   // lost beside 1, but two of them are not

        assertThat(Picture.sum(List.of(large, small, small)).row(0)[0]).isEqualTo(1);
        assertThat(Picture.sum(List.of(small, small, large)).row(0)[0]).isEqualTo(Math.nextUp(1.0));
    }

    @Test
    void theSumOfOneIsACopy() {
        Picture one = Pictures.noise(2, 1, 1);

        Picture sum = Picture.sum(List.of(one));

        assertThat(sum.row(0)).isEqualTo(one.row(0)).isNotSameAs(one.row(0));
    }
}
