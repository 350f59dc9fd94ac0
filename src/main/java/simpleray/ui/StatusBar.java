package simpleray.ui;

import java.awt.BorderLayout;
import java.awt.Dimension;
import javax.swing.BorderFactory;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JProgressBar;
import simpleray.render.Progress;

/** One line that says how far the rendering is: rows done, time gone, time left, size. */
final class StatusBar extends JPanel {
    private static final long serialVersionUID = 1L;

    private final JLabel text = new JLabel(" ");
    private final JLabel size = new JLabel();
    private final JProgressBar bar = new JProgressBar();

    StatusBar() {
        super(new BorderLayout(12, 0));
        setBorder(BorderFactory.createEmptyBorder(4, 10, 4, 10));
        text.setName("status");
        text.getAccessibleContext().setAccessibleName("Status");
        bar.getAccessibleContext().setAccessibleName("Progress");
        size.setName("size");
        add(bar, BorderLayout.WEST);
        add(text, BorderLayout.CENTER);
        add(size, BorderLayout.EAST);
    }

    /** Shows a short message in place of the progress. */
    void say(String message) {
        text.setText(message);
    }

    void show(Rendering rendering, Dimension shown) {
        Progress progress = rendering.progress();
        int rows = progress == null ? shown.height : progress.rows();
        int done = progress == null ? 0 : progress.finished();
        bar.setMaximum(rows);
        bar.setValue(done);
        bar.setVisible(!rendering.state().ended());
        size.setText(shown.width + " \u00D7 " + shown.height + ", " + rendering.request().stage());
        String counted = done + " of " + rows + " rows, " + Progress.time(rendering.seconds());
        text.setText(switch (rendering.state()) {
            case READING -> "Reading the scene";
            case RENDERING -> "Rendering: " + counted + ", "
                + Progress.time(progress == null ? Double.NaN : progress.left(System.nanoTime())) + " left";
            case FINISHED -> "Finished: " + counted;
            case CANCELLED -> "Cancelled: " + counted;
            case FAILED -> progress == null ? "The scene was not read: see above" : "Failed: " + counted;
        });
    }
}
