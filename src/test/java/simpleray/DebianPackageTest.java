package simpleray;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.concurrent.TimeUnit;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import java.util.zip.GZIPInputStream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import simpleray.cli.Program;
import simpleray.render.RenderRequest;
import simpleray.scene.SceneFile;

/** The package that {@code gradle deb} makes, installed by dpkg below an empty root; skipped where there is no package or no dpkg. */
@Tag("slow")
class DebianPackageTest {
    private static final int WINDOW_SECONDS = 60;

    @TempDir
    private Path folder;
    private Path root;
    private Path deb;

    @BeforeEach
    void install() throws IOException, InterruptedException {
        Path debs = Project.build().resolve("deb");
        assumeTrue(Files.isDirectory(debs), "no package: gradle deb makes it");
        deb = debs.resolve(Project.names(debs, ".deb").get(0) + ".deb");
        assumeTrue(Files.isExecutable(Path.of("/usr/bin/dpkg")), "no dpkg");
        assumeTrue("root".equals(System.getProperty("user.name")), "only root can install a package");
        root = folder.resolve("root");
        Path database = root.resolve("var/lib/dpkg");
        Files.createDirectories(database.resolve("info"));
        Files.createDirectories(database.resolve("updates"));
        Files.createFile(database.resolve("status"));
        dpkg("-i", deb.toString());
    }

    @Test
    void itRendersByItsOwnJavaAndLeavesNothingBehind() throws IOException, InterruptedException {
        Path home = Files.createDirectory(folder.resolve("home"));
        Path picture = folder.resolve("thesis.png");

        Program.Result result = run(Map.of("HOME", home.toString(), "JAVA_TOOL_OPTIONS", "-Xlog:class+path:stderr"),
            program(), "render", Project.scene("thesis").toString(), "-o", picture.toString());

        assertThat(result.exitCode()).as(result.err()).isZero();
        assertThat(result.err()).contains("bootstrap loader class path=" + root.toRealPath().resolve("usr/lib/simpleray/runtime"));
        assertThat(Rendered.levels(Files.readAllBytes(picture))).isEqualTo(Rendered.levels(Rendered.png(
            new RenderRequest().renderer(SceneFile.read(Project.scene("thesis")).scene()))));
        assertThat(home).isEmptyDirectory();

        dpkg("--purge", "simpleray");
        assertThat(root.resolve("usr")).doesNotExist();
        assertThat(filesBelow(root)).allMatch(file -> file.startsWith("var/lib/dpkg"));
    }

    @Test
    void aJavaThatDoesNotStartIs70() throws IOException, InterruptedException {
        Program.Result result = run(Map.of("SIMPLERAY_OPTS", "-XX:Nonsense"), program(), "verify", "nothing.png");

        assertThat(result.err()).startsWith("simpleray: Java does not start: Unrecognized VM option 'Nonsense'");
        assertThat(result.exitCode()).isEqualTo(70);
    }

    @Test
    void itsWindowOpens() throws IOException, InterruptedException {
        String display = System.getenv("DISPLAY");
        assumeTrue(display != null, "no display");
        Path log = folder.resolve("loaded.log");
        ProcessBuilder builder = builder(Map.of("DISPLAY", display, "HOME", folder.toString(), "SIMPLERAY_PREFERENCES", "none",
            "JAVA_TOOL_OPTIONS", "-Xlog:class+load:file=" + log + ":none"), program(), Project.scene("thesis").toString());
        if (System.getenv("XAUTHORITY") != null) {
            builder.environment().put("XAUTHORITY", System.getenv("XAUTHORITY"));
        }
        Process window = builder.start();
        try {
            long end = System.nanoTime() + TimeUnit.SECONDS.toNanos(WINDOW_SECONDS);
            while (!(Files.exists(log) && Files.readString(log).contains("sun.awt.X11.XFramePeer "))) {
                assertThat(window.isAlive()).as("the window is being opened").isTrue();
                assertThat(System.nanoTime()).as("the time for it").isLessThan(end);
                TimeUnit.MILLISECONDS.sleep(100);
            }
        } finally {
            window.destroyForcibly().waitFor();
        }
    }

    @Test
    void itHasAMenuEntryAndAManPageOfEveryCommand() throws IOException, InterruptedException {
        Path share = root.resolve("usr/share");
        assertThat(share.resolve("applications/simpleray.desktop")).content().contains("\nExec=simpleray %f\n", "\nIcon=simpleray\n");
        assertThat(share.resolve("icons/hicolor/256x256/apps/simpleray.png")).isRegularFile();
        String page;
        try (GZIPInputStream in = new GZIPInputStream(Files.newInputStream(share.resolve("man/man1/simpleray.1.gz")))) {
            page = new String(in.readAllBytes(), StandardCharsets.UTF_8);
        }
        assertThat(page).contains(".SH NAME\nsimpleray \\- ", ".SH SYNOPSIS\n", ".SH DESCRIPTION\n", ".SH EXIT CODES\n");
        for (String command : List.of("view", "render", "animate", "figures", "explain", "print", "check", "convert", "still", "import", "export", "job",
            "verify", "compare", "bench")) {
            assertThat(page).contains("Usage: simpleray " + command + " ");
        }
    }

    @Test
    void allOfItIsRootsAndOfOneTime() throws IOException, InterruptedException {
        Program.Result listed = run(Map.of("TZ", "UTC"), Path.of("/usr/bin/dpkg-deb"), "--contents", deb.toString());

        assertThat(listed.exitCode()).as(listed.err()).isZero();
        assertThat(listed.text().lines()).hasSizeGreaterThan(50).allMatch(line -> line.matches(".{10} root/root .*"));
        assertThat(listed.text().lines().map(line -> line.replaceAll(".* (\\d{4}-\\d\\d-\\d\\d \\d\\d:\\d\\d) .*", "$1")).distinct())
            .hasSize(1);
    }

    private Path program() {
        return root.resolve("usr/bin/simpleray");
    }

    /** Below an empty root there is nothing that the package needs, so that it needs force. */
    private void dpkg(String... args) throws IOException, InterruptedException {
        List<String> line = Stream.concat(Stream.of("--root=" + root, "--force-depends"), Stream.of(args)).collect(Collectors.toList());
        Program.Result result = run(Map.of("PATH", "/usr/sbin:/usr/bin:/sbin:/bin"), Path.of("/usr/bin/dpkg"),
            line.toArray(new String[0]));
        assertThat(result.exitCode()).as(result.err()).isZero();
    }

    private Program.Result run(Map<String, String> environment, Path program, String... args) throws IOException, InterruptedException {
        return Program.finish(builder(environment, program, args).start(), new byte[0]);
    }

    /** {@return a program that knows of nothing but its environment} */
    private ProcessBuilder builder(Map<String, String> environment, Path program, String... args) {
        ProcessBuilder builder = new ProcessBuilder(Stream.concat(Stream.of(program.toString()), Stream.of(args))
            .collect(Collectors.toList())).directory(folder.toFile());
        builder.environment().clear();
        builder.environment().putAll(environment);
        return builder;
    }

    private static List<Path> filesBelow(Path folder) throws IOException {
        try (Stream<Path> files = Files.walk(folder)) {
            return files.filter(Files::isRegularFile).map(folder::relativize).collect(Collectors.toList());
        }
    }
}
