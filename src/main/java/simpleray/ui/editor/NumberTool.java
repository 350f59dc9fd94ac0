package simpleray.ui.editor;

import java.awt.event.InputEvent;
import java.awt.event.MouseEvent;
import java.awt.event.MouseWheelEvent;
import java.math.BigDecimal;
import java.math.RoundingMode;
import java.util.function.IntConsumer;
import javax.swing.SwingUtilities;
import javax.swing.Timer;
import simpleray.text.SourceValue;

/**
 * Changes a number of the text by the mouse while Alt is down: a drag to the right or up makes it larger, and so does the wheel. Each drag,
 * and each turn of the wheel, is undone in one step. For the event thread.
 */
final class NumberTool {
    /** Milliseconds after which a turn of the wheel has ended. */
    private static final int PAUSE = 400;
    /** Pixels of a drag for a step of an integer. */
    private static final int COARSE = 8;
    private static final int FEW = 10;
    /** The exponents of numbers that are written without one. */
    private static final int MAX_EXPONENT = 12;

    private final SceneArea area;
    private final Timer turning = new Timer(PAUSE, e -> end());
    private IntConsumer clicked = i -> { };
    private int from = -1;                                    // of the number that changes; -1 for none
    private int length;
    private int index;
    private boolean integer;
    private String original;
    private BigDecimal first;
    private BigDecimal step;                                  // for a pixel
    private MouseEvent press;                                 // null while it is the wheel
    private BigDecimal steps;
    private boolean edited;

    NumberTool(SceneArea area) {
        this.area = area;
        turning.setRepeats(false);
    }

    /** Sets what a click on a number does, while Alt is down; it gets the index of the value. */
    void setClicked(IntConsumer other) {
        clicked = other;
    }

    /** {@return whether a number is being changed} */
    boolean isChanging() {
        return from >= 0;
    }

    /** {@return whether the mouse changes a number by this, and nothing else is to be done with it} */
    boolean takes(MouseEvent e) {
        if (e instanceof MouseWheelEvent wheel) {
            return turns(wheel);
        }
        if (e.getID() == MouseEvent.MOUSE_PRESSED && e.isAltDown() && SwingUtilities.isLeftMouseButton(e) && begin(e)) {
            press = e;
            area.requestFocusInWindow();
            area.setCaretPosition(from);
        } else if (press == null) {
            return false;
        } else if (e.getID() == MouseEvent.MOUSE_DRAGGED) {
            int pixels = e.getX() - press.getX() - (e.getY() - press.getY());
            steps = BigDecimal.valueOf(integer ? pixels / COARSE : pixels);
            put(e);
        } else if (e.getID() == MouseEvent.MOUSE_RELEASED) {
            int at = edited ? -1 : index;
            end();
            if (at >= 0) {
                clicked.accept(at);
            }
        }
        return true;
    }

    private boolean turns(MouseWheelEvent e) {
        int at = area.viewToModel2D(e.getPoint());
        if ((e.getModifiersEx() & InputEvent.ALT_DOWN_MASK) == 0 || press != null) {
            return false;
        }
        if (from < 0 || at < from || at > from + length) {
            end();
            if (!begin(e)) {
                return false;
            }
        }
        turning.restart();
        steps = steps.subtract(BigDecimal.valueOf(integer ? e.getWheelRotation() : FEW * (long) e.getWheelRotation()));
        put(e);
        return true;
    }

    /** {@return whether a number is under the mouse} */
    private boolean begin(MouseEvent e) {
        end();
        int at = area.viewToModel2D(e.getPoint());
        int i = area.values().at(at);
        if (i < 0 || area.values().value(i).type() == SourceValue.Type.WORD) {
            return false;
        }
        try {
            original = area.getText().substring(area.values().start(i), area.values().end(i));
            first = new BigDecimal(original);
        } catch (NumberFormatException notOne) {
            return false;
        }
        index = i;
        from = area.values().start(i);
        length = area.values().end(i) - from;
        integer = area.values().value(i).type() == SourceValue.Type.INTEGER;
        step = step(first, integer);
        steps = BigDecimal.ZERO;
        return true;
    }

    /** {@return the step for a pixel: a hundredth of what its first digit counts} */
    static BigDecimal step(BigDecimal number, boolean integer) {
        if (integer) {
            return BigDecimal.ONE;
        }
        int exponent = number.signum() == 0 ? 0 : number.precision() - number.scale() - 1;
        return BigDecimal.ONE.scaleByPowerOfTen(exponent - 2);
    }

    private void put(MouseEvent e) {
        BigDecimal by = step.multiply(steps);
        String text = by.signum() == 0 ? original : text(first, e.isShiftDown() && !integer ? by.movePointLeft(1) : by);
        if (text.length() != length || !area.getText().startsWith(text, from)) {
            if (!edited) {
                edited = true;
                area.beginAtomicEdit();
            }
            int end = from + length;
            length = text.length();                           // first: the text is read at once
            area.replaceRange(text, from, end);
        }
    }

    /** {@return a sum with at least the digits of the first number, and more only where they are needed} */
    static String text(BigDecimal number, BigDecimal by) {
        BigDecimal sum = number.add(by).stripTrailingZeros();
        if (sum.signum() != 0 && Math.abs(sum.precision() - sum.scale() - 1) > MAX_EXPONENT) {
            return sum.toString();
        }
        int least = Math.max(0, Math.min(number.scale(), MAX_EXPONENT));
        return sum.setScale(Math.max(sum.scale(), least), RoundingMode.UNNECESSARY).toPlainString();
    }

    /** Ends the change of a number, so that it can be undone. */
    void end() {
        turning.stop();
        if (edited) {
            area.endAtomicEdit();
        }
        edited = false;
        from = -1;
        press = null;
    }
}
