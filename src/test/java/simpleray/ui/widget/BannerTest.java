package simpleray.ui.widget;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Component;
import java.util.Arrays;
import java.util.List;
import javax.swing.JLayeredPane;
import javax.swing.JPanel;
import org.junit.jupiter.api.Test;

/** Notices over a row of buttons. */
class BannerTest {
    private static final int HEIGHT = 60;

    @Test
    void ofSeveralNoticesTheLatestIsSeenAndCoversNothingBelow() {
        JLayeredPane pane = new JLayeredPane();
        JPanel row = new JPanel();
        row.setBounds(0, 20, 400, HEIGHT);
        pane.add(row);
        Banner banner = new Banner(row);
        pane.add(banner);
        banner.show("a", "The first");
        banner.show("b", "The second");
        assertThat(seen(banner)).containsExactly("The second");
        assertThat(banner.getBounds().y).isEqualTo(20);
        assertThat(banner.getHeight()).isEqualTo(HEIGHT);
        assertThat(banner.message("a")).isEqualTo("The first");

        banner.hide("b");
        assertThat(seen(banner)).containsExactly("The first");
        banner.hide("a");
        assertThat(banner.isVisible()).isFalse();
    }

    private static List<String> seen(Banner banner) {
        return Arrays.stream(banner.getComponents()).filter(Component::isVisible)
            .map(notice -> notice.getAccessibleContext().getAccessibleName()).toList();
    }
}
