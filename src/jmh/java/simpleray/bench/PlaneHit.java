package simpleray.bench;

import simpleray.math.Vector;
import simpleray.scene.Material;
import simpleray.scene.Object;
import simpleray.scene.Plane;

/** A plane through the origin, at which no axis lies. */
public class PlaneHit extends ObjectHit {
    @Override
    Object object() {
        return new Plane(new Material(), new Vector(0.6, 0.64, 0.48), 0);
    }
}
