package simpleray.ui.editor;

import java.awt.Color;
import java.awt.Graphics;
import java.awt.Point;
import java.awt.Rectangle;
import java.math.BigDecimal;
import java.math.RoundingMode;
import java.util.Arrays;
import java.util.Collections;
import javax.swing.JColorChooser;
import javax.swing.JPanel;
import javax.swing.colorchooser.AbstractColorChooserPanel;
import javax.swing.text.BadLocationException;
import simpleray.image.Picture;
import simpleray.text.NumberParser;

/** Shows the colours of the text, each by a bar below its numbers, and lets the user pick others. For the event thread. */
final class ColourTool {
    /** The least height of a bar; else it fills the room below the numbers, so that their points are seen. */
    private static final int MIN_BAR = 3;
    private static final int COUNT = 3;
    private static final double LEVELS = 255;
    /** Decimals that tell each of the levels from its neighbours. */
    private static final int DECIMALS = 3;

    private final SceneArea area;

    ColourTool(SceneArea area) {
        this.area = area;
    }

    /** Paints the bars of the colours that are seen. */
    void paint(Graphics g) {
        Rectangle seen = area.getVisibleRect();
        ValueTable values = area.values();
        int end = area.viewToModel2D(new Point(seen.x + seen.width, seen.y + seen.height));
        int i = Math.max(0, values.before(area.viewToModel2D(seen.getLocation())) - COUNT);
        for (; i < values.size() && values.start(i) <= end; i++) {
            Color colour = values.colourOf(i) == i ? colour(i) : null;
            if (colour != null) {
                paint(g, colour, i);
            }
        }
    }

    /** Paints a bar; numbers on several lines have one each. */
    private void paint(Graphics g, Color colour, int red) {
        try {
            int i = red;
            while (i < red + COUNT) {
                Rectangle bar = area.modelToView2D(area.values().start(i)).getBounds();
                Rectangle end;
                do {
                    end = area.modelToView2D(area.values().end(i++)).getBounds();
                    bar.width = end.x - bar.x;
                } while (i < red + COUNT && area.modelToView2D(area.values().start(i)).getBounds().y == bar.y);
                int high = Math.max(MIN_BAR, area.getFontMetrics(area.getFont()).getDescent() - 1);
                int bottom = bar.y + bar.height;
                g.setColor(colour);
                g.fillRect(bar.x, bottom - high, bar.width, high);
                g.setColor(Color.GRAY);                       // seen on any paper
                g.fillRect(bar.x, bottom - 1, bar.width, 1);
            }
        } catch (BadLocationException e) {
            throw new IllegalStateException(e);               // the values are of this text
        }
    }

    /** {@return the colour of three numbers, as a picture shows it; null if one of them is no number now} */
    Color colour(int red) {
        double[] light = new double[COUNT];
        for (int i = 0; i < COUNT; i++) {
            light[i] = NumberParser.parseDouble(text(red + i));
            if (Double.isNaN(light[i])) {
                return null;
            }
        }
        byte[] levels = Picture.levels(light);
        return new Color(levels[0] & 0xFF, levels[1] & 0xFF, levels[2] & 0xFF);
    }

    private String text(int i) {
        try {
            int start = area.values().start(i);
            return area.getText(start, area.values().end(i) - start);
        } catch (BadLocationException e) {
            throw new IllegalStateException(e);
        }
    }

    /** Lets the user pick the colour that a value is of; the text follows the choice, and one step undoes it. {@return whether it is of one} */
    boolean choose(int value) {
        int red = area.values().colourOf(value);
        Color before = red < 0 ? null : colour(red);
        if (before == null) {
            return false;
        }
        String[] words = {text(red), text(red + 1), text(red + 2)};
        JColorChooser chooser = new JColorChooser(before);
        chooser.setPreviewPanel(new JPanel());    // the picture is the preview
        AbstractColorChooserPanel[] panels = chooser.getChooserPanels();
        Collections.rotate(Arrays.asList(panels), -1);        // the swatches come first else, where most colours are not
        chooser.setChooserPanels(panels);
        for (AbstractColorChooserPanel panel : panels) {
            panel.setColorTransparencySelectionEnabled(false);   // three numbers have none; it rounds the colour
        }
        chooser.setColor(before);
        chooser.getSelectionModel().addChangeListener(e -> put(red, words, before, chooser.getColor()));
        area.beginAtomicEdit();
        try {
            JColorChooser.createDialog(area, "Colour: " + area.values().value(red).toString().replaceFirst(" red$", ""), true, chooser,
                ok -> { }, cancelled -> put(red, words, before, before)).setVisible(true);
        } finally {
            area.endAtomicEdit();
        }
        return true;
    }

    /** Writes a colour; the numbers of which the level is as it was stay as they were. */
    private void put(int red, String[] words, Color before, Color now) {
        int[] old = {before.getRed(), before.getGreen(), before.getBlue()};
        int[] levels = {now.getRed(), now.getGreen(), now.getBlue()};
        for (int i = COUNT - 1; i >= 0; i--) {
            String word = levels[i] == old[i] ? words[i] : text(levels[i] / LEVELS);
            if (!word.equals(text(red + i))) {
                area.replaceRange(word, area.values().start(red + i), area.values().end(red + i));
            }
        }
    }

    private static String text(double share) {
        BigDecimal rounded = BigDecimal.valueOf(share).setScale(DECIMALS, RoundingMode.HALF_EVEN);
        return rounded.signum() == 0 ? "0" : rounded.stripTrailingZeros().toPlainString();
    }
}
