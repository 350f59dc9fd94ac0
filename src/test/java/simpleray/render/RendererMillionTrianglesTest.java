package simpleray.render;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.BufferedWriter;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import simpleray.image.Picture;
import simpleray.scene.Mesh;
import simpleray.scene.Scene;
import simpleray.scene.SceneFile;
import simpleray.scene.SimpleCamera;

/** A mesh of a million triangles is read and rendered. The time is printed, not judged. */
class RendererMillionTrianglesTest {
    private static final int ACROSS = 1000;
    private static final int DOWN = 500;
    private static final int SIZE = 50;

    @Tag("slow")
    @Test
    void aMillionTrianglesAreReadAndRendered(@TempDir Path folder) throws IOException {
        writeGrid(folder.resolve("grid.obj"));
        Path file = Files.writeString(folder.resolve("a.scene"),
            "1\n4 \"grid.obj\" -2 -2 0  0.008  1 1 1  0 0 0  0 0 0  0\n1 1 1\n0\n");

        long start = System.nanoTime();
        Scene scene = SceneFile.read(file).scene();
        long read = System.nanoTime();
        Picture picture = new Renderer(scene, new SimpleCamera(SIZE, SIZE), new RenderSettings()).render(row -> { });
        long end = System.nanoTime();
        System.out.printf("1,000,000 triangles: read in %.2f s, rendered in %.2f s%n", (read - start) / 1e9, (end - read) / 1e9);

        assertThat(((Mesh) scene.getObject(0)).size()).isEqualTo(1_000_000);
        // the grid is 8 wide and 4 high on the window's plane, from (-2,-2): it fills the window
        for (int y = 0; y < SIZE; y++) {
            assertThat(picture.row(y)).containsOnly(1);
        }
    }

    private static void writeGrid(Path path) throws IOException {
        try (BufferedWriter out = Files.newBufferedWriter(path)) {
            StringBuilder line = new StringBuilder();
            for (int y = 0; y <= DOWN; y++) {
                for (int x = 0; x <= ACROSS; x++) {
                    line.setLength(0);
                    out.append(line.append("v ").append(x).append(' ').append(y).append(" 0\n"));
                }
            }
            for (int y = 0; y < DOWN; y++) {
                for (int x = 1; x <= ACROSS; x++) {
                    int a = y * (ACROSS + 1) + x;
                    line.setLength(0);
                    out.append(line.append("f ").append(a).append(' ').append(a + 1).append(' ').append(a + ACROSS + 2).append(' ')
                        .append(a + ACROSS + 1).append('\n'));
                }
            }
        }
    }
}
