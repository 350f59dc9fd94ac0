package simpleray.ui.editor;

import java.awt.event.KeyEvent;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.math.BigDecimal;
import java.math.MathContext;
import java.math.RoundingMode;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.function.BiFunction;
import javax.swing.JMenu;
import simpleray.math.Colour;
import simpleray.math.Point;
import simpleray.math.Vector;
import simpleray.scene.AreaLight;
import simpleray.scene.Cone;
import simpleray.scene.Cylinder;
import simpleray.scene.DirectionalLight;
import simpleray.scene.FreeView;
import simpleray.scene.Light;
import simpleray.scene.Material;
import simpleray.scene.Object;
import simpleray.scene.PerspectiveCamera.Pose;
import simpleray.scene.Plane;
import simpleray.scene.PointLight;
import simpleray.scene.Scene;
import simpleray.scene.SceneSettings;
import simpleray.scene.Sphere;
import simpleray.scene.Triangle;
import simpleray.text.SceneWriter;
import simpleray.ui.widget.KeyBindings;

/** The Insert menu: adds an object or a light to the text, where the camera looks, and raises their count. */
final class InsertMenu {
    /** The size of a new object, as a share of what the picture shows of the plane that the camera looks at. */
    private static final double SHARE = 0.125;

    private final JMenu menu = new JMenu("Insert");
    private final SceneDocument document;

    InsertMenu(SceneDocument document) {
        this.document = document;
        menu.setMnemonic(KeyEvent.VK_I);
        object("Sphere", (p, r) -> new Sphere(material(), p, r));
        object("Plane", (p, r) -> new Plane(material(), new Vector(0, 1, 0), p.y - r));
        object("Triangle", (p, r) -> new Triangle(material(), at(p, -r, -r), at(p, r, -r), at(p, 0, r)));
        object("Cylinder", (p, r) -> new Cylinder(material(), at(p, 0, -r), at(p, 0, r), r));
        object("Cone", (p, r) -> new Cone(material(), at(p, 0, -r), r, at(p, 0, r), 0));
        menu.addSeparator();
        light("Point Light", (p, r) -> new PointLight(at(p, -2 * r, 4 * r)));
        light("Directional Light", (p, r) -> new DirectionalLight(new Vector(1, -1, -1)));
        light("Area Light", (p, r) -> new AreaLight(at(p, -r, 4 * r), new Vector(2 * r, 0, 0), new Vector(0, 0, 2 * r), 4));
    }

    JMenu menu() {
        return menu;
    }

    private void object(String name, BiFunction<Point, Double, Object> maker) {
        add(name, "object", (p, r) -> {
            Scene one = new Scene();
            one.setNumberObjects(1);
            one.setObject(0, maker.apply(p, r));
            return one;
        });
    }

    private void light(String name, BiFunction<Point, Double, Light> maker) {
        add(name, "light", (p, r) -> {
            Scene one = new Scene();
            one.setNumberLights(1);
            one.setLight(0, maker.apply(p, r));
            one.getLight(0).intensity = new Colour(0.5, 0.5, 0.5);
            return one;
        });
    }

    private void add(String name, String what, BiFunction<Point, Double, Scene> maker) {
        menu.add(KeyBindings.action(name, null, () -> {
            Pose view = FreeView.of(settings());
            double distance = Math.sqrt(square(view.lx() - view.ex()) + square(view.ly() - view.ey()) + square(view.lz() - view.ez()));
            double size = Math.min(distance, 2 * distance * Math.tan(Math.toRadians(view.fov() / 2)));
            double r = rounded(SHARE * size, SHARE * size);
            document.insert(what, line(maker.apply(new Point(rounded(view.lx(), r), rounded(view.ly(), r), rounded(view.lz(), r)), r)));
        }));
    }

    private SceneSettings settings() {
        SceneSettings shown = document.settings();
        return shown == null ? new SceneSettings() : shown;
    }

    private static double square(double d) {
        return d * d;
    }

    /** {@return a number to about a tenth of another, which is above 0} */
    private static double rounded(double d, double of) {
        int digits = (int) Math.floor(Math.log10(of)) - 1;
        BigDecimal unit = BigDecimal.ONE.scaleByPowerOfTen(digits);
        return BigDecimal.valueOf(d).divide(unit, 0, RoundingMode.HALF_EVEN).multiply(unit, MathContext.DECIMAL64).doubleValue();
    }

    private static Point at(Point p, double right, double up) {
        return new Point(p.x + right, p.y + up, p.z);
    }

    private static Material material() {
        Material material = new Material();
        material.ambient = new Colour(0.3, 0.15, 0.1);
        material.diffuse = new Colour(0.8, 0.4, 0.25);
        material.specular = new Colour(0.2, 0.2, 0.2);
        material.shininess = 20;
        return material;
    }

    /** {@return the line of the only object or light of a scene} */
    private static String line(Scene one) {
        try (ByteArrayOutputStream bytes = new ByteArrayOutputStream()) {
            SceneWriter os = new SceneWriter(bytes);
            one.write(os);
            os.flush();
            boolean object = one.getNumberObjects() > 0;
            List<String> lines = bytes.toString(StandardCharsets.UTF_8).lines().toList();
            String line = lines.get(object ? 2 : lines.size() - 1).strip();   // after a comment and the count, or last
            return line.replaceAll("\\.0(?=\\s|$)", "");     // a person would not write 1.0
        } catch (IOException e) {
            throw new UncheckedIOException(e);                // does not happen in memory
        }
    }
}
