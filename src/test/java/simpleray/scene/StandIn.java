package simpleray.scene;

import java.io.IOException;
import simpleray.math.Bounds;
import simpleray.math.Point;
import simpleray.math.Ray;
import simpleray.math.Vector;
import simpleray.text.SceneReader;
import simpleray.text.SceneWriter;

/** An object that no ray hits, no box holds and no file knows, for tests to make one of their own of. */
public class StandIn extends Object {
    /** Creates one of a black material. */
    public StandIn() {
        this(new Material());
    }

    /** Creates one of a material, referenced. */
    protected StandIn(Material material) {
        super(material);
    }

    @Override
    public double intersect(Ray ray) {
        return MISS;
    }

    @Override
    public Vector normal(Point pt) {
        return new Vector(0, 0, 1);
    }

    @Override
    public Bounds bounds() {
        return null;
    }

    @Override
    public Object moved(Vector t) {
        throw new UnsupportedOperationException();
    }

    @Override
    public void print(SceneWriter os) throws IOException {
        throw new UnsupportedOperationException();
    }

    @Override
    public void read(SceneReader is) throws IOException {
        throw new UnsupportedOperationException();
    }

    @Override
    public void write(SceneWriter os) throws IOException {
        throw new UnsupportedOperationException();
    }
}
