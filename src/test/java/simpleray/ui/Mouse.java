package simpleray.ui;

import java.awt.AWTEvent;
import java.awt.AWTException;
import java.awt.Component;
import java.awt.Point;
import java.awt.Robot;
import java.awt.Toolkit;
import java.awt.event.AWTEventListener;
import java.awt.event.KeyEvent;
import java.awt.event.MouseEvent;
import java.util.function.Predicate;

/** The mouse over a component, and keys that are held meanwhile. It waits until the program has what it did. */
public final class Mouse {
    /** The toolkit tells of no drag that is shorter. */
    private static final int SMUDGE = 4;

    private final Component component;
    private final Robot robot;

    public Mouse(Component component) {
        this.component = component;
        try {
            robot = new Robot();
        } catch (AWTException e) {
            throw new IllegalStateException("no display, or one that lets nobody move the mouse", e);
        }
    }

    /** Moves to a point of the component, until it is there. */
    public void move(Point to) {
        Point corner = OpenWindow.ask(component::getLocationOnScreen);
        robot.mouseMove(corner.x + to.x, corner.y + to.y);
        Screen.until("the mouse is there", () -> to.equals(component.getMousePosition()));
    }

    /** Drags from one point to another with a button, in one movement. */
    public void drag(int button, Point from, Point to) {
        move(from);
        heard(MouseEvent.MOUSE_PRESSED, e -> true, () -> robot.mousePress(button));
        try {
            Point corner = OpenWindow.ask(component::getLocationOnScreen);
            Point there = new Point(corner.x + to.x, corner.y + to.y);
            if (to.distance(from) < SMUDGE) {
                robot.mouseMove(there.x, there.y);
            } else {
                heard(MouseEvent.MOUSE_DRAGGED, e -> ((MouseEvent) e).getLocationOnScreen().equals(there),
                    () -> robot.mouseMove(there.x, there.y));
            }
        } finally {
            heard(MouseEvent.MOUSE_RELEASED, e -> true, () -> robot.mouseRelease(button));
        }
    }

    /** Turns the wheel by a notch; up is negative. */
    public void wheel(int notch) {
        heard(MouseEvent.MOUSE_WHEEL, e -> true, () -> robot.mouseWheel(notch));
    }

    /** Does something while a key is held. */
    public void holding(int key, Runnable task) {
        heard(KeyEvent.KEY_PRESSED, e -> ((KeyEvent) e).getKeyCode() == key, () -> robot.keyPress(key));
        try {
            task.run();
        } finally {
            heard(KeyEvent.KEY_RELEASED, e -> ((KeyEvent) e).getKeyCode() == key, () -> robot.keyRelease(key));
        }
    }

    private static void heard(int id, Predicate<AWTEvent> wanted, Runnable task) {
        boolean[] heard = new boolean[1];
        AWTEventListener listener = e -> heard[0] |= e.getID() == id && wanted.test(e);
        Toolkit.getDefaultToolkit().addAWTEventListener(listener,
            AWTEvent.MOUSE_EVENT_MASK | AWTEvent.MOUSE_MOTION_EVENT_MASK | AWTEvent.MOUSE_WHEEL_EVENT_MASK | AWTEvent.KEY_EVENT_MASK);
        task.run();
        Screen.until("the window hears of it", () -> heard[0]);
        Toolkit.getDefaultToolkit().removeAWTEventListener(listener);
        OpenWindow.run(() -> { });
    }
}
