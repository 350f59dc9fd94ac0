package simpleray.ui.film;

import java.awt.Component;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.geom.Path2D;
import javax.swing.Icon;

/** The signs of a player's buttons, and that of a key, in the colour of the text. <em>Constant.</em> */
enum FilmIcon implements Icon {
    /** A triangle. */
    PLAY("M3 2 L14 8 L3 14 Z"),
    /** Two bars. */
    PAUSE("M3 2 L7 2 L7 14 L3 14 Z M10 2 L14 2 L14 14 L10 14 Z"),
    /** A bar and a triangle to the left. */
    FIRST("M2 3 L4 3 L4 13 L2 13 Z M14 3 L5 8 L14 13 Z"),
    /** A triangle to the right and a bar. */
    LAST("M2 3 L11 8 L2 13 Z M12 3 L14 3 L14 13 L12 13 Z"),
    /** A way round with an arrowhead. */
    LOOP("M2 4 L10 4 L10 1 L15 5.5 L10 10 L10 7 L5 7 L5 12 L14 12 L14 15 L2 15 Z"),
    /** A rhomb. */
    KEY("M4 0 L8 4 L4 8 L0 4 Z", 8);

    private static final int SIDE = 16;

    private final String way;
    private final int side;

    FilmIcon(String way) {
        this(way, SIDE);
    }

    FilmIcon(String way, int side) {
        this.way = way;
        this.side = side;
    }

    @Override
    public void paintIcon(Component c, Graphics g, int x, int y) {
        Path2D path = new Path2D.Double();
        String[] words = way.split(" ", -1);
        for (int i = 0; i < words.length; i++) {
            switch (words[i].charAt(0)) {
                case 'M' -> path.moveTo(Double.parseDouble(words[i].substring(1)), Double.parseDouble(words[++i]));
                case 'L' -> path.lineTo(Double.parseDouble(words[i].substring(1)), Double.parseDouble(words[++i]));
                default -> path.closePath();
            }
        }
        Graphics2D pen = (Graphics2D) g.create();
        pen.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
        pen.translate(x, y);
        pen.setColor(c.isEnabled() ? c.getForeground() : c.getBackground().darker());
        pen.fill(path);
        pen.dispose();
    }

    @Override
    public int getIconWidth() {
        return side;
    }

    @Override
    public int getIconHeight() {
        return side;
    }
}
