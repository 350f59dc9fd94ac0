package simpleray.ui.compare;

import java.awt.BorderLayout;
import java.awt.Color;
import java.awt.Dimension;
import java.awt.Graphics;
import java.awt.GridLayout;
import java.util.Locale;
import javax.swing.BorderFactory;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.UIManager;
import simpleray.ui.widget.DrawnComponent;

/** How often each light occurs in the picture: a chart for each channel from 0 to 1, with the counts below and above at its ends. */
final class HistogramPane extends JPanel {
    private static final long serialVersionUID = 1L;
    private static final String[] NAMES = {"Red", "Green", "Blue"};
    private static final Color[] COLOURS = {new Color(0xE05050), new Color(0x40A850), new Color(0x5080E8)};
    private static final int MARGIN = 8;
    private static final int CHART_WIDTH = Histogram.BINS + 2 * Chart.END;

    private final JLabel[] texts = new JLabel[Histogram.CHANNELS];
    private final Chart[] charts = new Chart[Histogram.CHANNELS];
    private transient Histogram histogram;
    private boolean logarithmic;

    HistogramPane() {
        super(new GridLayout(Histogram.CHANNELS, 1, 0, MARGIN));
        setName("histogram");
        setBorder(BorderFactory.createEmptyBorder(MARGIN, MARGIN, MARGIN, MARGIN));
        getAccessibleContext().setAccessibleName("Histogram");
        for (int c = 0; c < Histogram.CHANNELS; c++) {
            texts[c] = new JLabel(NAMES[c]);
            charts[c] = new Chart(c);
            JPanel channel = new JPanel(new BorderLayout(0, 2));
            channel.add(texts[c], BorderLayout.NORTH);
            channel.add(charts[c], BorderLayout.CENTER);
            add(channel);
        }
    }

    /** Shows a histogram; null for none. */
    void show(Histogram other) {
        histogram = other;
        for (int c = 0; c < Histogram.CHANNELS; c++) {
            String text = other == null ? NAMES[c] + "; " : text(other, c);
            texts[c].setText("<html>" + text.replace("; ", "<br>"));   // two lines, so that the pane keeps its width
            charts[c].getAccessibleContext().setAccessibleDescription(text);
        }
        repaint();
    }

    /** {@return the numbers of a channel} */
    static String text(Histogram histogram, int channel) {
        return String.format(Locale.ROOT, "%s: %.3f to %.3f, mean %.3f; %d below 0, %d above 1", NAMES[channel], histogram.least(channel),
            histogram.most(channel), histogram.mean(channel), histogram.below(channel), histogram.above(channel));
    }

    /** Draws counts by their logarithm, or as they are. */
    void setLogarithmic(boolean other) {
        logarithmic = other;
        repaint();
    }

    /** The chart of a channel: below 0, the bins from 0 to 1, above 1. */
    final class Chart extends DrawnComponent {
        /** The width of each end, with a gap between it and the bins. */
        static final int END = 8;
        private static final long serialVersionUID = 1L;
        private static final int BAR = 6;

        private final int channel;

        Chart(int channel) {
            super("Histogram of " + NAMES[channel]);
            this.channel = channel;
            setName(NAMES[channel]);
            setPreferredSize(new Dimension(CHART_WIDTH, 80));
        }

        /** {@return the height of a bar} */
        int bar(long count) {
            long highest = histogram == null ? 0 : histogram.highest();
            if (count == 0 || highest == 0) {
                return 0;
            }
            double share = logarithmic ? Math.log1p((double) count) / Math.log1p((double) highest) : (double) count / highest;
            return Math.max(1, (int) Math.round(share * getHeight()));
        }

        @Override
        protected void paintComponent(Graphics g) {
            g.setColor(UIManager.getColor("TextArea.background"));
            g.fillRect(0, 0, getWidth(), getHeight());
            if (histogram == null) {
                return;
            }
            int room = getWidth() - 2 * END;
            g.setColor(COLOURS[channel]);
            for (int bin = 0; bin < Histogram.BINS; bin++) {
                int from = END + bin * room / Histogram.BINS;
                int to = END + (bin + 1) * room / Histogram.BINS;
                fill(g, from, Math.max(1, to - from), histogram.count(channel, bin));
            }
            g.setColor(new Color(Clipped.BELOW_COLOUR));
            fill(g, 0, BAR, histogram.below(channel));
            g.setColor(new Color(Clipped.ABOVE_COLOUR));
            fill(g, getWidth() - BAR, BAR, histogram.above(channel));
        }

        private void fill(Graphics g, int x, int width, long count) {
            int height = bar(count);
            g.fillRect(x, getHeight() - height, width, height);
        }
    }
}
