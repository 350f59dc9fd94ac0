package simpleray.scene;

/** The kinds of object that a scene file knows: a new one is a class and a line here. */
final class ObjectKind {
    static final KindTable<Object> TABLE = new KindTable<Object>("object")
        .add(0, "sphere", Sphere.class, Sphere::new)
        .add(1, "plane", Plane.class, Plane::new)
        .add(2, "triangle", Triangle.class, Triangle::new)
        .add(3, "cylinder", Cylinder.class, Cylinder::new)
        .add(4, "mesh", Mesh.class, Mesh::new);

    private ObjectKind() {
    }
}
