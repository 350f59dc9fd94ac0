package simpleray;

import simpleray.image.Picture;
import simpleray.math.Point;
import simpleray.math.Ray;
import simpleray.render.RenderListener;
import simpleray.render.RenderSettings;
import simpleray.render.Renderer;
import simpleray.render.Stage;
import simpleray.scene.Camera;
import simpleray.scene.Scene;

/**
 * A picture, and which of its pixels lie away from edges: an edge of an object, of a shadow or of an image in a mirror or in glass passes
 * so near by the others that a thousandth of a pixel to the side they show something else. There a rounding may decide.
 */
final class StablePixels {
    private static final double ASIDE = 1e-3;
    private static final int DEPTH = 6;
    private static final int THREADS = 2;

    /** The picture itself. */
    final Picture picture;
    private final Picture[] aside = new Picture[4];

    StablePixels(Scene scene, Camera camera) {
        picture = render(scene, camera);
        aside[0] = render(scene, new Aside(camera, ASIDE, 0));
        aside[1] = render(scene, new Aside(camera, -ASIDE, 0));
        aside[2] = render(scene, new Aside(camera, 0, ASIDE));
        aside[3] = render(scene, new Aside(camera, 0, -ASIDE));
    }

    static Picture render(Scene scene, Camera camera) {
        return new Renderer(scene, camera, new RenderSettings(Stage.FINAL, DEPTH, 1, THREADS)).render(RenderListener.NONE);
    }

    /** {@return whether a pixel lies away from edges} */
    boolean isStable(int x, int y) {
        for (Picture other : aside) {
            if (difference(picture, x, other, x, y) > 1) {
                return false;
            }
        }
        return true;
    }

    /** {@return by how many levels two pixels of a row differ at most} */
    static int difference(Picture a, int xa, Picture b, int xb, int y) {
        int most = 0;
        for (int c = 0; c < 3; c++) {
            most = Math.max(most, Math.abs(Picture.level(a.row(y)[3 * xa + c]) - Picture.level(b.row(y)[3 * xb + c])));
        }
        return most;
    }

    /** Looks through points a little beside those of another camera. */
    private record Aside(Camera of, double dx, double dy) implements Camera {
        @Override
        public int width() {
            return of.width();
        }

        @Override
        public int height() {
            return of.height();
        }

        @Override
        public Point eye() {
            return of.eye();
        }

        @Override
        public void through(double px, double py, Ray ray) {
            of.through(px + dx, py + dy, ray);
        }
    }
}
