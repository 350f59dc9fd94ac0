package simpleray.ui;

import java.awt.BorderLayout;
import java.awt.Dimension;
import java.awt.event.ComponentAdapter;
import java.awt.event.ComponentEvent;
import javax.swing.BorderFactory;
import javax.swing.Box;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JProgressBar;
import simpleray.render.Progress;
import simpleray.ui.picture.RenderJob;

/** One line that says how far the rendering is: rays done, time gone, time left, size. */
final class StatusBar extends JPanel {
    private static final long serialVersionUID = 1L;
    private static final int GAP = 12;
    private static final int BAR = 1000;
    /** In a narrower window the progress in words takes the room of the size, and of most of the bar. */
    private static final int NARROW = 480;

    private final JLabel text = new JLabel(" ");
    private final JLabel size = new JLabel();
    private final JLabel pixel = new JLabel(" ");
    private final Box right = Box.createHorizontalBox();
    private final JProgressBar bar = new JProgressBar();
    private transient RenderJob told;                         // whose progress was shown last
    private boolean said;                                     // a message stands in place of it

    StatusBar() {
        super(new BorderLayout(GAP, 0));
        setBorder(BorderFactory.createEmptyBorder(4, 10, 4, 10));
        text.setName("status");
        text.getAccessibleContext().setAccessibleName("Status");
        bar.getAccessibleContext().setAccessibleName("Progress");
        size.setName("size");
        pixel.setName("pixel");
        pixel.getAccessibleContext().setAccessibleName("Pixel");
        add(bar, BorderLayout.WEST);
        add(text, BorderLayout.CENTER);
        right.add(size);
        add(right, BorderLayout.EAST);
        right.setVisible(false);                              // until there is a picture
        add(pixel, BorderLayout.SOUTH);
        addComponentListener(new ComponentAdapter() {
            @Override
            public void componentResized(ComponentEvent e) {
                boolean wide = getWidth() >= NARROW;
                size.setVisible(wide);
                bar.setPreferredSize(wide ? null : new Dimension(NARROW / 8, bar.getMinimumSize().height));
                revalidate();
            }
        });
    }

    /** Adds something at the right end. */
    void addRight(JComponent other) {
        right.add(Box.createHorizontalStrut(GAP));
        right.add(other);
    }

    /** Shows a short message in place of the progress, until another rendering begins or there is something that must be known. */
    void say(String message) {
        said = true;
        write(message);
    }

    /** Lets the progress take the place of a message. */
    void unsay() {
        said = false;
    }

    private void write(String message) {
        text.setText(message);
        text.setToolTipText(message);
    }

    /** Shows a line about a pixel, or a blank. */
    void showPixel(String line) {
        pixel.setText(line);
        pixel.setToolTipText(line.isBlank() ? null : line);   // a narrow window cuts it
    }

    /** Shows how far a rendering is, or was a moment ago, and the size of the picture; null if there is none. */
    void show(RenderJob job, RenderJob.Snapshot now, Dimension shown) {
        Progress progress = now.progress();
        bar.setMaximum(BAR);
        bar.setValue((int) (BAR * job.runs().share()));
        bar.setVisible(!now.state().ended());
        right.setVisible(shown != null);
        size.setText(shown == null ? "" : shown.width + " \u00D7 " + shown.height + ", " + job.request().stage());
        String counted = job.runs().traced(now.state() == RenderJob.State.FINISHED) + ", " + Progress.time(now.seconds());
        said = said && job == told && !job.isPaused() && now.state() != RenderJob.State.FAILED && now.state() != RenderJob.State.CANCELLED;
        told = job;
        if (said) {
            return;
        }
        write(switch (now.state()) {
            case READING -> "Reading the scene";
            case RENDERING -> job.isPaused() ? "Paused: " + counted : "Rendering: " + counted + ", "
                + Progress.time(progress == null ? Double.NaN : progress.left(System.nanoTime())) + " left";
            case FINISHED -> "Finished: " + counted;
            case CANCELLED -> "Cancelled: " + counted;
            case FAILED -> progress == null ? "The scene was not read: see above" : "Failed: " + counted;
        });
    }
}
