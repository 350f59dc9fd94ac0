package simpleray.scene;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import simpleray.math.Colour;
import simpleray.math.Vector;

/** All that a scene is made of, in one list: two scenes are equal bit for bit if their lists are, for boxed doubles compare bits. */
public final class SceneBits {
    private final List<java.lang.Object> bits = new ArrayList<>();

    private SceneBits() {
    }

    /** {@return all that is in a scene, settings too} */
    public static List<java.lang.Object> of(Scene scene) {
        SceneBits all = new SceneBits();
        all.bits.add(scene.getNumberObjects());
        for (int i = 0; i < scene.getNumberObjects(); i++) {
            all.add(scene.getObject(i));
        }
        all.add(scene.ambient);
        all.bits.add(scene.getNumberLights());
        for (int i = 0; i < scene.getNumberLights(); i++) {
            all.add(scene.getLight(i));
        }
        all.add(scene.settings);
        return all.bits;
    }

    static List<java.lang.Object> of(SceneSettings settings) {
        SceneBits all = new SceneBits();
        all.add(settings);
        return all.bits;
    }

    static List<java.lang.Object> of(Object object) {
        SceneBits all = new SceneBits();
        all.add(object);
        return all.bits;
    }

    static List<java.lang.Object> of(Light light) {
        SceneBits all = new SceneBits();
        all.add(light);
        return all.bits;
    }

    static List<java.lang.Object> of(Material material) {
        SceneBits all = new SceneBits();
        all.add(material);
        return all.bits;
    }

    private void add(Object object) {
        bits.add(object.getClass());
        if (object instanceof Sphere sphere) {
            add(new Vector(sphere.centre));
            bits.add(sphere.radius);
        } else if (object instanceof Plane plane) {
            add(plane.normal);
            bits.add(plane.constant);
        } else if (object instanceof Triangle triangle) {
            add(new Vector(triangle.a));
            add(new Vector(triangle.b));
            add(new Vector(triangle.c));
        } else if (object instanceof Mesh mesh) {
            bits.add(mesh.file);
            add(new Vector(mesh.offset));
            bits.add(mesh.scale);
            bits.add(mesh.size());
            mesh.pieces().forEach(piece -> add(piece.surfaceMaterial));
        } else if (object instanceof Cylinder cylinder) {
            add(new Vector(cylinder.start));
            add(new Vector(cylinder.end));
            bits.add(cylinder.radius);
        } else if (object instanceof Cone cone) {
            add(new Vector(cone.start));
            bits.add(cone.startRadius);
            add(new Vector(cone.end));
            bits.add(cone.endRadius);
        } else {
            throw new IllegalArgumentException("no bits known of " + object.getClass());
        }
        add(object.surfaceMaterial);
    }

    private void add(Light light) {
        bits.add(light.getClass());
        add(light.intensity);
        if (light instanceof PointLight point) {
            add(new Vector(point.origin));
        } else if (light instanceof DirectionalLight directional) {
            add(directional.direction);
        } else if (light instanceof AreaLight area) {
            add(new Vector(area.corner));
            add(area.u);
            add(area.v);
            bits.add(area.side);
        } else {
            throw new IllegalArgumentException("no bits known of " + light.getClass());
        }
    }

    private void add(Material material) {
        add(material.ambient);
        add(material.diffuse);
        add(material.specular);
        bits.add(material.shininess);
        if (material.mirror != null) {
            add(material.mirror);
        }
        add(material.transmission);
        bits.add(material.index);
    }

    /** Records of doubles compare bits, as boxed doubles do. */
    private void add(SceneSettings settings) {
        if (settings.background == null) {
            bits.add(null);
        } else {
            add(settings.background);
        }
        bits.addAll(Arrays.asList(settings.window, settings.cop, settings.camera, settings.parallel, settings.resolution, settings.depth,
            settings.samples));
        if (settings.up != null) {
            add(settings.up);
        }
    }

    private void add(Colour c) {
        bits.addAll(List.of(c.r, c.g, c.b));
    }

    private void add(Vector v) {
        bits.addAll(List.of(v.x, v.y, v.z));
    }
}
