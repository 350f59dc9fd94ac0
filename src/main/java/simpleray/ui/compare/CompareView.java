package simpleray.ui.compare;

import java.awt.Color;
import java.awt.Cursor;
import java.awt.Dimension;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.Rectangle;
import java.awt.RenderingHints;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.awt.image.BufferedImage;
import java.util.function.DoubleSupplier;
import simpleray.ui.widget.DrawnComponent;
import simpleray.ui.widget.KeyBindings;

/** Two pictures side by side, or one over the other with a divider between their visible parts. */
final class CompareView extends DrawnComponent {
    /** The property that changes with the scale. */
    static final String SCALE = "scale";

    private static final long serialVersionUID = 1L;
    private static final Color SURROUND = new Color(0x3C3F41);
    private static final int GAP = 8;
    private static final int GRIP = 7;
    private static final double STEP = 0.01;
    private static final double LEAP = 0.1;

    private transient BufferedImage left;
    private transient BufferedImage right;
    private transient BufferedImage leftMarks;                // painted over them; null for none
    private transient BufferedImage rightMarks;
    private final transient DoubleSupplier maxScale;
    private boolean wiped;
    private double shownScale = 1;
    private double divider = 0.5;                             // 0 at the left edge of the pictures, 1 at the right

    /** A view that shows pictures at most at a scale, in screen pixels for a pixel, and at a smaller one where that does not fit. */
    CompareView(DoubleSupplier maxScale) {
        super("Comparison");
        this.maxScale = maxScale;
        setName("comparison");
        setFocusable(true);
        setOpaque(true);
        addKey("LEFT", -STEP);
        addKey("RIGHT", STEP);
        addKey("shift LEFT", -LEAP);
        addKey("shift RIGHT", LEAP);
        addKey("HOME", -1);
        addKey("END", 1);
        MouseAdapter mouse = new MouseAdapter() {
            @Override
            public void mousePressed(MouseEvent e) {
                requestFocusInWindow();
                mouseDragged(e);
            }

            @Override
            public void mouseDragged(MouseEvent e) {
                Rectangle place = place();
                if (wiped && !place.isEmpty()) {
                    setDivider((double) (e.getX() - place.x) / place.width);
                }
            }
        };
        addMouseListener(mouse);
        addMouseMotionListener(mouse);
    }

    private void addKey(String key, double step) {
        KeyBindings.bind(this, WHEN_FOCUSED, key, () -> {
            if (wiped) {
                setDivider(divider + step);
            }
        });
    }

    /** Shows two pictures, which may differ in size; null for one that is gone. */
    void setPictures(BufferedImage one, BufferedImage other) {
        left = one;
        right = other;
        setMarks(null, null);
    }

    /** Paints something of the same size over each; null for nothing. */
    void setMarks(BufferedImage one, BufferedImage other) {
        leftMarks = one;
        rightMarks = other;
        repaint();
    }

    /** Shows them over each other, or side by side. */
    void setWiped(boolean over) {
        wiped = over;
        setCursor(Cursor.getPredefinedCursor(over ? Cursor.E_RESIZE_CURSOR : Cursor.DEFAULT_CURSOR));
        describe();
        repaint();
    }

    boolean isWiped() {
        return wiped;
    }

    /** Moves the divider: 0 is the left edge, 1 the right. */
    void setDivider(double place) {
        divider = Math.max(0, Math.min(1, place));
        describe();
        repaint();
    }

    double divider() {
        return divider;
    }

    private void describe() {
        getAccessibleContext().setAccessibleDescription(wiped ? "Divider at " + Math.round(100 * divider) + " %" : "Side by side");
    }

    /** {@return where the pictures are that are over each other} */
    Rectangle place() {
        return fitted(left != null ? left : right, new Rectangle(getSize()));
    }

    /** {@return where the left picture is of two that are side by side} */
    Rectangle leftPlace() {
        return fitted(left, new Rectangle(0, 0, (getWidth() - GAP) / 2, getHeight()));
    }

    /** {@return where the right picture is of two that are side by side} */
    Rectangle rightPlace() {
        int half = (getWidth() - GAP) / 2;
        return fitted(right, new Rectangle(getWidth() - half, 0, half, getHeight()));
    }

    /** {@return the scale of the left picture, or of the right one if that is there alone, in screen pixels for a pixel} */
    double scale() {
        BufferedImage image = left != null ? left : right;
        return image == null ? 1 : ui() * (wiped ? place() : left != null ? leftPlace() : rightPlace()).width / image.getWidth();
    }

    /** {@return the middle of a room} */
    private Rectangle fitted(BufferedImage image, Rectangle room) {
        if (image == null || room.isEmpty()) {
            return new Rectangle();
        }
        double scale = Math.min(maxScale.getAsDouble() / ui(),
            Math.min((double) room.width / image.getWidth(), (double) room.height / image.getHeight()));
        int width = (int) Math.max(1, Math.round(image.getWidth() * scale));
        int height = (int) Math.max(1, Math.round(image.getHeight() * scale));
        return new Rectangle(room.x + (room.width - width) / 2, room.y + (room.height - height) / 2, width, height);
    }

    @Override
    protected void paintComponent(Graphics g) {
        Graphics2D canvas = (Graphics2D) g.create();
        canvas.setColor(SURROUND);
        canvas.fillRect(0, 0, getWidth(), getHeight());
        if (wiped) {
            paintWiped(canvas);
        } else {
            draw(canvas, left, leftPlace());
            draw(canvas, leftMarks, leftPlace());
            draw(canvas, right, rightPlace());
            draw(canvas, rightMarks, rightPlace());
        }
        canvas.dispose();
        double before = shownScale;
        shownScale = scale();
        firePropertyChange(SCALE, before, shownScale);
    }

    private void paintWiped(Graphics2D canvas) {
        Rectangle place = place();
        int x = place.x + (int) Math.round(divider * place.width);
        Graphics2D before = (Graphics2D) canvas.create();
        before.clipRect(0, 0, x, getHeight());
        draw(before, left, place);
        draw(before, leftMarks, place);
        before.dispose();
        Graphics2D behind = (Graphics2D) canvas.create();
        behind.clipRect(x, 0, getWidth() - x, getHeight());
        draw(behind, right, place);
        draw(behind, rightMarks, place);
        behind.dispose();
        canvas.setColor(Color.BLACK);
        canvas.fillRect(x - 1, place.y, 3, place.height);
        canvas.setColor(Color.WHITE);
        canvas.fillRect(x, place.y, 1, place.height);
        int middle = place.y + place.height / 2;
        canvas.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
        canvas.fillOval(x - GRIP, middle - GRIP, 2 * GRIP + 1, 2 * GRIP + 1);
        canvas.setColor(Color.BLACK);
        canvas.drawOval(x - GRIP, middle - GRIP, 2 * GRIP, 2 * GRIP);
    }

    private static void draw(Graphics2D canvas, BufferedImage image, Rectangle place) {
        if (image != null) {
            canvas.setRenderingHint(RenderingHints.KEY_INTERPOLATION, place.width < image.getWidth()
                ? RenderingHints.VALUE_INTERPOLATION_BILINEAR : RenderingHints.VALUE_INTERPOLATION_NEAREST_NEIGHBOR);
            canvas.drawImage(image, place.x, place.y, place.width, place.height, null);
        }
    }

    @Override
    public Dimension getPreferredSize() {
        return new Dimension(0, 0);                           // whatever room there is
    }
}
