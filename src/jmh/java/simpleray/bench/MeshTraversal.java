package simpleray.bench;

import java.io.IOException;
import simpleray.math.Point;
import simpleray.scene.Material;
import simpleray.scene.Mesh;
import simpleray.scene.Object;

/** The knot of the sample scene mesh: 3840 triangles in their tree. */
public class MeshTraversal extends ObjectHit {
    @Override
    Object object() throws IOException {
        return new Mesh(new Material(), sample("knot.obj").toString(), new Point(0, 0, 0), 1);
    }
}
