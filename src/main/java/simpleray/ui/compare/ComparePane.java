package simpleray.ui.compare;

import java.awt.BorderLayout;
import java.awt.Dimension;
import java.awt.GridLayout;
import java.awt.Rectangle;
import java.awt.event.KeyEvent;
import java.awt.image.BufferedImage;
import java.util.List;
import java.util.concurrent.Executor;
import java.util.function.DoubleSupplier;
import javax.swing.BorderFactory;
import javax.swing.DefaultComboBoxModel;
import javax.swing.JButton;
import javax.swing.JComboBox;
import javax.swing.JPanel;
import javax.swing.Scrollable;
import javax.swing.SwingUtilities;

/** Two of the last pictures, which are chosen above them. In place of the picture, in its scroll pane. */
final class ComparePane extends JPanel implements Scrollable {
    private static final long serialVersionUID = 1L;
    private static final int MARGIN = 4;

    private final JComboBox<FinishedRender> left = choice("Left picture");
    private final JComboBox<FinishedRender> right = choice("Right picture");
    private final CompareView view;
    private final transient Executor looker;
    private boolean marked;
    private boolean listing;

    /**
     * Creates the pane.
     *
     * @param looker runs long tasks on another thread
     * @param maxScale tells the largest scale that pictures are shown at, in screen pixels for a pixel
     */
    ComparePane(Executor looker, DoubleSupplier maxScale) {
        super(new BorderLayout());
        view = new CompareView(maxScale);
        this.looker = looker;
        setName("compare");
        JButton swap = new JButton("Swap");
        swap.setMnemonic(KeyEvent.VK_W);
        swap.addActionListener(e -> swap());
        JPanel choices = new JPanel(new GridLayout(1, 2, MARGIN, 0));
        choices.add(left);
        choices.add(right);
        JPanel bar = new JPanel(new BorderLayout(MARGIN, 0));
        bar.setBorder(BorderFactory.createEmptyBorder(MARGIN, MARGIN, MARGIN, MARGIN));
        bar.add(choices, BorderLayout.CENTER);
        bar.add(swap, BorderLayout.EAST);
        add(bar, BorderLayout.NORTH);
        add(view, BorderLayout.CENTER);
    }

    private JComboBox<FinishedRender> choice(String name) {
        JComboBox<FinishedRender> box = new JComboBox<>();
        box.setName(name);
        box.getAccessibleContext().setAccessibleName(name);
        box.setKeySelectionManager((key, model) -> -1);       // keys are the menus', 1 is no picture's first letter
        box.addActionListener(e -> showChosen());
        return box;
    }

    CompareView view() {
        return view;
    }

    /** Lists the pictures, the latest last. A choice of the latest becomes the new one; a choice that is gone becomes the oldest. */
    void list(List<FinishedRender> pictures) {
        boolean latest = right.getSelectedIndex() == right.getItemCount() - 1;
        Object one = left.getSelectedItem();
        Object other = right.getSelectedItem();
        boolean fresh = one == null;
        listing = true;
        left.setModel(new DefaultComboBoxModel<>(pictures.toArray(new FinishedRender[0])));
        right.setModel(new DefaultComboBoxModel<>(pictures.toArray(new FinishedRender[0])));
        if (!pictures.isEmpty()) {
            FinishedRender last = pictures.get(pictures.size() - 1);
            left.setSelectedItem(fresh ? pictures.get(Math.max(0, pictures.size() - 2)) : pictures.contains(one) ? one : pictures.get(0));
            right.setSelectedItem(latest || !pictures.contains(other) ? last : other);
        }
        listing = false;
        showChosen();
    }

    /** Marks clipped pixels, or not. */
    void setMarked(boolean mark) {
        marked = mark;
        showChosen();
    }

    private void swap() {
        Object one = left.getSelectedItem();
        left.setSelectedItem(right.getSelectedItem());
        right.setSelectedItem(one);
    }

    private void showChosen() {
        if (!listing && view != null) {
            FinishedRender one = (FinishedRender) left.getSelectedItem();
            FinishedRender other = (FinishedRender) right.getSelectedItem();
            view.setPictures(image(left), image(right));
            if (marked && one != null && other != null) {
                looker.execute(() -> mark(one, other));
            }
        }
    }

    /** Finds the marks of two pictures, and shows them if these are still the ones that are compared. */
    private void mark(FinishedRender one, FinishedRender other) {
        BufferedImage ones = one.marks();
        BufferedImage others = other.marks();
        SwingUtilities.invokeLater(() -> {
            if (marked && one == left.getSelectedItem() && other == right.getSelectedItem()) {
                view.setMarks(ones, others);
            }
        });
    }

    private BufferedImage image(JComboBox<FinishedRender> box) {
        FinishedRender chosen = (FinishedRender) box.getSelectedItem();
        box.setToolTipText(chosen == null ? null : chosen.options());
        int[] pixels = chosen == null ? null : chosen.pixels();
        return pixels == null ? null : Clipped.image(pixels, chosen.width(), chosen.height());
    }

    @Override
    public Dimension getPreferredScrollableViewportSize() {
        return getPreferredSize();
    }

    @Override
    public int getScrollableUnitIncrement(Rectangle visible, int orientation, int direction) {
        return 1;
    }

    @Override
    public int getScrollableBlockIncrement(Rectangle visible, int orientation, int direction) {
        return 1;
    }

    @Override
    public boolean getScrollableTracksViewportWidth() {
        return true;
    }

    @Override
    public boolean getScrollableTracksViewportHeight() {
        return true;
    }
}
