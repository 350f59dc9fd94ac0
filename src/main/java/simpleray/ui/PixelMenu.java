package simpleray.ui;

import java.awt.Point;
import java.awt.Toolkit;
import java.awt.datatransfer.StringSelection;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import javax.swing.JMenuItem;
import javax.swing.JPopupMenu;
import simpleray.image.Picture;
import simpleray.math.Colour;
import simpleray.rays.StoryText;
import simpleray.text.Diagnostic;
import simpleray.ui.editor.SceneDocument;
import simpleray.ui.inspect.Inspector;
import simpleray.ui.picture.CameraMenu;
import simpleray.ui.picture.RenderJob;
import simpleray.ui.picture.SimpleRay;
import simpleray.ui.picture.ViewerContext;

/** The menu on a pixel of the picture, for the right mouse button. */
final class PixelMenu extends MouseAdapter {
    private final ViewerContext window;
    private final SimpleRay picture;
    private final Inspector inspector;
    private final SceneDocument document;
    private final CameraMenu camera;

    private PixelMenu(ViewerContext window, Inspector inspector, SceneDocument document, CameraMenu camera) {
        this.window = window;
        this.inspector = inspector;
        this.document = document;
        this.camera = camera;
        picture = window.picture();
    }

    /** Gives the picture of a window this menu. */
    static void install(ViewerContext window, Inspector inspector, SceneDocument document, CameraMenu camera) {
        window.picture().addMouseListener(new PixelMenu(window, inspector, document, camera));
    }

    @Override
    public void mousePressed(MouseEvent e) {
        show(e);
    }

    @Override
    public void mouseReleased(MouseEvent e) {                 // on Windows it is this that asks for a menu
        show(e);
    }

    private void show(MouseEvent e) {
        Point pixel = e.isPopupTrigger() ? picture.pixelAt(e.getPoint()) : null;
        RenderJob job = picture.job();
        if (pixel == null || picture.isBlank()) {
            return;
        }
        JPopupMenu menu = new JPopupMenu("Pixel");
        add(menu, "Why This Colour", 'W', () -> inspector.explain(pixel));
        add(menu, "Rays", 'R', () -> inspector.showRays(pixel));
        add(menu, "Go to Line", 'G', () -> inspector.find(pixel, thing -> {
            if (thing == null || thing.line() <= 0) {
                window.say(thing == null ? "There is no object at this pixel" : "This object is in no file");
            } else {
                document.goTo(new Diagnostic(picture.source().name(), thing.line(), 1, false, StoryText.object(thing), null));
            }
        }));
        add(menu, "Look Here", 'L', () -> camera.lookAt(pixel));
        Colour colour = colour(job.snapshot().picture(), pixel);
        add(menu, "Copy Colour", 'C', () -> {
            String text = StoryText.colour(colour);
            Toolkit.getDefaultToolkit().getSystemClipboard().setContents(new StringSelection(text), null);
            window.say("Copied: " + text);
        }).setEnabled(colour != null);
        menu.show(picture, e.getX(), e.getY());
    }

    private static JMenuItem add(JPopupMenu menu, String name, char mnemonic, Runnable task) {
        JMenuItem item = menu.add(name);
        item.setMnemonic(mnemonic);
        item.addActionListener(e -> task.run());
        return item;
    }

    /** {@return a pixel's linear colour; null while its row is not finished} */
    private static Colour colour(Picture light, Point pixel) {
        double[] row = light == null || pixel.x >= light.width() || pixel.y >= light.height() ? null : light.row(pixel.y);
        int at = row == null ? 0 : light.channels() * pixel.x;
        return row == null ? null : new Colour(row[at], row[at + 1], row[at + 2]);
    }
}
