package simpleray.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;
import simpleray.Project;
import simpleray.image.Picture;
import simpleray.render.RenderListener;
import simpleray.render.RenderSettings;
import simpleray.render.Renderer;
import simpleray.scene.Scene;
import simpleray.scene.SceneFile;
import simpleray.scene.SimpleCamera;

/** {@code explain}: why a pixel has its colour. */
class ExplainCommandTest {
    private static final String WALL = "1\n1 0 0 1 -2  0.5 1 0.25  1 1 1  0 0 0  1\n1 1 1\n1\n1  1 0.5 0  0 0 1\n";
    private static final Pattern COLOUR = Pattern.compile("\"colour\":\\[([^]]*)]");

    @TempDir
    Path folder;

    @Test
    void theStoryIsPrintedAsText() {
        Program.Result result = InProcess.runWithInput(WALL, "explain", "-", "--pixel", "0,0", "--size", "1x1");

        assertThat(result.text()).isEqualTo("""
            pixel 0,0 of 1x1, stage final: 0.5 1 0.25, levels 128 255 64
              White back wall (line 2), turned away from light 1.
                0.5 1 0.25 = ambient 0.5 1 0.25
                ambient = Ka · GA = (0.5 1 0.25) · (1 1 1) = 0.5 1 0.25
                light 1 (line 5) is behind the surface
                  L = (0 0 -1), N·L = -1
                ray from (0 0 2) along (0 0 -1), depth 10: t = 4, P = (0 0 -2), N = (0 0 1), going in
            """);
        assertThat(result.err()).isEmpty();
        assertThat(result.exitCode()).isZero();
    }

    @Test
    void theStoryIsPrintedAsOneJsonObject() {
        String scene = "2\n1 0 0 1 -2  0.1 0.1 0.1  1 1 1  0.5 0.5 0.5  2\n"
            + "0 0 0 4 1  0 0 0  0 0 0  0 0 0  1  transmit 0.5 0.5 0.5 1.5\n1 1 1\n2\n0  1 1 1  0 0 8\n1  1 0.5 0  0 0 1\n";
        Program.Result result = InProcess.runWithInput(scene, "explain", "-", "--pixel", "0,0", "--size", "1x1", "--depth", "1",
            "--format", "JSON");

        assertThat(result.text()).isEqualTo(json("{'x':0,'y':0,'width':1,'height':1,'stage':'final',")
            + json("'colour':[0.85,0.85,0.85],'levels':[217,217,217],")
            + json("'mean':false,'samples':[{'at':[0.5,0.5],'clamped':false,'colour':[0.85,0.85,0.85],'ray':{'origin':[0.0,0.0,2.0],")
            + json("'direction':[0.0,0.0,-1.0],'depth':1,'told':true,'colour':[0.85,0.85,0.85],'hit':{'number':1,'kind':'plane','line':2,")
            + json("'distance':4.0,'point':[0.0,0.0,-2.0],'normal':[0.0,0.0,1.0],'enters':true,")
            + json("'material':{'Ka':[0.1,0.1,0.1],'Kd':[1.0,1.0,1.0],")
            + json("'Ks':[0.5,0.5,0.5],'shininess':2.0,'Kt':[0.0,0.0,0.0],")
            + json("'index':1.0},'GA':[1.0,1.0,1.0],'ambient':[0.1,0.1,0.1],'lights':[")
            + json("{'number':1,'kind':'point light','line':6,'LC':[1.0,1.0,1.0],'distance':10.0,")
            + json("'L':[0.0,0.0,1.0],'N.L':1.0,'H':[0.0,0.0,1.0],'N.H':1.0,'verdict':'dimmed',")
            + json("'between':[{'number':2,'kind':'sphere','line':3,'Kt':[0.5,0.5,0.5]}],'arriving':[0.5,0.5,0.5],")
            + json("'diffuse':[0.5,0.5,0.5],'specular':[0.25,0.25,0.25]},")
            + json("{'number':2,'kind':'directional light','line':7,'LC':[1.0,0.5,0.0],'distance':null,'L':[-0.0,-0.0,-1.0],'N.L':-1.0,")
            + json("'H':[-0.0,-0.0,0.0],'N.H':0.0,'verdict':'turned away','between':[],'arriving':[0.0,0.0,0.0],'diffuse':[0.0,0.0,0.0],")
            + json("'specular':[0.0,0.0,0.0]}],'diffuse':[0.5,0.5,0.5],'specular':[0.25,0.25,0.25],'mirror':{'share':[0.5,0.5,0.5],")
            + json("'colour':[0.0,0.0,0.0],'ray':{'origin':[0.0,0.0,-2.0],'direction':[0.0,0.0,1.0],'depth':0,")
            + json("'told':true,'colour':[0.0,0.0,0.0],")
            + json("'hit':{'number':2,'kind':'sphere','line':3,")
            + result.text().substring(result.text().indexOf("\"distance\":5.0")));
        assertThat(result.text()).endsWith("\"mirror\":null,\"refracted\":null}}},\"refracted\":null}}}]}\n");
    }

    @Test
    void theJsonHasAnAreaLightAndOnRequestItsPoints() {
        String scene = "2\n1 0 0 1 -2  0 0 0  1 1 1  0 0 0  1\n0 1.5 0 0 0.5  0 0 0  0 0 0  0 0 0  1\n0 0 0\n1\n"
            + "2  1 0.5 0.25  -6 0 6  12 0 0  0 0 -16  2\n";
        String[] line = {"explain", "-", "--pixel", "0,0", "--size", "1x1", "--format", "json", "--points"};
        String few = InProcess.runWithInput(scene, Arrays.copyOf(line, line.length - 1)).text();
        String all = InProcess.runWithInput(scene, line).text();

        String sums = json("{'number':1,'kind':'area light','line':6,'LC':[1.0,0.5,0.25],'points':4,'whole':1,'dimmed':0,'blocked':1,")
            + json("'turned away':2,'shadows':true,'between':[{'number':2,'kind':'sphere','line':3}],'diffuse':[0.2,0.1,0.05],")
            + json("'specular':[0.0,0.0,0.0],'each':[");
        assertThat(few).contains(sums + "]}]");
        assertThat(all).contains(sums + json("{'number':1,'kind':'area light','line':6,'LC':[0.25,0.125,0.0625],'distance':5.0,"));
        assertThat(all.split("\"verdict\"")).hasSize(5);
    }

    @Test
    void theJsonHasTheMirrorOfAMaterialThatHasOne() {
        String scene = "1\n1 0 0 1 -2  0 0 0  0 0 0  0.5 0.5 0.5  2  mirror 0.25 0 1\n1 1 1\n0\nbackground 1 1 1\n";
        String text = InProcess.runWithInput(scene, "explain", "-", "--pixel", "0,0", "--size", "1x1", "--format", "json").text();

        assertThat(text).contains(json("'Ks':[0.5,0.5,0.5],'shininess':2.0,'mirror':[0.25,0.0,1.0],'Kt':[0.0,0.0,0.0],"))
            .contains(json("'mirror':{'share':[0.25,0.0,1.0],'colour':[0.25,0.0,1.0],"));
    }

    private static String json(String singleQuoted) {
        return singleQuoted.replace('\'', '"');
    }

    @ParameterizedTest
    @CsvSource({"100,120", "60,150", "199,0", "140,125"})
    void theColourIsThatOfTheRenderedPictureToTheLastBit(int x, int y) throws IOException {
        Scene scene = SceneFile.read(Project.scene("thesis")).scene();
        double[] row = new Renderer(scene, new SimpleCamera(200, 200), new RenderSettings()).render(RenderListener.NONE).row(y);

        String json = InProcess.run("explain", Project.scene("thesis").toString(), "--pixel", x + "," + y, "--format", "json").text();

        Matcher colour = COLOUR.matcher(json);
        assertThat(colour.find()).isTrue();
        assertThat(List.of(colour.group(1).split(",")).stream().map(Double::valueOf).collect(Collectors.toList()))
            .containsExactly(row[3 * x], row[3 * x + 1], row[3 * x + 2]);
        assertThat(json).contains("\"levels\":[" + Picture.level(row[3 * x]) + ',' + Picture.level(row[3 * x + 1]) + ','
            + Picture.level(row[3 * x + 2]) + ']');
    }

    @Test
    void anOptionCountsAsForRenderAndTheSceneFilesOwnSettingsElse() {
        String scene = WALL + "resolution 3 2\nsamples 2\ndepth 7\n";

        String own = InProcess.runWithInput(scene, "explain", "-", "--pixel", "2,1").text();
        String asked = InProcess.runWithInput(scene, "explain", "-", "--pixel", "2,1", "--size", "5x4", "--samples", "1", "--depth", "3",
            "--stage", "Normals", "--accel", "none").text();

        assertThat(own).startsWith("pixel 2,1 of 3x2, stage final: 0.5 1 0.25, levels 128 255 64\n  the mean of 4 samples")
            .contains(", depth 7: ");
        assertThat(asked).startsWith("pixel 2,1 of 5x4, stage normals: 0.5 0.5 1, levels 128 128 255\n  the view normals ")
            .contains(", depth 3: ");
    }

    @ParameterizedTest
    @ValueSource(strings = {"1,0", "0,1", "7,9"})
    void aPixelOutsideThePictureIsWrongUsage(String pixel) {
        Program.Result result = InProcess.runWithInput(WALL, "explain", "-", "--pixel", pixel, "--size", "1x1");

        assertThat(result.err()).isEqualTo("simpleray explain: the pixel " + pixel
            + " is outside the picture of 1x1, whose last one is 0,0 (see simpleray explain --help)\n");
        assertThat(result.text()).isEmpty();
        assertThat(result.exitCode()).isEqualTo(ExitCode.USAGE);
    }

    @ParameterizedTest
    @ValueSource(strings = {"1", "a,b", "-1,0", "1,2,3", "1.5,2", ""})
    void whatIsNoPixelIsWrongUsage(String pixel) {
        Program.Result result = InProcess.runWithInput(WALL, "explain", "-", "--pixel=" + pixel);

        assertThat(result.err()).isEqualTo("simpleray explain: Invalid value for option '--pixel': "
            + "expected two integers from 0 such as 120,80, found '" + pixel + "' (see simpleray explain --help)\n");
        assertThat(result.exitCode()).isEqualTo(ExitCode.USAGE);
    }

    @Test
    void withoutAPixelItIsWrongUsage() {
        Program.Result result = InProcess.runWithInput(WALL, "explain", "-");

        assertThat(result.err()).isEqualTo("simpleray explain: Missing required option: '--pixel=X,Y' (see simpleray explain --help)\n");
        assertThat(result.exitCode()).isEqualTo(ExitCode.USAGE);
    }

    @Test
    void aBadSceneAndAMissingOneEndAsForOtherCommands() throws IOException {
        Path bad = Files.writeString(folder.resolve("bad.scene"), SmallScenes.BAD);
        Program.Result read = InProcess.run("explain", bad.toString(), "--pixel", "0,0");
        Program.Result missing = InProcess.run("explain", folder.resolve("none.scene").toString(), "--pixel", "0,0");

        assertThat(read.err()).isEqualTo(String.format(SmallScenes.BAD_REPORT, bad));
        assertThat(read.exitCode()).isEqualTo(ExitCode.BAD_SCENE);
        assertThat(missing.err()).isEqualTo("simpleray: " + folder.resolve("none.scene") + ": no such file\n");
        assertThat(missing.exitCode()).isEqualTo(ExitCode.NO_SCENE);
    }

    @Test
    void warningsGoToStandardErrorUnlessItIsToBeQuiet() {
        Program.Result told = InProcess.runWithInput(SmallScenes.WITH_HEADING, "explain", "-", "--pixel", "0,0");
        Program.Result quiet = InProcess.runWithInput(SmallScenes.WITH_HEADING, "explain", "-", "--pixel", "0,0", "-q");

        assertThat(told.err()).isEqualTo(String.format(SmallScenes.HEADING_WARNING, "<stdin>"));
        assertThat(quiet.err()).isEmpty();
        assertThat(quiet.text()).isEqualTo(told.text());
    }

    @Test
    void theMaterialOfAMeshsPolygonIsNamed() throws IOException {
        Files.writeString(folder.resolve("a.obj"), "mtllib a.mtl\nv -9 -9 0\nv 9 -9 0\nv 0 9 0\nv -9 -9 4\nv 9 -9 4\nv 0 9 4\nusemtl \"dark\" red\nf 1 2 3\n"
            + "usemtl glass\nf 4 5 6\n");
        Path mtl = Files.writeString(folder.resolve("a.mtl"), "# x\nnewmtl \"dark\" red\nKd 0.5 0 0\nillum 2\n\nnewmtl glass\nd 0.25\n");
        Path scene = Files.writeString(folder.resolve("a.scene"), "1\n4 \"a.obj\" 0 0 0 1  0 0 0  0 1 0  1 1 1  1 mtl\n1 1 1\n1\n1  1 1 1  0 0 -1\n");

        assertThat(InProcess.run("explain", scene.toString(), "--pixel", "1,1", "--size", "3x3").text())
            .contains("\n  Red mesh (line 2, material '\"dark\" red' of " + mtl + ":2), lit by light 1 through the mesh (line 2)")
            .contains("arriving = LC · Kt = (1 1 1) · (0.75 0.75 0.75) = 0.75 0.75 0.75\n")
            .contains("diffuse = Kd · arriving · (N·L) = (0.5 0 0) · ");
        assertThat(InProcess.run("explain", scene.toString(), "--pixel", "1,1", "--size", "3x3", "--format", "json").text())
            .contains("{\"number\":1,\"kind\":\"mesh\",\"line\":2,\"mtl\":{\"name\":\"\\\"dark\\\" red\",\"file\":\"" + mtl + "\",\"line\":2},\"distance\":2.0,");
    }

    static List<String> scenes() {
        return Project.scenes();
    }

    /** Each kind of camera, light and object has its words. */
    @ParameterizedTest
    @MethodSource("scenes")
    void everySampleSceneIsExplained(String name) {
        Program.Result told = InProcess.run("explain", Project.scene(name).toString(), "--pixel", "3,3", "--size", "6x5", "--samples", "1");

        assertThat(told.exitCode()).as(told.err()).isZero();
        assertThat(told.text()).startsWith("pixel 3,3 of 6x5, stage final: ").contains("\n  ");
    }
}
