package simpleray.scene;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Path;
import simpleray.text.SceneReader;

/** The thesis's scene, as printed in its chapter 6. */
public final class ThesisScene {
    private static final String FOLDER = "/simpleray/reference/";

    private ThesisScene() {
    }

    /** {@return the scene} */
    public static Scene read() throws IOException {
        try (SceneReader is = reader()) {
            Scene scene = new Scene();
            scene.read(is);
            return scene;
        }
    }

    /** {@return a reader of its listing, which messages call {@code thesis.scene}} */
    public static SceneReader reader() {
        return new SceneReader(ThesisScene.class.getResourceAsStream(FOLDER + "thesis-as-printed.scene"), "thesis.scene",
            Path.of(""));
    }

    /** {@return a file of the references} */
    public static byte[] reference(String name) throws IOException {
        try (InputStream in = ThesisScene.class.getResourceAsStream(FOLDER + name)) {
            return in.readAllBytes();
        }
    }
}
