package simpleray;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import simpleray.render.RenderRequest;
import simpleray.render.Stage;
import simpleray.scene.SceneFile;
import simpleray.scene.SceneSettings;

/** Writes the golden images anew: a small picture of each scene in scenes/. Why and when: docs/golden-images.md. */
public final class GoldenImages {
    private static final int SIDE = 160;

    private GoldenImages() {
    }

    /**
     * Writes all golden images, removes those that no scene belongs to, and tells which changed.
     *
     * @param args none
     * @throws IOException if a scene cannot be read or an image not be written
     */
    public static void main(String[] args) throws IOException {
        Files.createDirectories(folder());
        for (String name : Project.names(folder(), ".png")) {
            if (!Project.scenes().contains(name)) {
                Files.delete(file(name));
                System.out.println(name + ": removed");
            }
        }
        for (String name : Project.scenes()) {
            byte[] png = png(name);
            boolean there = Files.exists(file(name));
            boolean same = there && Arrays.equals(Rendered.levels(Files.readAllBytes(file(name))), Rendered.levels(png));
            if (!same) {
                Files.write(file(name), png);
            }
            System.out.println(name + (same ? ": as before" : there ? ": changed" : ": new"));
        }
    }

    /** {@return the folder of the golden images} */
    static Path folder() {
        return Project.resources("golden");
    }

    /** {@return the golden image of a scene} */
    static Path file(String name) {
        return folder().resolve(name + ".png");
    }

    /** {@return the PNG file of a scene as it is now, by its own settings but small; the thesis's in its own size} */
    static byte[] png(String name) throws IOException {
        SceneSettings small = new SceneSettings();
        if (!name.startsWith("thesis")) {
            small.resolution = new SceneSettings.Resolution(SIDE, SIDE);
        }
        return Rendered.png(new RenderRequest(small, Stage.FINAL, false, 1).renderer(SceneFile.read(Project.scene(name)).scene()));
    }
}
