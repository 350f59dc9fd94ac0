package simpleray.bench;

import simpleray.math.Point;
import simpleray.scene.Material;
import simpleray.scene.Object;
import simpleray.scene.Sphere;

/** The unit sphere. */
public class SphereHit extends ObjectHit {
    @Override
    Object object() {
        return new Sphere(new Material(), new Point(0, 0, 0), 1);
    }
}
