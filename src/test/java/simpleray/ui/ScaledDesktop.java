package simpleray.ui;

import java.awt.AWTException;
import java.awt.Image;
import java.awt.Point;
import java.awt.Rectangle;
import java.awt.Robot;
import java.awt.image.BufferedImage;
import java.awt.image.MultiResolutionImage;
import java.util.List;
import simpleray.render.RenderRequest;
import simpleray.ui.file.SceneSource;
import simpleray.ui.picture.RenderJob;
import simpleray.ui.picture.Zoom;

/** A program that opens the window on a desktop of the scale in {@code sun.java2d.uiScale}, which no running program can change. */
final class ScaledDesktop {
    private static final int WIDTH = 301;
    private static final int HEIGHT = 151;

    private ScaledDesktop() {
    }

    /** Prints what is wrong, and nothing if all is well. */
    public static void main(String... args) throws Exception {
        BufferedImage whole = TestScenes.rendered(TestScenes.THESIS, WIDTH, HEIGHT);
        try (OpenWindow window = new OpenWindow(SceneSource.file(TestScenes.THESIS), WIDTH, HEIGHT)) {
            window.untilState(RenderJob.State.FINISHED);
            Screen.until("each pixel of the picture is one of the screen", () -> shows(window, whole, 1));
            if (window.picture().ui() != Math.floor(Double.parseDouble(System.getProperty("sun.java2d.uiScale")))) {
                System.out.println("the desktop's scale is " + window.picture().ui());   // X11 has whole ones only
            }
            OpenWindow.run(() -> window.picture().setZoom(new Zoom(false, 2), null));
            Screen.until("each pixel of the picture is a square of four", () -> shows(window, whole, 2));
            OpenWindow.run(() -> {
                window.picture().setZoom(new Zoom(true, 1), null);
                window.picture().setRequest(new RenderRequest());
                window.picture().start();
            });
            Screen.until("without a size it is as large as its room, in pixels of the screen", () -> {
                Zoom.Place place = window.picture().placed();
                double shorter = Math.min(window.scroll().getHeight(), window.scroll().getWidth()) * window.picture().ui();
                return window.picture().job().state() == RenderJob.State.FINISHED && place.scale() == 1 && place.height() > 0.8 * shorter;
            });
        }
    }

    private static boolean shows(OpenWindow window, BufferedImage whole, int scale) {
        Zoom.Place place = window.picture().placed();
        if (place.width() != scale * WIDTH || place.height() != scale * HEIGHT) {
            return false;
        }
        Point corner = window.picture().getLocationOnScreen();
        BufferedImage capture = screen(new Rectangle(corner, window.picture().getSize()));
        // a component's corner may lie between two pixels of the screen: where it is rounded to, the first pixel tells
        for (int dy = -1; dy <= 1; dy++) {
            for (int dx = -1; dx <= 1; dx++) {
                if (shows(capture, place.x() + dx, place.y() + dy, whole, scale)) {
                    return true;
                }
            }
        }
        return false;
    }

    private static boolean shows(BufferedImage capture, int left, int top, BufferedImage whole, int scale) {
        for (int y = 2; y < scale * HEIGHT - 2; y++) {
            for (int x = 2; x < scale * WIDTH - 2; x++) {
                if (capture.getRGB(left + x, top + y) != whole.getRGB(x / scale, y / scale)) {
                    return false;
                }
            }
        }
        return true;
    }

    /** {@return a capture in the screen's own pixels} */
    private static BufferedImage screen(Rectangle place) {
        try {
            MultiResolutionImage capture = new Robot().createMultiResolutionScreenCapture(place);
            List<Image> variants = capture.getResolutionVariants();
            return (BufferedImage) variants.get(variants.size() - 1);
        } catch (AWTException e) {
            throw new IllegalStateException(e);
        }
    }
}
