package simpleray.scene;

/**
 * The kinds of object that a scene file knows: a new one is a class and a line here. Those of which there may be millions are made
 * without what reading gives them anyway.
 */
final class ObjectKind {
    static final KindTable<Object> TABLE = new KindTable<Object>("object")
        .add(0, "sphere", Sphere.class, () -> new Sphere(null, null, 1))
        .add(1, "plane", Plane.class, Plane::new)
        .add(2, "triangle", Triangle.class, () -> new Triangle(null, null, null, null))
        .add(3, "cylinder", Cylinder.class, () -> new Cylinder(null, null, null, 1))
        .add(4, "mesh", Mesh.class, Mesh::new);

    private ObjectKind() {
    }
}
