package simpleray.ui.picture;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Cursor;
import java.awt.Graphics2D;
import java.awt.Point;
import java.awt.Rectangle;
import java.awt.event.ActionEvent;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import javax.swing.AbstractAction;
import javax.swing.JComponent;
import javax.swing.JOptionPane;
import javax.swing.KeyStroke;
import javax.swing.SwingUtilities;
import simpleray.render.Region;

/**
 * The region of a picture that is rendered first, or alone: drawn with the mouse while Shift is held, or typed; Esc clears it. All methods
 * are for the event thread.
 */
public final class RegionTool extends MouseAdapter {
    private static final String CLEAR = "clear-region";
    private static final int MIN_DRAG = 3;                  // pixels of the screen; less is a click
    private static final BasicStroke DASHES = new BasicStroke(1, BasicStroke.CAP_BUTT, BasicStroke.JOIN_MITER, 1, new float[] {4, 4}, 0);

    private final SimpleRay picture;
    private Region region;
    private boolean alone;
    private Point from;                                       // where a drag began, and where it is; null for none
    private Point to;

    RegionTool(SimpleRay picture) {
        this.picture = picture;
        picture.addMouseListener(this);
        picture.addMouseMotionListener(this);
        // Esc comes here before it comes to the menus, which go on with it if there is nothing to clear
        picture.getInputMap(JComponent.WHEN_IN_FOCUSED_WINDOW).put(KeyStroke.getKeyStroke("ESCAPE"), CLEAR);
        picture.getActionMap().put(CLEAR, new AbstractAction() {
            private static final long serialVersionUID = 1L;

            @Override
            public boolean isEnabled() {
                return region != null || from != null;
            }

            @Override
            public void actionPerformed(ActionEvent e) {
                boolean dragging = from != null;
                endDrag();
                if (!dragging) {
                    set(null);
                }
            }
        });
    }

    /** {@return the region; null for none, or if the picture shown does not have it} */
    Region region() {
        return region;
    }

    /** {@return whether a region is rendered alone} */
    public boolean isAlone() {
        return alone;
    }

    /**
     * Renders the region alone from now on, or the rest as well.
     *
     * @param only whether the region is rendered alone
     */
    public void setAlone(boolean only) {
        alone = only;
        if (region != null) {
            picture.restart();
        }
    }

    /** Renders a region first, or alone; null to render the rest if that was left out. */
    void set(Region other) {
        boolean rendersAnew = other != null && (alone || picture.whole() == null) || alone && region != null;   // a whole one has all
        region = other;
        picture.repaint();
        if (rendersAnew) {
            picture.restart();
        }
    }

    /** Drops a region that a picture of this size does not have. */
    void fit(int width, int height) {
        if (region != null && !region.isWithin(width, height)) {
            region = null;
        }
    }

    /** Asks for the numbers of a region, for users without a mouse. */
    public void ask() {
        String was = region == null ? "" : region.toString();
        String now = (String) JOptionPane.showInputDialog(SwingUtilities.getWindowAncestor(picture),
            "Column, row, width and height in pixels, such as 100,50,64,48; nothing for no region:", "Region",
            JOptionPane.PLAIN_MESSAGE, null, null, was);
        if (now == null || now.strip().equals(was)) {
            return;
        }
        try {
            set(now.isBlank() ? null : read(now));
        } catch (IllegalArgumentException e) {
            JOptionPane.showMessageDialog(SwingUtilities.getWindowAncestor(picture), e.getMessage(), "Region", JOptionPane.ERROR_MESSAGE);
        }
    }

    private Region read(String text) {
        String[] words = text.strip().split("\\s*,\\s*|\\s+", -1);
        int[] n = new int[4];
        for (int i = 0; i < n.length; i++) {
            if (words.length != n.length || !words[i].matches("\\d{1,9}")) {
                throw new IllegalArgumentException("expected four whole numbers such as 100,50,64,48, found '" + text + "'");
            }
            n[i] = Integer.parseInt(words[i]);
        }
        Region read = new Region(n[0], n[1], n[2], n[3]);
        read.requireWithin(picture.imageSize().width, picture.imageSize().height);
        return read;
    }

    @Override
    public void mousePressed(MouseEvent e) {
        if (SwingUtilities.isLeftMouseButton(e) && e.isShiftDown() && picture.pixelAt(e.getPoint()) != null) {
            from = e.getPoint();
            to = from;
            picture.setCursor(Cursor.getPredefinedCursor(Cursor.CROSSHAIR_CURSOR));
            e.consume();
        }
    }

    @Override
    public void mouseDragged(MouseEvent e) {
        if (from != null) {
            to = within(e.getPoint());
            picture.repaint();
            e.consume();
        }
    }

    @Override
    public void mouseReleased(MouseEvent e) {
        if (from != null && SwingUtilities.isLeftMouseButton(e)) {
            to = within(e.getPoint());
            boolean click = Math.abs(to.x - from.x) < MIN_DRAG && Math.abs(to.y - from.y) < MIN_DRAG;
            Region drawn = click ? null : drawn();
            endDrag();
            set(drawn);
            e.consume();
        }
    }

    private void endDrag() {
        from = null;
        to = null;
        picture.setCursor(null);
        picture.repaint();
    }

    /** {@return the nearest point that shows a pixel} */
    private Point within(Point point) {
        Rectangle place = picture.place();
        return new Point(Math.max(place.x, Math.min(place.x + place.width - 1, point.x)),
            Math.max(place.y, Math.min(place.y + place.height - 1, point.y)));
    }

    /** {@return the pixels from one corner of the drag to the other} */
    private Region drawn() {
        Point a = picture.pixelAt(within(from));
        Point b = picture.pixelAt(within(to));
        return new Region(Math.min(a.x, b.x), Math.min(a.y, b.y), Math.abs(a.x - b.x) + 1, Math.abs(a.y - b.y) + 1);
    }

    /** Draws the region's outline, or that of the one that is being drawn. */
    void paint(Graphics2D screen, Rectangle place) {
        Region outlined = from != null ? drawn() : region;
        if (outlined == null) {
            return;
        }
        double across = place.getWidth() / picture.imageSize().width;
        double down = place.getHeight() / picture.imageSize().height;
        int left = place.x + (int) Math.floor(outlined.x() * across);
        int top = place.y + (int) Math.floor(outlined.y() * down);
        int width = (int) Math.ceil(outlined.width() * across);
        int height = (int) Math.ceil(outlined.height() * down);
        screen.setColor(Color.BLACK);
        screen.drawRect(left - 1, top - 1, width + 1, height + 1);
        screen.setColor(Color.WHITE);
        screen.setStroke(DASHES);
        screen.drawRect(left - 1, top - 1, width + 1, height + 1);
    }
}
