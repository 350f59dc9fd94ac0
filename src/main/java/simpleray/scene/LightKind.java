package simpleray.scene;

import java.util.function.Supplier;

/** The kinds of light that a scene file knows: a new one is a class and a line here. */
enum LightKind implements Kind<Light> {
    POINT_LIGHT(0, PointLight.class, PointLight::new),
    DIRECTIONAL_LIGHT(1, DirectionalLight.class, DirectionalLight::new);

    private final int code;
    private final Class<? extends Light> type;
    private final Supplier<Light> maker;

    LightKind(int code, Class<? extends Light> type, Supplier<Light> maker) {
        this.code = code;
        this.type = type;
        this.maker = maker;
    }

    @Override
    public int code() {
        return code;
    }

    @Override
    public Class<? extends Light> type() {
        return type;
    }

    @Override
    public Light create() {
        return maker.get();
    }
}
