package simpleray.ui.widget;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Component;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Line2D;
import java.awt.geom.Path2D;
import javax.swing.Icon;

/** A triangle for a warning, a disc for an error; drawn, so that it is crisp at any scale. */
public final class WarningIcon implements Icon {
    private static final Color AMBER = new Color(0xD99A00);
    private static final Color RED = new Color(0xD03A36);
    private static final int SIDE = 12;

    private final boolean error;

    /** Creates the mark of a warning. */
    public WarningIcon() {
        this(false);
    }

    /**
     * Creates the mark of an error or of a warning.
     *
     * @param error whether it is one of an error
     */
    public WarningIcon(boolean error) {
        this.error = error;
    }

    @Override
    public void paintIcon(Component c, Graphics g, int x, int y) {
        Graphics2D canvas = (Graphics2D) g.create();
        canvas.translate(x, y);
        canvas.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
        canvas.setColor(error ? RED : AMBER);
        Path2D triangle = new Path2D.Double();
        triangle.moveTo(6, 0.5);
        triangle.lineTo(11.8, 11.5);
        triangle.lineTo(0.2, 11.5);
        triangle.closePath();
        canvas.fill(error ? new Ellipse2D.Double(0.5, 0.5, 11, 11) : triangle);
        canvas.setColor(Color.WHITE);
        canvas.setStroke(new BasicStroke(1.5f, BasicStroke.CAP_ROUND, BasicStroke.JOIN_ROUND));
        double top = error ? 3.2 : 4.4;
        canvas.draw(new Line2D.Double(6, top, 6, top + 2.8));
        canvas.fill(new Ellipse2D.Double(5.15, top + 4.2, 1.7, 1.7));
        canvas.dispose();
    }

    @Override
    public int getIconWidth() {
        return SIDE;
    }

    @Override
    public int getIconHeight() {
        return SIDE;
    }
}
