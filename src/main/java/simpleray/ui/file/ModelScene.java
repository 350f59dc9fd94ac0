package simpleray.ui.file;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import simpleray.math.Bounds;
import simpleray.math.Point;
import simpleray.scene.Material;
import simpleray.scene.Mesh;
import simpleray.scene.MtlNames;

/**
 * The scene in which a model, an OBJ file, is shown: scaled to a height, width or depth of 2, on a floor, with two lights and a camera that
 * sees all of it. The model's y axis is up. Its text is that of a scene beside the model, which is not written unless the user saves it.
 */
final class ModelScene {
    private static final double SIZE = 2;
    /** How far above the floor the model begins: surfaces in one plane would be seen through each other. */
    private static final double GAP = 0.002;
    /** The angle that the camera sees from top to bottom, in degrees. */
    private static final double FIELD = 36;
    /** From the middle of the model to the camera. */
    private static final double[] TOWARDS = {0.48, 0.36, 0.8};
    private static final double MARGIN = 1.05;
    private static final double DECIMALS = 1e4;

    private ModelScene() {
    }

    /** {@return whether a file's name is that of a model} */
    static boolean isModel(Path file) {
        return file.toString().toLowerCase(Locale.ROOT).endsWith(".obj");
    }

    /** {@return the scene of a model, which is read anew whenever the scene is} */
    static SceneSource of(Path model) {
        String name = model.getFileName().toString();
        Path home = model.resolveSibling(name.substring(0, name.lastIndexOf('.')) + ".scene");
        return new UntitledSource(home.toString(), home, () -> text(model).getBytes(StandardCharsets.UTF_8));
    }

    private static String text(Path model) throws IOException {
        String name = model.getFileName().toString();
        if (name.matches("(?s).*[\"\n\r].*")) {
            throw new FileSystemException(model.toString(), null, "no scene file can name a file with a quote or a line break in its name");
        }
        Bounds box = new Mesh(new Material(), model.toString(), new Point(), 1).bounds();
        double[] size = {box.xmax() - box.xmin(), box.ymax() - box.ymin(), box.zmax() - box.zmin()};
        double scale = rounded(SIZE / Math.max(size[0], Math.max(size[1], size[2])));
        double radius = scale * Math.sqrt(size[0] * size[0] + size[1] * size[1] + size[2] * size[2]) / 2;
        double middle = scale * size[1] / 2;
        double away = MARGIN * radius / Math.sin(Math.toRadians(FIELD / 2));
        Path folder = model.resolveSibling("");
        boolean coloured = MtlNames.of(folder, name).stream().anyMatch(Files::isRegularFile);
        return String.join("\n",
            "# The model " + name + " on a floor. Save Scene As writes this scene.",
            "2   # objects: the model, how far it is moved and how many times as large it is, and its material; the floor",
            "4   \"" + name + "\"   " + numbers(-scale * (box.xmin() + box.xmax()) / 2, GAP - scale * box.ymin(),
                -scale * (box.zmin() + box.zmax()) / 2) + "   " + scale + "   0.2 0.2 0.2   0.6 0.6 0.6   0 0 0   1"
                + (coloured ? "   mtl" : ""),
            "1   0 1 0   0   0.18 0.18 0.18   0.5 0.5 0.5   0 0 0   1",
            "0.7 0.7 0.7   # ambient light",
            "2   # lights from far away: a bright one from the upper left, a weak one from the right",
            "1   0.95 0.92 0.88    0.6 -1.0 -0.7",
            "1   0.3 0.31 0.33   -1.0 -0.5 -0.4",
            "camera  " + numbers(TOWARDS[0] * away, middle + TOWARDS[1] * away, TOWARDS[2] * away) + "   0 " + number(middle) + " 0   "
                + number(FIELD),
            "background  0.62 0.7 0.78",
            "");
    }

    private static String numbers(double x, double y, double z) {
        return number(x) + ' ' + number(y) + ' ' + number(z);
    }

    /** {@return a number with four decimals at most: the model's size is 2, wherever its file has it} */
    private static String number(double value) {
        double decimal = Math.round(value * DECIMALS) / DECIMALS;
        return decimal == Math.rint(decimal) ? Long.toString((long) decimal) : Double.toString(decimal);
    }

    /** {@return a number of four digits} */
    private static double rounded(double value) {
        return Double.parseDouble(String.format(Locale.ROOT, "%.3e", value));
    }
}
