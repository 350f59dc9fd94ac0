package simpleray.ui.compare;

import java.awt.BorderLayout;
import java.awt.image.BufferedImage;
import java.time.LocalTime;
import java.time.ZoneId;
import java.util.List;
import java.util.concurrent.Executor;
import java.util.function.Consumer;
import javax.swing.Action;
import javax.swing.JCheckBoxMenuItem;
import javax.swing.JMenu;
import javax.swing.JScrollPane;
import javax.swing.SwingUtilities;
import simpleray.image.Picture;
import simpleray.render.RenderRequest;
import simpleray.ui.file.SceneSource;
import simpleray.ui.picture.SimpleRay;
import simpleray.ui.picture.ViewerContext;
import simpleray.ui.widget.KeyBindings;
import simpleray.ui.widget.Lazy;

/** Looks at finished pictures: compares the last ones, marks clipped pixels, counts the light. For the event thread. */
public final class Comparison {
    private static final List<String> WIPING =
        List.of("Drag: move the divider", "W: back to the picture", "Left, Right: move it by 1 %", "F1: help");
    private static final List<String> BESIDE = List.of("B: back to the picture", "F1: help");

    private final ViewerContext window;
    private final History history = new History();
    private final Lazy<ComparePane> pane = new Lazy<>(this::newPane);
    private final Lazy<HistogramPane> counted = new Lazy<>(this::newHistogram);
    private final JCheckBoxMenuItem beside = item("Side by Side", "B", this::changeMode);
    private final JCheckBoxMenuItem wipe = item("Wipe", "W", this::changeMode);
    private final JCheckBoxMenuItem marks = item("Mark Clipped Pixels", "X", this::mark);
    private final JCheckBoxMenuItem histogram = item("Histogram", "H", this::showHistogram);
    private final JCheckBoxMenuItem logarithmic = item("Logarithmic Counts", "L", this::countByLogarithm);
    private final Executor looker;
    private Consumer<List<String>> teller = gestures -> { };
    private JScrollPane place;                                // where the picture is when it is not compared
    private Picture seen;
    private FinishedRender latest;                            // its levels and light; null until they are evaluated

    /**
     * Creates a comparison of nothing yet.
     *
     * @param window the window
     */
    public Comparison(ViewerContext window) {
        this.window = window;
        looker = window.workers().stopping("simpleray-looking");
        allow();
    }

    /**
     * Sets what tells the user what the mouse and keys do.
     *
     * @param other gets a few words for each gesture that works while pictures are compared; null when the picture is back
     */
    public void setTeller(Consumer<List<String>> other) {
        teller = other;
    }

    private JCheckBoxMenuItem item(String name, String key, Runnable task) {
        Action action = KeyBindings.action(name, key, task);
        return new JCheckBoxMenuItem(action);
    }

    private ComparePane newPane() {
        ComparePane made = new ComparePane(looker, window.picture()::maxScale);
        made.setMarked(marks.isSelected());
        window.picture().addPropertyChangeListener(SimpleRay.ZOOM, e -> made.view().repaint());
        made.view().addPropertyChangeListener(CompareView.SCALE, e -> tellScale());
        return made;
    }

    private void tellScale() {
        window.picture().setStandIn(isComparing() ? pane.get().view()::scale : null);
    }

    private HistogramPane newHistogram() {
        HistogramPane made = new HistogramPane();
        made.setLogarithmic(logarithmic.isSelected());
        made.show(latest == null ? null : latest.histogram());
        return made;
    }

    /**
     * Adds the items that compare two pictures.
     *
     * @param menu the menu to add to
     */
    public void addModesTo(JMenu menu) {
        menu.add(beside);
        menu.add(wipe);
    }

    /**
     * Adds the items that show more of one picture.
     *
     * @param view the View menu
     */
    public void addTo(JMenu view) {
        view.addSeparator();
        view.add(marks);
        view.add(histogram);
        view.add(logarithmic);
    }

    /**
     * Looks at the picture if it is another than before.
     *
     * @param there whether there is a picture, or one to come
     */
    public void refresh(boolean there) {
        marks.setEnabled(there || marks.isSelected());
        histogram.setEnabled(there || histogram.isSelected());
        SimpleRay shown = window.picture();
        Picture whole = shown.whole();
        if (whole == seen) {
            return;
        }
        seen = whole;
        latest = null;
        shown.setMarks(null);
        if (whole != null && FinishedRender.canKeep(whole)) {
            look(whole, shown.source(), shown.job().snapshot().request(), shown.job().snapshot().seconds());
        }
    }

    private void look(Picture picture, SceneSource source, RenderRequest request, double seconds) {
        LocalTime now = LocalTime.now(ZoneId.systemDefault());
        looker.execute(() -> {
            try {
                FinishedRender found = new FinishedRender(picture, source, request, seconds, now);
                SwingUtilities.invokeLater(() -> take(picture, found));
            } catch (OutOfMemoryError e) {                    // then this one is not compared
                SwingUtilities.invokeLater(() -> window.say("The memory is too short to keep the picture for comparing"));
            }
        });
    }

    private void take(Picture picture, FinishedRender found) {
        history.add(found);
        if (picture == seen) {
            latest = found;
            counted.ifMade(counts -> counts.show(found.histogram()));
            if (marks.isSelected()) {                         // if not, a message may stand there that is to be read
                mark();
            }
        }
        if (isComparing()) {
            pane.get().list(history.pictures());
        }
        allow();
    }

    private void allow() {
        boolean two = isComparing() || history.pictures().size() > 1;
        beside.setEnabled(two);
        wipe.setEnabled(two);
    }

    private boolean isComparing() {
        return beside.isSelected() || wipe.isSelected();
    }

    /** One mode ends the other, and a second press of its key ends it. */
    private void changeMode() {
        ComparePane compared = pane.get();
        boolean wiped = wipe.isSelected() && !(beside.isSelected() && compared.view().isWiped());
        if (beside.isSelected() && wipe.isSelected()) {       // the other was on until now
            beside.setSelected(!wiped);
            wipe.setSelected(wiped);
        }
        compared.view().setWiped(wipe.isSelected());
        teller.accept(wipe.isSelected() ? WIPING : beside.isSelected() ? BESIDE : null);
        if (isComparing() && place == null) {
            place = (JScrollPane) SwingUtilities.getAncestorOfClass(JScrollPane.class, window.picture());
            SwingUtilities.updateComponentTreeUI(compared);       // the look may be another since
            compared.list(history.pictures());
            place.setViewportView(compared);
            tellScale();
            compared.view().requestFocusInWindow();
        } else if (!isComparing() && place != null) {
            place.setViewportView(window.picture());
            tellScale();
            place = null;
            compared.list(List.of());                         // or it would hold two that the machine may want back
            window.picture().requestFocusInWindow();
        }
        allow();
    }

    private void mark() {
        boolean marked = marks.isSelected();
        pane.ifMade(compared -> compared.setMarked(marked));
        FinishedRender found = marked ? latest : null;
        if (found == null) {
            window.picture().setMarks(null);
            window.showProgress();                            // in place of the counts
        } else {
            looker.execute(() -> {
                BufferedImage made = found.marks();
                SwingUtilities.invokeLater(() -> {
                    if (found == latest && marks.isSelected()) {
                        window.picture().setMarks(made);
                    }
                });
            });
            Histogram light = found.histogram();
            window.say(light.clippedAbove() + " pixels above 1 (magenta), " + light.clippedBelow() + " below 0 (cyan), of "
                + light.pixels());
        }
    }

    private void showHistogram() {
        if (histogram.isSelected()) {
            SwingUtilities.updateComponentTreeUI(counted.get());
            window.sides().change(() -> window.frame().add(counted.get(), BorderLayout.EAST));
        } else {
            window.sides().change(() -> window.frame().remove(counted.get()));
        }
        window.frame().repaint();
    }

    private void countByLogarithm() {
        counted.ifMade(counts -> counts.setLogarithmic(logarithmic.isSelected()));
    }

    /** {@return the pictures that can be compared, the latest last} */
    public List<FinishedRender> pictures() {
        return history.pictures();
    }
}
