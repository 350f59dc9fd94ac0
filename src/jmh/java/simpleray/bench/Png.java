package simpleray.bench;

import java.io.IOException;
import java.io.OutputStream;
import java.util.concurrent.TimeUnit;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Setup;
import simpleray.image.Picture;
import simpleray.image.png.PngWriter;
import simpleray.render.RenderRequest;
import simpleray.render.Stage;
import simpleray.scene.SceneFile;
import simpleray.scene.SceneSettings;
import simpleray.scene.SceneSettings.Resolution;

/** The PNG of a rendered picture of 512 x 512. */
@OutputTimeUnit(TimeUnit.MILLISECONDS)
public class Png extends Bench {
    private static final int SIDE = 512;

    private Picture picture;

    /** Renders the thesis's scene. */
    @Setup
    public void render() throws IOException {
        SceneSettings asked = new SceneSettings();
        asked.resolution = new Resolution(SIDE, SIDE);
        picture = new RenderRequest(asked, Stage.FINAL, false, 1).renderer(SceneFile.read(sample("thesis.scene")).scene()).render(y -> { });
    }

    /** Writes it to nowhere. */
    @Benchmark
    public void write() throws IOException {
        PngWriter.write(picture, OutputStream.nullOutputStream());
    }
}
