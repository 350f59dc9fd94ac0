package simpleray.render;

import java.util.BitSet;
import java.util.function.Consumer;
import simpleray.math.Bounds;
import simpleray.math.Point;
import simpleray.math.Ray;
import simpleray.math.Vector;
import simpleray.scene.Material;
import simpleray.scene.Object;
import simpleray.scene.Surface;
import simpleray.text.SceneReader;
import simpleray.text.SceneWriter;

/**
 * Notes which objects rays hit, at first or after reflections, while they are followed through a scene. <em>Mutable</em>, for one
 * thread.
 */
final class Witness {
    /** No object. */
    static final int NONE = -1;

    final BitSet seen = new BitSet();
    /** The object that was hit first since this was set to {@link #NONE}. */
    int first = NONE;

    private final Consumer<Ray> hits;

    /**
     * Begins without a ray.
     *
     * @param hits told of each ray that hits something; the ray is not its own
     */
    Witness(Consumer<Ray> hits) {
        this.hits = hits;
    }

    private void saw(int number, Ray ray) {
        seen.set(number);
        if (first == NONE) {
            first = number;
        }
        hits.accept(ray);
    }

    /** {@return an object that is another in all but its material, and tells when it is hit} */
    Object watching(int number, Object watched, Material material) {
        return new Object(material) {
            @Override
            public double intersect(Ray ray) {
                return watched.intersect(ray);
            }

            @Override
            public Vector normal(Point pt) {
                return watched.normal(pt);
            }

            @Override
            public Bounds bounds() {
                return watched.bounds();
            }

            @Override
            public Surface surface(Ray ray, double t, Point point) {
                saw(number, ray);
                return watched.surface(ray, t, point);
            }

            @Override
            public void print(SceneWriter os) {
                throw new UnsupportedOperationException();
            }

            @Override
            public void read(SceneReader is) {
                throw new UnsupportedOperationException();
            }

            @Override
            public void write(SceneWriter os) {
                throw new UnsupportedOperationException();
            }
        };
    }
}
