package simpleray.ui;

import java.awt.AWTEvent;
import java.awt.AWTException;
import java.awt.Component;
import java.awt.Dialog;
import java.awt.MouseInfo;
import java.awt.Point;
import java.awt.Rectangle;
import java.awt.Robot;
import java.awt.Toolkit;
import java.awt.event.AWTEventListener;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.awt.event.MouseEvent;
import java.awt.image.BufferedImage;
import java.io.File;
import java.io.IOException;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.BooleanSupplier;
import java.util.function.Supplier;
import javax.imageio.ImageIO;
import javax.swing.JComponent;
import javax.swing.JMenuItem;
import javax.swing.SwingUtilities;
import javax.swing.Timer;

/**
 * The screen as a user has it: keys, the mouse, and what can be seen. It waits for what is to happen; for a
 * time to pass only where nothing is to.
 */
public final class Screen {
    /** What is around a picture, and where a picture has no rows yet. */
    public static final int SURROUND = 0x3C3F41;
    /** How long anything may take. */
    public static final int SECONDS = 30;
    private static final int LOOK = 5;                        // milliseconds between two looks
    private static final int NUDGE = 200;                     // looks after which a dialog that is not under the mouse is moved

    private final Robot robot;

    public Screen() {
        try {
            robot = new Robot();
        } catch (AWTException e) {
            throw new IllegalStateException("no display, or one that lets nobody press keys", e);
        }
    }

    /** Waits until something is true, which is asked on the event thread. */
    public static void until(String what, BooleanSupplier condition) {
        CountDownLatch known = new CountDownLatch(1);
        AtomicReference<Throwable> fault = new AtomicReference<>();
        Timer look = new Timer(LOOK, e -> {
            try {
                if (condition.getAsBoolean()) {
                    known.countDown();
                }
            } catch (RuntimeException | Error t) {
                fault.set(t);
                known.countDown();
            }
        });
        look.start();
        try {
            arrive(known, what);
        } finally {
            look.stop();
        }
        if (fault.get() != null) {
            throw new AssertionError("cannot tell whether " + what, fault.get());
        }
    }

    /** Lets a time pass on the event thread, in milliseconds, where something must not happen. */
    public static void pause(int milliseconds) {
        CountDownLatch over = new CountDownLatch(1);
        OpenWindow.run(() -> {
            Timer later = new Timer(milliseconds, e -> over.countDown());
            later.setRepeats(false);
            later.start();
        });
        until("a pause is over", () -> over.getCount() == 0);
    }

    /** Presses keys together, the last one briefly, and waits until the program has done what it does upon that. */
    public void press(int... keys) {
        int last = keys[keys.length - 1];
        CountDownLatch arrived = new CountDownLatch(1);
        AWTEventListener listener = e -> {
            if (e.getID() == KeyEvent.KEY_PRESSED && ((KeyEvent) e).getKeyCode() == last) {
                arrived.countDown();
            }
        };
        Toolkit.getDefaultToolkit().addAWTEventListener(listener, AWTEvent.KEY_EVENT_MASK);
        send(keys);
        arrive(arrived, "the key " + KeyEvent.getKeyText(last) + " reaches a window");
        Toolkit.getDefaultToolkit().removeAWTEventListener(listener);
        OpenWindow.run(() -> { });
    }

    /** Presses and releases keys, whoever gets them. */
    public void send(int... keys) {
        for (int key : keys) {
            robot.keyPress(key);
        }
        for (int i = keys.length - 1; i >= 0; i--) {
            robot.keyRelease(keys[i]);
        }
    }

    /** Lets go of what a test that failed still presses. */
    void release() {
        robot.mouseRelease(InputEvent.BUTTON1_DOWN_MASK | InputEvent.BUTTON2_DOWN_MASK | InputEvent.BUTTON3_DOWN_MASK);
        for (int key : new int[] {KeyEvent.VK_SHIFT, KeyEvent.VK_CONTROL, KeyEvent.VK_ALT}) {
            robot.keyRelease(key);
        }
    }

    /** Types text as on a keyboard of the USA. */
    public void type(String text) {
        for (char c : text.toCharArray()) {
            boolean shift = Character.isUpperCase(c) || c == '_';
            int key = c == '_' ? KeyEvent.VK_MINUS : KeyEvent.getExtendedKeyCodeForChar(c);
            if (shift) {
                robot.keyPress(KeyEvent.VK_SHIFT);
            }
            robot.keyPress(key);
            robot.keyRelease(key);
            if (shift) {
                robot.keyRelease(KeyEvent.VK_SHIFT);
            }
        }
    }

    /** Clicks into the middle of what can be seen of a component; again if it was elsewhere by then, as one is that was just added. */
    public void click(JComponent component) {
        click(component, () -> {
            Rectangle seen = component.getVisibleRect();
            return new Point((int) seen.getCenterX(), (int) seen.getCenterY());
        });
    }

    /** Clicks at a place of a component, which is asked for on the event thread; again if that was elsewhere by then. */
    public void click(JComponent component, Supplier<Point> at) {
        AtomicReference<Component> hit = new AtomicReference<>();
        AWTEventListener listener = e -> {
            if (e.getID() == MouseEvent.MOUSE_RELEASED) {
                hit.set((Component) e.getSource());
            }
        };
        Toolkit.getDefaultToolkit().addAWTEventListener(listener, AWTEvent.MOUSE_EVENT_MASK);
        long end = System.nanoTime() + TimeUnit.SECONDS.toNanos(SECONDS);
        do {
            until("a component can be seen", () -> component.isShowing() && !component.getVisibleRect().isEmpty());
            int[] looks = {0};
            until("the mouse is over the component", () -> {   // and no other window is between them, as before a dialog is there
                Point part = at.get();
                SwingUtilities.convertPointToScreen(part, component);
                boolean there = MouseInfo.getPointerInfo().getLocation().equals(part)
                    && (component.getMousePosition(true) != null || component instanceof JMenuItem item && item.isArmed());
                if (!there) {
                    robot.mouseMove(part.x, part.y);
                    if (++looks[0] % NUDGE == 0 && SwingUtilities.getWindowAncestor(component) instanceof Dialog dialog) {
                        dialog.setLocation(dialog.getX() + 1, dialog.getY());   // the toolkit had its place wrong, and learns it by this
                    }
                }
                return there;
            });
            hit.set(null);
            robot.mousePress(InputEvent.BUTTON1_DOWN_MASK);
            robot.mouseRelease(InputEvent.BUTTON1_DOWN_MASK);
            until("a click reaches a window", () -> hit.get() != null);
        } while (!SwingUtilities.isDescendingFrom(hit.get(), component) && System.nanoTime() < end);
        Toolkit.getDefaultToolkit().removeAWTEventListener(listener);
        OpenWindow.run(() -> { });
    }

    public BufferedImage capture(Rectangle place) {
        return robot.createScreenCapture(place);
    }

    public BufferedImage capture() {
        return capture(new Rectangle(Toolkit.getDefaultToolkit().getScreenSize()));
    }

    /** {@return what can be seen of a rectangle of a component} */
    public BufferedImage capture(Component component, Rectangle part) {
        Point corner = component.getLocationOnScreen();
        return capture(new Rectangle(corner.x + part.x, corner.y + part.y, part.width, part.height));
    }

    /** {@return whether rows of a picture, at 100 %, are in a capture; the picture's corner is at x, y} */
    public static boolean shows(BufferedImage capture, int x, int y, BufferedImage picture, int from, int to) {
        for (int row = from; row < to; row++) {
            for (int column = 0; column < picture.getWidth(); column++) {
                if (capture.getRGB(x + column, y + row) != picture.getRGB(column, row)) {
                    return false;
                }
            }
        }
        return true;
    }

    private static void arrive(CountDownLatch latch, String what) {
        try {
            if (!latch.await(SECONDS, TimeUnit.SECONDS)) {
                File file = new File(System.getProperty("simpleray.build"), "captures/late-" + what.replaceAll("\\W+", "-") + ".png");
                file.getParentFile().mkdirs();
                ImageIO.write(new Screen().capture(), "png", file);
                throw new AssertionError("not within " + SECONDS + " s: " + what + "; see " + file);
            }
        } catch (InterruptedException | IOException e) {
            throw new AssertionError("not known whether " + what, e);
        }
    }
}
