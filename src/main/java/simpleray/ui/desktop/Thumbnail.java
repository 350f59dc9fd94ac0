package simpleray.ui.desktop;

import java.awt.Component;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.util.concurrent.Executor;
import javax.swing.Icon;
import javax.swing.SwingUtilities;
import javax.swing.UIManager;
import simpleray.render.PreparedScene;
import simpleray.render.RenderListener;
import simpleray.render.RenderRequest;
import simpleray.render.Stage;
import simpleray.scene.Scene;
import simpleray.scene.SceneSettings;
import simpleray.scene.SceneSettings.Resolution;
import simpleray.scene.Setting;
import simpleray.ui.file.SceneSource;

/** A small picture of a scene; a grey one until it is rendered. For the event thread. */
final class Thumbnail implements Icon {
    /** The room for the picture, in units of the component. */
    static final int WIDTH = 160;
    /** The height of that room. */
    static final int HEIGHT = 120;

    private final SceneSource source;
    private BufferedImage image;                              // null until it is rendered
    private boolean asked;

    Thumbnail(SceneSource source) {
        this.source = source;
    }

    @Override
    public int getIconWidth() {
        return WIDTH;
    }

    @Override
    public int getIconHeight() {
        return HEIGHT;
    }

    /** {@return whether the picture is there} */
    boolean isRendered() {
        return image != null;
    }

    @Override
    public void paintIcon(Component component, Graphics g, int x, int y) {
        Graphics2D canvas = (Graphics2D) g.create();
        double scale = canvas.getTransform().getScaleX();
        if (image == null) {
            canvas.setColor(UIManager.getColor("ProgressBar.background"));
            canvas.fillRect(x, y, WIDTH, HEIGHT);
        } else {
            int width = (int) Math.round(image.getWidth() / scale);
            int height = (int) Math.round(image.getHeight() / scale);
            double fit = Math.min(1, Math.min((double) WIDTH / width, (double) HEIGHT / height));   // if the screen is another by now
            width = (int) (width * fit);
            height = (int) (height * fit);
            canvas.setRenderingHint(RenderingHints.KEY_INTERPOLATION, RenderingHints.VALUE_INTERPOLATION_BILINEAR);
            canvas.drawImage(image, x + (WIDTH - width) / 2, y + (HEIGHT - height) / 2, width, height, null);
        }
        canvas.dispose();
    }

    /** {@return whether it was to be rendered; one that failed stays grey} */
    boolean isAsked() {
        return asked;
    }

    /**
     * Renders it on another thread.
     *
     * @param renderer the thread
     * @param component where it is shown
     * @param then called when it is there, or has failed, or is not wanted any more
     */
    void render(Executor renderer, Component component, Runnable then) {
        asked = true;
        double scale = component.getGraphicsConfiguration().getDefaultTransform().getScaleX();
        renderer.execute(() -> {
            boolean wanted = component.isDisplayable();       // else another scene was chosen since
            BufferedImage made = wanted ? render(scale) : null;
            SwingUtilities.invokeLater(() -> {
                image = made;
                asked = wanted;
                component.repaint();
                then.run();
            });
        });
    }

    private BufferedImage render(double scale) {
        try {
            Scene scene = source.read().still(0).scene();
            Resolution own = Setting.RESOLUTION.in(scene.settings);
            double fit = scale * Math.min((double) WIDTH / own.width(), (double) HEIGHT / own.height());
            SceneSettings settings = new SceneSettings();
            settings.resolution = new Resolution((int) Math.max(1, own.width() * fit), (int) Math.max(1, own.height() * fit));
            return new PreparedScene(scene).renderer(new RenderRequest(settings, Stage.FINAL, true, 1)).render(RenderListener.NONE)
                .toBufferedImage();
        } catch (IOException | RuntimeException | OutOfMemoryError e) {
            return null;                                      // a grey place; when the scene is opened, the window says what is wrong
        }
    }
}
