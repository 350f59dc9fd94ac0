package simpleray.scene;

import simpleray.scene.KindTable.Kind;

/** The kinds of light that a scene file knows: a new one needs a class, a line here and a form for POV-Ray in {@code PovWriter}. */
final class LightKind {
    static final KindTable<Light> TABLE = new KindTable<Light>("light")
        .add(new Kind<>(0, "point light", PointLight.class) { @Override Light make() { return new PointLight(); } })
        .add(new Kind<>(1, "directional light", DirectionalLight.class) { @Override Light make() { return new DirectionalLight(); } })
        .add(new Kind<>(2, "area light", AreaLight.class) { @Override Light make() { return new AreaLight(); } });

    private LightKind() {
    }
}
