package simpleray.scene;

import java.util.function.Supplier;

/** The kinds of object that a scene file knows: a new one is a class and a line here. */
enum ObjectKind implements Kind<Object> {
    SPHERE(0, Sphere.class, Sphere::new),
    PLANE(1, Plane.class, Plane::new);

    private final int code;
    private final Class<? extends Object> type;
    private final Supplier<Object> maker;

    ObjectKind(int code, Class<? extends Object> type, Supplier<Object> maker) {
        this.code = code;
        this.type = type;
        this.maker = maker;
    }

    @Override
    public int code() {
        return code;
    }

    @Override
    public Class<? extends Object> type() {
        return type;
    }

    @Override
    public Object create() {
        return maker.get();
    }
}
