package simpleray.bench;

import simpleray.math.Point;
import simpleray.scene.Cylinder;
import simpleray.scene.Material;
import simpleray.scene.Object;

/** A slanting cylinder. */
public class CylinderHit extends ObjectHit {
    @Override
    Object object() {
        return new Cylinder(new Material(), new Point(-0.5, -0.6, -0.4), new Point(0.5, 0.6, 0.4), 0.4);
    }
}
