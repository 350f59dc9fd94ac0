package simpleray;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.File;
import java.io.IOException;
import java.io.StringWriter;
import java.lang.module.ModuleFinder;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.zip.ZipEntry;
import java.util.zip.ZipFile;
import javax.tools.JavaCompiler;
import javax.tools.ToolProvider;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import simpleray.cli.Program;
import simpleray.math.Point;
import simpleray.render.Provenance;
import simpleray.render.RenderRequest;
import simpleray.scene.Material;
import simpleray.scene.PointLight;
import simpleray.scene.Scene;
import simpleray.scene.Sphere;

/** The renderer as other programs get it: the published artifact, and what docs/library.md says of it. */
class LibraryTest {
    private static final String NAME = "simpleray-core";
    private static final Path FOLDER = Project.build().resolve("repository/simpleray").resolve(NAME).resolve(Provenance.VERSION);
    private static final Path JAR = published(".jar");
    private static final int MAX_BYTES = 450_000;
    private static final int MAX_LINES = 25;

    @TempDir
    private Path folder;

    @Test
    void theExampleOfThePageNeedsNothingButTheLibraryAndNoAwt() throws IOException, InterruptedException {
        String example = codeOfThePage().get(0);
        assertThat(example.lines()).hasSizeLessThanOrEqualTo(MAX_LINES);

        List<String> loaded = run("Ball", example, "ball.png");

        assertThat(loaded).contains("simpleray.render.Renderer")
            .noneMatch(name -> name.matches("(java\\.awt|javax\\.swing|javax\\.imageio|sun\\.awt|sun\\.java2d)\\..*"));
        Scene ball = new Scene();
        ball.setNumberObjects(1);
        ball.setObject(0, new Sphere(new Material(), new Point(0, 0, -1), 1.5));
        ball.setNumberLights(1);
        ball.setLight(0, new PointLight(new Point(-2, 3, 2)));
        assertThat(folder.resolve("ball.png")).hasBinaryContent(Rendered.png(new RenderRequest().renderer(ball)));
    }

    @Test
    void theOtherLinesOfThePageCompileAndRun() throws IOException, InterruptedException {
        StringBuilder source = new StringBuilder("import java.awt.image.BufferedImage;\n");
        for (String name : names(JAR)) {
            if (name.matches("simpleray/\\w+/")) {
                source.append("import ").append(name.replace('/', '.')).append("*;\n");
            }
        }
        source.append("public class Lines {\npublic static void main(String[] args) throws Exception {\n")
            .append(codeOfThePage().get(1)).append("if (image.getRGB(63, 47) != 0xFF3366CC) throw new Exception();\n}\n}\n");

        assertThat(run("Lines", source.toString())).contains("java.awt.image.BufferedImage");
    }

    @Test
    void theJarIsSmallAndHoldsNeitherTheWindowNorTheCommandLine() throws IOException {
        assertThat(Files.size(JAR)).isLessThan(MAX_BYTES);
        assertThat(names(JAR)).contains("META-INF/LICENSE", "simpleray/scene/Scene.class")
            .allMatch(name -> name.startsWith("simpleray/") || name.startsWith("META-INF/"))
            .noneMatch(name -> name.startsWith("simpleray/ui/") || name.startsWith("simpleray/cli/"));
        assertThat(ModuleFinder.of(JAR).find("simpleray")).isPresent();
    }

    @Test
    void itsSourcesAndItsJavadocArePublishedWithIt() throws IOException {
        List<String> classes = topLevel(names(JAR), ".class");

        assertThat(topLevel(names(published("-sources.jar")), ".java")).containsAll(classes);
        assertThat(names(published("-javadoc.jar"))).contains("index.html", "simpleray/scene/Scene.html");
        assertThat(published(".pom")).content().contains("<artifactId>" + NAME + "</artifactId>").doesNotContain("<dependency>");
    }

    private static Path published(String ending) {
        return FOLDER.resolve(NAME + '-' + Provenance.VERSION + ending);
    }

    private static List<String> codeOfThePage() throws IOException {
        return Pattern.compile("```java\n(.*?)```", Pattern.DOTALL).matcher(Files.readString(Project.root().resolve("docs/library.md")))
            .results().map(match -> match.group(1)).collect(Collectors.toList());
    }

    private static List<String> names(Path jar) throws IOException {
        try (ZipFile zip = new ZipFile(jar.toFile())) {
            return zip.stream().map(ZipEntry::getName).collect(Collectors.toList());
        }
    }

    private static List<String> topLevel(List<String> names, String ending) {
        return names.stream().filter(name -> name.endsWith(ending) && !name.contains("$") && !name.contains("-info."))
            .map(name -> name.substring(0, name.length() - ending.length())).collect(Collectors.toList());
    }

    /** Compiles a class and runs it with nothing but the library. {@return the classes that were loaded} */
    private List<String> run(String name, String source, String... args) throws IOException, InterruptedException {
        JavaCompiler compiler = ToolProvider.getSystemJavaCompiler();
        StringWriter messages = new StringWriter();
        Path file = Files.writeString(folder.resolve(name + ".java"), source);
        assertThat(compiler.getTask(messages, null, null, List.of("-cp", JAR.toString(), "-d", folder.toString(), "-Xlint:all"), null,
            compiler.getStandardFileManager(null, null, null).getJavaFileObjects(file)).call()).as(messages.toString()).isTrue();
        assertThat(messages.toString()).isEmpty();

        List<String> line = new ArrayList<>(List.of("-Djava.awt.headless=true", "-Xlog:class+load:file=loaded.log:none", "-cp",
            JAR + File.pathSeparator + folder, name));
        line.addAll(List.of(args));
        Program.Result result = Program.finish(Program.java(Path.of(System.getProperty("java.home")), folder, line).start(), new byte[0]);
        assertThat(result.err()).isEmpty();
        assertThat(result.text()).isEmpty();
        assertThat(result.exitCode()).isZero();
        return Files.readAllLines(folder.resolve("loaded.log")).stream().map(told -> told.split(" ")[0]).collect(Collectors.toList());
    }
}
