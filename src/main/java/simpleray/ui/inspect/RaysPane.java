package simpleray.ui.inspect;

import java.awt.BorderLayout;
import java.awt.Dimension;
import java.util.List;
import java.util.concurrent.ExecutorService;
import java.util.function.Consumer;
import javax.swing.BorderFactory;
import javax.swing.Box;
import javax.swing.BoxLayout;
import javax.swing.JButton;
import javax.swing.JCheckBox;
import javax.swing.JLabel;
import javax.swing.JPanel;
import simpleray.rays.RaySegment;
import simpleray.scene.RayTree;

/** The rays of a pixel from outside, with buttons that walk from ray to ray. For the event thread. */
final class RaysPane extends JPanel {
    private static final long serialVersionUID = 1L;
    private static final int GAP = 6;
    private static final int MIN_HEIGHT = 360;
    private static final String WIDEST_TITLE = "Pixel 20000, 20000";

    private final RaysView view;
    private final JLabel title = new JLabel(" ");
    private final JLabel place = new JLabel(" ");
    private final transient Consumer<RaySegment> chosen;
    private int at = -1;                                      // the chosen segment; negative for none
    private boolean walking;                                  // those that come later are not shown yet

    RaysPane(ExecutorService drawer, Consumer<String> status, JCheckBox vectors, Consumer<RaySegment> chosen, Runnable close) {
        super(new BorderLayout());
        this.chosen = chosen;
        view = new RaysView(drawer, status, segment -> choose(view().segments().indexOf(segment), true));
        title.setName("rays title");
        place.setName("ray");
        JPanel head = new JPanel();
        head.setLayout(new BoxLayout(head, BoxLayout.X_AXIS));
        head.setBorder(BorderFactory.createEmptyBorder(4, 8, 4, 8));
        title.setMinimumSize(new Dimension(0, 0));
        head.add(title);
        head.add(Box.createHorizontalGlue());
        head.add(vectors);
        head.add(Box.createHorizontalStrut(GAP));
        head.add(button("Back", "Previous Ray (Comma)", () -> step(-1)));
        head.add(Box.createHorizontalStrut(GAP));
        head.add(button("Next", "Next Ray (Period)", () -> step(1)));
        head.add(Box.createHorizontalStrut(GAP));
        head.add(button("Close", "Close Rays (V)", close));
        place.setBorder(BorderFactory.createEmptyBorder(4, 8, 4, 8));
        add(head, BorderLayout.NORTH);
        add(view, BorderLayout.CENTER);
        add(place, BorderLayout.SOUTH);
        title.setText(WIDEST_TITLE);
        setMinimumSize(new Dimension(head.getPreferredSize().width, 0));
        title.setText(" ");
        setPreferredSize(new Dimension(Short.MAX_VALUE, MIN_HEIGHT));  // all that the picture leaves
    }

    /** Draws what nobody sees, so that the first rays come at once. */
    void rehearse() {
        view.rehearse();
    }

    private RaysView view() {
        return view;
    }

    private static JButton button(String text, String tip, Runnable task) {
        JButton button = new JButton(text);
        button.setToolTipText(tip);
        button.getAccessibleContext().setAccessibleName(tip.substring(0, tip.indexOf(" (")));
        button.addActionListener(e -> task.run());
        return button;
    }

    /** Shows the rays of a pixel, all of them. */
    void show(RaysView.Rays rays) {
        title.setText("Pixel " + rays.x() + ", " + rays.y());
        view.show(rays);
        all();
    }

    void setVectors(boolean drawn) {
        view.setVectors(drawn);
        all();
    }

    private void all() {
        at = -1;
        walking = false;
        int number = view.segments().size();
        place.setText(number == 1 ? "1 ray" : number + " rays");
    }

    /** Goes to the next segment or the one before. It begins at the first; the ones after it are hidden until one comes to them. */
    void step(int by) {
        int number = view.segments().size();
        if (number > 0) {
            int from = at >= 0 ? at : by > 0 ? -1 : number;
            walking = true;
            choose(Math.max(0, Math.min(number - 1, from + by)), true);
        }
    }

    /** Chooses what shows a ray, or a light at its hit; the ray if nothing shows that light. */
    @SuppressWarnings("ReferenceEquality")                    // the very ray, not one like it
    void choose(RayTree ray, RayTree.Lamp lamp) {
        List<RaySegment> all = view.segments();
        int found = -1;
        for (int i = 0; i < all.size(); i++) {
            RaySegment segment = all.get(i);
            boolean exact = segment.lamp() == lamp && !segment.kind().isVector();
            if (segment.ray() == ray && (exact || found < 0)) {
                found = i;
                if (exact) {
                    break;
                }
            }
        }
        if (found >= 0 && found != at) {
            choose(found, false);
        }
    }

    private void choose(int index, boolean tell) {
        if (index < 0) {
            return;
        }
        at = index;
        List<RaySegment> all = view.segments();
        RaySegment segment = all.get(index);
        view.select(walking ? index + 1 : all.size(), segment);
        place.setText(index + 1 + " of " + all.size() + ": " + segment.kind().label()
            + (segment.lamp() == null ? "" : ", light " + segment.lamp().light().number()));
        if (tell) {
            chosen.accept(segment);
        }
    }
}
