package simpleray.scene;

import simpleray.scene.KindTable.Kind;

/**
 * The kinds of object that a scene file knows: a new one needs a class and a line here. Kinds of which there may be millions are made
 * without the values that reading sets anyway. No method references: the first ones take 5 ms of each start.
 */
final class ObjectKind {
    static final KindTable<Object> TABLE = new KindTable<Object>("object")
        .add(new Kind<>(0, "sphere", Sphere.class) { @Override Object make() { return new Sphere(null, null, 1); } })
        .add(new Kind<>(1, "plane", Plane.class) { @Override Object make() { return new Plane(); } })
        .add(new Kind<>(2, "triangle", Triangle.class) { @Override Object make() { return new Triangle(null, null, null, null); } })
        .add(new Kind<>(3, "cylinder", Cylinder.class) { @Override Object make() { return new Cylinder(null, null, null, 1); } })
        .add(new Kind<>(4, "mesh", Mesh.class) { @Override Object make() { return new Mesh(); } })
        .add(new Kind<>(5, "cone", Cone.class) { @Override Object make() { return new Cone(null, null, 0, null, 0); } });

    private ObjectKind() {
    }
}
