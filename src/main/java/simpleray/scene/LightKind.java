package simpleray.scene;

/** The kinds of light that a scene file knows: a new one is a class and a line here. */
final class LightKind {
    static final KindTable<Light> TABLE = new KindTable<Light>("light")
        .add(0, "point light", PointLight.class, PointLight::new)
        .add(1, "directional light", DirectionalLight.class, DirectionalLight::new);

    private LightKind() {
    }
}
