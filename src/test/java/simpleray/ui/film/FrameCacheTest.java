package simpleray.ui.film;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.image.BufferedImage;
import java.util.Random;
import org.junit.jupiter.api.Test;

class FrameCacheTest {
    private static final int FRAMES = 10;

    private static FrameCache.Kept picture(int width, int height) {
        return new FrameCache.Kept(new BufferedImage(width, height, BufferedImage.TYPE_INT_RGB), 1);
    }

    @Test
    void itTakesAQuarterOfTheMemory() {
        assertThat(new FrameCache().room()).isEqualTo(Runtime.getRuntime().maxMemory() / 4);
    }

    @Test
    void theFrameThatIsShownLastGoesFirst() {
        FrameCache cache = new FrameCache(3 * 400);
        for (int frame : new int[] {8, 9, 0, 1}) {            // from 8 on, in the order in which they are shown
            cache.put(frame, picture(10, 10), other -> Math.floorMod(other - 8, FRAMES));
        }

        assertThat(cache.get(1)).isNull();
        assertThat(cache.get(0)).isNotNull();

        cache.put(1, picture(10, 10), other -> Math.floorMod(other - 9, FRAMES));

        assertThat(cache.get(8)).as("8 was shown").isNull();
        assertThat(cache.get(1)).isNotNull();
        assertThat(cache.bytes()).isEqualTo(1200);
    }

    @Test
    void aFinerPictureTakesThePlaceOfACoarseOne() {
        FrameCache cache = new FrameCache(400);
        FrameCache.Kept fine = picture(10, 10);
        cache.put(0, picture(5, 5), other -> other);
        cache.put(0, fine, other -> other);

        assertThat(cache.get(0)).isSameAs(fine);
        assertThat(cache.bytes()).isEqualTo(400);
    }

    @Test
    void itNeverTakesMoreThanItsRoom() {
        Random random = new Random(1);
        FrameCache cache = new FrameCache(5000);
        for (int i = 0; i < 1000; i++) {
            int at = random.nextInt(FRAMES);
            FrameCache.Kept picture = picture(1 + random.nextInt(40), 1 + random.nextInt(40));
            cache.put(random.nextInt(FRAMES), picture, other -> Math.floorMod(other - at, FRAMES));
            long sum = 0;
            for (int frame = 0; frame < FRAMES; frame++) {
                FrameCache.Kept kept = cache.get(frame);
                sum += kept == null ? 0 : 4L * kept.image().getWidth() * kept.image().getHeight();
            }
            assertThat(cache.bytes()).isEqualTo(sum).isLessThanOrEqualTo(5000);
        }
    }
}
