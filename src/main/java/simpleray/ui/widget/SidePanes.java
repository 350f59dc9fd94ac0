package simpleray.ui.widget;

import java.awt.event.ComponentAdapter;
import java.awt.event.ComponentEvent;
import java.util.function.Consumer;
import javax.swing.BorderFactory;
import javax.swing.JComponent;
import javax.swing.JSplitPane;
import javax.swing.JTabbedPane;

/**
 * The picture, and beside it the scene's text and what is told about a pixel: both in columns of their own where there is room for three, else
 * one behind the other, with tabs. They leave the picture two fifths of the width at least. For the event thread.
 */
public final class SidePanes extends JSplitPane {
    private static final long serialVersionUID = 1L;
    private static final int DIVIDER = 6;
    private static final double HALF = 0.5;
    private static final double MIN_SHARE = 0.4;              // of the picture
    private static final int MIN_THREE = 1600;                // the width from which there are three columns

    private final JTabbedPane tabs = new JTabbedPane();
    private final JSplitPane columns = new JSplitPane(HORIZONTAL_SPLIT);
    private JComponent text;                                  // null while it is not wanted
    private JComponent pixel;
    private transient Consumer<Runnable> keeper = Runnable::run;
    private boolean wide;                                     // what is beside the picture now takes all that the picture leaves
    private int given;                                        // the width that it has given to what is elsewhere in the window

    /** Creates a pane with nothing in it. */
    public SidePanes() {
        super(HORIZONTAL_SPLIT);
        setBorder(BorderFactory.createEmptyBorder());
        setDividerSize(0);
        setRightComponent(null);
        columns.setBorder(BorderFactory.createEmptyBorder());
        columns.setResizeWeight(HALF);
        tabs.setName("panes");
        tabs.setFocusable(false);                             // keys stay with the picture
        addComponentListener(new ComponentAdapter() {
            @Override
            public void componentResized(ComponentEvent e) {
                leaveShare();
            }
        });
    }

    /**
     * Sets what keeps the picture in its place while other panes come and go.
     *
     * @param other runs the change that it gets, which lays the window out
     */
    public void setKeeper(Consumer<Runnable> other) {
        keeper = other;
    }

    /**
     * Shows or hides something elsewhere in the window, so that the picture keeps its place if it can, and its share: first, what is beside
     * it gives of its room, and gets that back later.
     *
     * @param change changes the window
     */
    public void change(Runnable change) {
        keeper.accept(() -> {
            int width = getWidth();
            int side = width - getDividerLocation();
            change.run();
            getRootPane().validate();
            if (isOpen()) {
                int spare = Math.max(0, side - DIVIDER - getRightComponent().getMinimumSize().width);
                int gives = Math.max(-given, Math.min(width - getWidth(), spare));
                given += gives;
                setDividerLocation(getWidth() - side + gives);
                leaveShare();
            }
            validate();
        });
    }

    private void leaveShare() {
        if (isOpen() && getDividerLocation() < least()) {
            setDividerLocation(least());
        }
    }

    /**
     * Shows the scene's text, in front.
     *
     * @param other the text, in the look of the window; null to hide it
     */
    public void showText(JComponent other) {
        text = other;
        keeper.accept(() -> arrange(other, 0));
    }

    /**
     * Shows what is told about a pixel, in front.
     *
     * @param other what is told, in the look of the window; null to hide it
     * @param free how far from the left the picture is to be seen, if that leaves enough for what is told
     */
    public void showPixel(JComponent other, int free) {
        pixel = other;
        keeper.accept(() -> arrange(other, free));
    }

    /** {@return whether there is something beside the picture} */
    public boolean isOpen() {
        return getRightComponent() != null;
    }

    /**
     * Brings what is beside the picture to the front.
     *
     * @param part the text, or what is told about a pixel; null for nothing
     * @return whether it was behind the other one
     */
    public boolean raise(JComponent part) {
        boolean hidden = part != null && tabs.indexOfComponent(part) >= 0 && tabs.getSelectedComponent() != part;
        if (hidden) {
            tabs.setSelectedComponent(part);
        }
        return hidden;
    }

    /** {@return the least width of the picture: what is beside these panes in the window takes nothing of its share} */
    private int least() {
        return leastOf(getRootPane() == null ? getWidth() : getRootPane().getContentPane().getWidth());
    }

    /**
     * {@return how much of a window the picture has at least, whatever panes are open}
     *
     * @param whole the width or height of the window's content
     */
    public static int leastOf(int whole) {
        return (int) Math.ceil(MIN_SHARE * whole);
    }

    /** {@return the width of the widest pane beside the picture, which takes half, or all that the picture leaves} */
    public int widest() {
        return Math.max(0, getWidth() - half());
    }

    private int half() {
        return Math.max(getWidth() / 2, least());
    }

    private void arrange(JComponent front, int free) {
        boolean both = text != null && pixel != null;
        boolean three = both && getWidth() >= MIN_THREE;
        JComponent side = three ? columns : both ? tabs : text != null ? text : pixel;
        boolean keep = isOpen() && wide;
        int divider = getDividerLocation();
        tabs.removeAll();
        columns.removeAll();
        if (three) {
            columns.updateUI();
            columns.setLeftComponent(text);
            columns.setRightComponent(pixel);
        } else if (both) {
            tabs.updateUI();
            tabs.addTab("Text", text);
            tabs.addTab("Pixel", pixel);
            tabs.setSelectedComponent(front != null ? front : text);
        }
        setRightComponent(side);
        setDividerSize(side == null ? 0 : DIVIDER);
        if (side == null) {
            validate();
            return;
        }
        int width = getWidth();
        int alone = width - DIVIDER - side.getPreferredSize().width;
        wide = text != null || alone < half();
        setResizeWeight(wide ? HALF : 1);
        int left = given > 0 && !wide ? Math.max(divider, free) : free;   // less beside it makes the picture no smaller
        given = keep && wide ? given : 0;
        setDividerLocation(keep && wide ? Math.max(divider, least()) : three ? least()
            : Math.max(wide ? half() : alone, Math.min(left, width - DIVIDER - side.getMinimumSize().width)));
        validate();
        if (three) {
            columns.setDividerLocation(HALF);
            columns.validate();
        }
    }
}
