package simpleray;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.FileSystem;
import java.nio.file.FileSystems;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;
import simpleray.cli.Program;

/** The script {@code simpleray} where something is in its way: the folder, Java, what is missing, the rights. */
class LauncherTest {
    private static final int INTERNAL = 70;
    /** Options that change nothing, with which the script makes no archive. */
    private static final String NO_ARCHIVE = "-Xshare:auto";
    private static final String SCENE = Project.scene("thesis").toString();

    @TempDir
    Path folder;
    private Checkout checkout;

    @BeforeEach
    void makeCheckout() throws IOException {
        assumeTrue(Files.isExecutable(Path.of("/bin/sh")), "no shell");
        checkout = new Checkout(folder.resolve("checkout"));
    }

    static List<String> names() {
        return Sample.of(List.of("a:b", ":", "two  words", "quo'te\"s", "100%41", "ha!lt", "!", "#1", "\u00E4\u03B1\u4E16", "a\nb", "end\n",
            "*?[a]$HOME`x`", "-x", "a\\b", "&;|<>"), 4);
    }

    @ParameterizedTest
    @MethodSource("names")
    void aCheckoutMayLieInAFolderOfAnyName(String name) throws IOException, InterruptedException {
        Path moved = Files.createDirectory(folder.resolve(name)).resolve(name);
        Files.move(checkout.root, moved);

        Program.Result result = checkout.run(moved.resolve("simpleray"), NO_ARCHIVE, "render", SCENE, "-o", "-", "--size", "20x15", "-q");

        assertThat(result.err()).isEmpty();
        assertThat(result.out()).isEqualTo(Program.run(folder, "render", SCENE, "-o", "-", "--size", "20x15", "-q").out());
    }

    /** The first start there makes no archive, which a class path of two would be. */
    @Test
    void aColonStaysWhenTheScriptIsStartedWithoutOptions() throws IOException, InterruptedException {
        Path moved = Files.move(checkout.root, folder.resolve("a:b"));

        assertThat(checkout.run(moved.resolve("simpleray"), "", "--version").text()).startsWith("SimpleRay ");
        assertThat(moved.resolve("build/cds")).doesNotExist();
    }

    @Test
    void aWindowIsRefusedInAFolderInWhichJavaFindsNoResources() throws IOException, InterruptedException {
        Files.createDirectory(folder.resolve("ha!"));
        Path moved = Files.move(checkout.root, folder.resolve("ha!/checkout"));
        ProcessBuilder view = new ProcessBuilder("/bin/sh", moved.resolve("simpleray").toString(), SCENE);
        view.environment().putAll(Map.of("DISPLAY", ":999", "SIMPLERAY_OPTS", NO_ARCHIVE));

        assertRefused(Program.finish(view.start(), new byte[0]),
            "Java can open no window from a folder whose name ends with '!': rename " + moved.toRealPath());
    }

    @ParameterizedTest
    @ValueSource(strings = {"-XX:Nonsense", "--nonsense", "-Xmx1k", "-Xms2g -Xmx1g", "-Xmx99999999999g", "-javaagent:/none.jar", "-agentpath:/none.so"})
    void aJvmThatDoesNotStartIs70(String options) throws IOException, InterruptedException {
        Program.Result result = checkout.run(options, "verify", "nothing.png");

        assertThat(result.err()).startsWith("simpleray: Java does not start: ").hasLineCount(1);
        assertThat(result.exitCode()).isEqualTo(INTERNAL);
    }

    @ParameterizedTest
    @ValueSource(strings = {"JAVA_TOOL_OPTIONS", "_JAVA_OPTIONS", "JDK_JAVA_OPTIONS"})
    void aJvmThatDoesNotStartByTheEnvironmentIs70(String variable) throws IOException, InterruptedException {
        assertRefused(run(Map.of(variable, "-XX:Nonsense"), "verify", "nothing.png"),
            "Java does not start: Unrecognized VM option 'Nonsense'");
    }

    /** Options for which Java is not tried first, since they write files or wait for someone. */
    @ParameterizedTest
    @ValueSource(strings = {"-XX:+ArchiveClassesAtExit", "-Xshare:on -XX:SharedArchiveFile=/none", "-XX:AOTMode=nonsense",
        "-XX:StartFlightRecording=filename=/none/x", "-agentlib:jdwp=nonsense"})
    void aJvmThatDoesNotStartByAnOptionThatDoesSomethingIs70(String option) throws IOException, InterruptedException {
        for (String variable : Sample.of(List.of("SIMPLERAY_OPTS", "JAVA_TOOL_OPTIONS", "JDK_JAVA_OPTIONS"), 1)) {
            Program.Result result = run(Map.of(variable, option), "verify", "nothing.png");

            assertThat(result.err()).endsWith("simpleray: Java does not start, or could not do what its options ask for: its reason stands above\n");
            assertThat(result.exitCode()).isEqualTo(INTERNAL);
        }
        assertThat(checkout.root.resolve("build/cds")).doesNotExist();
    }

    /** The program's own 1 stays 1 with them. */
    @ParameterizedTest
    @ValueSource(strings = {"-Xshare:auto -XX:SharedArchiveFile=/none", "-Xshare:auto"})
    void picturesThatDifferAre1(String options) throws IOException, InterruptedException {
        for (String depth : List.of("0", "1")) {
            assertThat(Program.run(folder, "render", SCENE, "-o", depth + ".png", "--size", "20x15", "--depth", depth, "-q").exitCode()).isZero();
        }
        assertThat(checkout.run(options, "compare", folder.resolve("0.png").toString(), folder.resolve("1.png").toString()).exitCode()).isEqualTo(1);
        assertThat(checkout.run(options, "compare", folder.resolve("0.png").toString(), folder.resolve("0.png").toString()).exitCode()).isZero();
        assertThat(checkout.run(options, "verify", folder.resolve("0.png") + "x").exitCode()).isEqualTo(66);
    }

    @ParameterizedTest
    @ValueSource(strings = {"", "/none"})
    void aPathWithoutProgramsIsInNobodysWay(String path) throws IOException, InterruptedException {
        Path link = Files.createSymbolicLink(folder.resolve("link"), checkout.root.resolve("simpleray"));
        for (int i = 0; i < 2; i++) {                         // without an archive, and with one
            ProcessBuilder version = new ProcessBuilder("/bin/sh", link.toString(), "--version");
            version.environment().put("PATH", path);
            Program.Result result = Program.finish(version.start(), new byte[0]);

            assertThat(result.err()).isEmpty();
            assertThat(result.text()).startsWith("SimpleRay ");
        }
        assertThat(checkout.root.resolve("build/cds")).isNotEmptyDirectory();
    }

    @Test
    void aWorkingFolderThatIsGoneIsNamed() throws IOException, InterruptedException {
        Program.Result result = Program.finish(new ProcessBuilder("/bin/sh", "-c", "mkdir gone; cd gone; rmdir ../gone; exec \"$0\" --version",
            checkout.root.resolve("simpleray").toString()).directory(folder.toFile()).start(), new byte[0]);

        assertThat(result.err()).endsWith("simpleray: the working folder is gone\n");   // the shell may have said so, too
        assertThat(result.exitCode()).isEqualTo(INTERNAL);
    }

    @Test
    void aJvmThatHasTooLittleMemoryToStartIs70() throws IOException, InterruptedException {
        assertThat(checkout.run("", "--version").exitCode()).isZero();           // and an archive is there
        Program.Result result = Program.finish(new ProcessBuilder("/bin/sh", "-c", "ulimit -v 300000 && exec \"$0\" verify nothing.png",
            checkout.root.resolve("simpleray").toString()).directory(folder.toFile()).start(), new byte[0]);

        assertThat(result.err()).startsWith("simpleray: Java does not start: ").hasLineCount(1);
        assertThat(result.exitCode()).isEqualTo(INTERNAL);
        assertThat(folder).isDirectoryNotContaining("glob:**hs_err*");
    }

    @Test
    void aJarThatIsNoneIs70() throws IOException, InterruptedException {
        Files.writeString(checkout.jar, "PK");

        Program.Result result = checkout.run("", "verify", "nothing.png");

        assertThat(result.err()).startsWith("simpleray: Java does not start: ").hasLineCount(1);
        assertThat(result.exitCode()).isEqualTo(INTERNAL);
    }

    /** A class within it is damaged: Java finds that out when the program needs it. */
    @Test
    void aJarThatIsDamagedInTheMiddleIs70() throws IOException, InterruptedException {
        try (FileSystem jar = FileSystems.newFileSystem(checkout.jar)) {
            Files.write(jar.getPath("simpleray/scene/MeshFiles.class"), new byte[100]);
            Files.delete(jar.getPath("simpleray/image/Similarity.class"));
        }
        Program.Result damaged = checkout.run(NO_ARCHIVE, "check", SCENE);
        Program.Result missing = checkout.run(NO_ARCHIVE, "compare", Project.resources("golden") + "/thesis.png",
            Project.resources("golden") + "/thesis.png");

        for (Program.Result result : List.of(damaged, missing)) {
            assertThat(result.err()).startsWith("simpleray: a part of the program is missing or damaged, so install or build it again: ").hasLineCount(1);
            assertThat(result.exitCode()).isEqualTo(INTERNAL);
        }
    }

    @ParameterizedTest
    @ValueSource(strings = {"echo \"Error: missing 'server' JVM\" >&2; exit 1", "exit 1", "exit 134"})
    void aJavaThatIsBrokenIs70(String script) throws IOException, InterruptedException {
        Path home = fakeJava("17.0.1", script);

        Program.Result result = run(Map.of("JAVA_HOME", home.toString()), "verify", "nothing.png");

        assertThat(result.err()).startsWith("simpleray: Java does not start: ").hasLineCount(1);
        assertThat(result.exitCode()).isEqualTo(INTERNAL);
    }

    /** Where a Java has made its archive, it is tried no more, unless something of it has changed. */
    @Test
    void aJavaThatBreaksLaterIs70() throws IOException, InterruptedException {
        Path home = fakeJava("17.0.1", "exec '" + System.getProperty("java.home") + "/bin/java' \"$@\"");
        Map<String, String> environment = Map.of("JAVA_HOME", home.toString());
        assertThat(run(environment, "--version").exitCode()).isZero();
        assertThat(run(environment, "--version").err()).isEmpty();               // by the archive
        write(home.resolve("bin/java"), "#!/bin/sh\nexit 1\n");

        assertRefused(run(environment, "verify", "nothing.png"), "Java does not start: " + home + "/bin/java ends without a word");
    }

    @Test
    void theExitCodeOfAProgramThatStartsIsItsOwn() throws IOException, InterruptedException {
        for (String size : List.of("20x15", "15x20")) {
            assertThat(checkout.run(NO_ARCHIVE, "render", SCENE, "-o", size + ".png", "--size", size, "-q").exitCode()).isZero();
        }
        String[] other = {"render", SCENE, "-o", "other.png", "--size", "20x15", "--depth", "0", "-q"};
        assertThat(checkout.run(NO_ARCHIVE, other).exitCode()).isZero();

        assertThat(checkout.run(NO_ARCHIVE, "compare", "20x15.png", "other.png").exitCode()).isEqualTo(1);
        assertThat(checkout.run(NO_ARCHIVE, "compare", "20x15.png", "15x20.png").exitCode()).isEqualTo(2);
    }

    @Test
    void anEmptyEnvironmentIsEnough() throws IOException, InterruptedException {
        ProcessBuilder builder = checkout.with(Map.of(), "--version");
        builder.environment().clear();
        builder.environment().put("SIMPLERAY_OPTS", NO_ARCHIVE);

        assertThat(Program.finish(builder.start(), new byte[0]).text()).startsWith("SimpleRay ");
    }

    @Test
    void anInstallThatMayOnlyBeReadRunsItsOlderJar() throws IOException, InterruptedException {
        Files.setLastModifiedTime(checkout.jar, FileTime.fromMillis(0));

        Program.Result result = readOnly("--version");

        assertThat(result.text()).startsWith("SimpleRay ");
        assertThat(result.err())
            .isEqualTo("simpleray: build/libs/simpleray.jar is older than its sources, and may not be written: running it as it is\n");
        assertThat(result.exitCode()).isZero();
    }

    @Test
    void anInstallThatMayOnlyBeReadAndHasNoJarSaysSo() throws IOException, InterruptedException {
        Files.delete(checkout.jar);

        assertRefused(readOnly("--version"), "there is no build/libs/simpleray.jar, and it may not be written: "
            + "build it as a user who may write to " + checkout.root.toRealPath());
    }

    /** Runs the script with a checkout that its user may only read; root becomes another for it. */
    private Program.Result readOnly(String... args) throws IOException, InterruptedException {
        assumeTrue(folder.getFileSystem().supportedFileAttributeViews().contains("posix"), "no rights");
        Files.setPosixFilePermissions(folder, PosixFilePermissions.fromString("rwxr-xr-x"));
        for (Path part : List.of(checkout.root, checkout.root.resolve("build"), checkout.root.resolve("build/libs"))) {
            Files.setPosixFilePermissions(part, PosixFilePermissions.fromString("r-xr-xr-x"));
        }
        ProcessBuilder builder = checkout.with(Map.of("SIMPLERAY_OPTS", NO_ARCHIVE), args);
        if ("root".equals(System.getProperty("user.name"))) {
            assumeTrue(Files.isExecutable(Path.of("/usr/bin/setpriv")), "no setpriv, and root may write everywhere");
            builder.command().addAll(0, List.of("/usr/bin/setpriv", "--reuid", "12345", "--regid", "12345", "--clear-groups"));
        }
        try {
            return Program.finish(builder.start(), new byte[0]);
        } finally {
            for (Path part : List.of(checkout.root, checkout.root.resolve("build"), checkout.root.resolve("build/libs"))) {
                Files.setPosixFilePermissions(part, PosixFilePermissions.fromString("rwxr-xr-x"));
            }
        }
    }

    private Program.Result run(Map<String, String> environment, String... args) throws IOException, InterruptedException {
        return Program.finish(checkout.with(environment, args).start(), new byte[0]);
    }

    /** {@return the home of a Java that says it is of that version} */
    private Path fakeJava(String version, String script) throws IOException {
        Path home = folder.resolve("fake-java");
        Files.createDirectories(home.resolve("bin"));
        Files.createDirectories(home.resolve("lib/server"));
        for (String part : List.of("lib/modules", "lib/server/libjvm.so")) {
            Files.createFile(home.resolve(part));
        }
        Files.writeString(home.resolve("release"), "JAVA_VERSION=\"" + version + "\"\n");
        write(home.resolve("bin/java"), "#!/bin/sh\n" + script + '\n');
        return home;
    }

    static void write(Path program, String text) throws IOException {
        Files.write(program, text.getBytes(StandardCharsets.UTF_8));
        assertThat(program.toFile().setExecutable(true)).isTrue();
    }

    private static void assertRefused(Program.Result result, String why) {
        assertThat(result.err()).isEqualTo("simpleray: " + why + '\n');
        assertThat(result.exitCode()).isEqualTo(INTERNAL);
        assertThat(result.out()).isEmpty();
    }
}
