package simpleray.scene;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Scenes have the same hash if and only if all their numbers are the same. */
class SceneHashTest {
    private static final String BALL = "1\n0  0 0 -1  0.5  1 1 1  0.5 0.5 0.5  0 0 0  5\n0.1 0.1 0.1\n1\n0  1 1 1  0 2 0\n";
    private static final String SQUARE = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvn 0 0 1\nf 1 2 3\nf 1//1 3//1 4//1\n";

    @TempDir
    Path folder;

    private String hash(String text) throws IOException {
        return SceneHash.of(SceneFile.read(Files.writeString(folder.resolve("a.scene"), text)).scene());
    }

    private String meshHash(String obj) throws IOException {
        Files.writeString(folder.resolve("a.obj"), obj);
        return hash("2\n" + ("4 \"a.obj\" 0 0 0  1  1 1 1  0 0 0  0 0 0  1\n").repeat(2) + "1 1 1\n0\n");
    }

    @Test
    void itIs64Digits() throws IOException {
        assertThat(hash(BALL)).matches("[0-9a-f]{64}");
    }

    @Test
    void commentsFormAndSettingsDoNotCount() throws IOException {
        assertThat(hash("# a ball\n" + BALL.replace("0.5", "5e-1") + "depth 3\nbackground 0 0 1\n")).isEqualTo(hash(BALL));
    }

    @ParameterizedTest
    @CsvSource({"0 0 -1, 0 0 -1.0000000000000002", "0 0 -1, 0 -0.0 -1", "0.1 0.1 0.1, 0.1 0.1 0.2", "0 2 0, 0 2 1", "0  5, 0  6", "0  5, 0  5 mirror 0 0 0"})
    void anyNumberCounts(String number, String other) throws IOException {
        assertThat(BALL).contains(number);
        assertThat(hash(BALL.replace(number, other))).isNotEqualTo(hash(BALL));
    }

    @ParameterizedTest
    @CsvSource({"v 0 1 0, v 0 1 0.5", "f 1 2 3, f 1 3 2", "vn 0 0 1, vn 0 1 1", "3//1 4//1, 3//2 4//1"})
    void anyNumberOfAMeshCounts(String number, String other) throws IOException {
        String square = SQUARE.replace("vn 0 0 1\n", "vn 0 0 1\nvn 1 0 0\n");
        assertThat(square).contains(number);
        assertThat(meshHash(square.replace(number, other))).isNotEqualTo(meshHash(square));
    }

    private String materialHash(String obj, String mtl, String word) throws IOException {
        Files.writeString(folder.resolve("a.mtl"), mtl);
        Files.writeString(folder.resolve("a.obj"), "mtllib a.mtl\n" + obj);
        return hash("1\n4 \"a.obj\" 0 0 0  1  1 1 1  0 0 0  0 0 0  1 " + word + "\n1 1 1\n0\n");
    }

    @ParameterizedTest
    @CsvSource({"Kd 1 0 0, Kd 1 0 0.5", "Ns 3, Ns 4", "illum 2, illum 3", "d 0.5, d 0.25", "Ni 1.5, Ni 1.25"})
    void anyNumberOfAMaterialCounts(String number, String other) throws IOException {
        String obj = "usemtl red\n" + SQUARE;
        String mtl = "newmtl red\nKd 1 0 0\nNs 3\nillum 2\nd 0.5\nNi 1.5\nnewmtl blue\nKd 0 0 1\n";

        assertThat(mtl).contains(number);
        assertThat(materialHash(obj, mtl.replace(number, other), "mtl")).isNotEqualTo(materialHash(obj, mtl, "mtl"));
        assertThat(materialHash(obj, mtl.replace(number, other), "")).isEqualTo(materialHash(obj, mtl, ""));
        assertThat(materialHash(obj, mtl.replace("0 0 1", "0 1 0") + "# more", "mtl")).as("unused").isEqualTo(materialHash(obj, mtl, "mtl"));
    }

    @Test
    void whichPolygonsHaveAMaterialCounts() throws IOException {
        String mtl = "newmtl red\nKd 1 0 0\n";

        assertThat(materialHash(SQUARE.replace("f 1//1", "usemtl red\nf 1//1"), mtl, "mtl")).isNotEqualTo(materialHash("usemtl red\n" + SQUARE, mtl, "mtl"))
            .isNotEqualTo(materialHash(SQUARE, mtl, "mtl"));
    }

    @Test
    void aMeshLargerThanTheBufferCountsToItsEnd() throws IOException {
        StringBuilder obj = new StringBuilder();
        for (int i = 0; i < 2000; i++) {
            obj.append("v ").append(i).append(" 0 0\nv ").append(i).append(" 1 0\nv ").append(i).append(" 0 1\nf -3 -2 -1\n");
        }
        String last = obj.toString().replace("v 1999 0 1", "v 1999 0 2");
        String middle = obj.toString().replace("v 700 0 1", "v 700 0 2");

        assertThat(meshHash(obj.toString())).isEqualTo(meshHash("# the same\n" + obj)).isNotEqualTo(meshHash(last))
            .isNotEqualTo(meshHash(middle));
    }
}
