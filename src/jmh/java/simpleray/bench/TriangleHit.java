package simpleray.bench;

import simpleray.math.Point;
import simpleray.scene.Material;
import simpleray.scene.Object;
import simpleray.scene.Triangle;

/** A triangle with its vertices on three axes. */
public class TriangleHit extends ObjectHit {
    @Override
    Object object() {
        return new Triangle(new Material(), new Point(1, 0, 0), new Point(0, 1, 0), new Point(0, 0, 1));
    }
}
