package simpleray;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import simpleray.cli.Program;

/** What {@code gradle/setup.sh} does for the scripts where something is missing, on a machine whose root and whose apt-get are played. */
class SetupTest {
    private static final List<String> TOOLS = List.of("cat", "dirname", "find", "locale", "ls", "mkdir", "mktemp", "mv", "readlink", "rm",
        "sed", "sh", "stty", "timeout", "touch", "wc");
    private static final int INTERNAL = 70;
    private static final String TWO = "install gradle fonts; echo $?; install xvfb; echo $?";

    @TempDir
    Path folder;
    private Checkout checkout;
    private Path bin;

    @BeforeEach
    void makeMachine() throws IOException {
        assumeTrue(System.getProperty("os.name").equals("Linux"), "no apt-get elsewhere");
        checkout = new Checkout(folder.resolve("checkout"));
        bin = Files.createDirectory(folder.resolve("bin"));
        for (String tool : TOOLS) {
            Path file = Path.of("/usr/bin", tool);
            if (Files.isExecutable(file)) {
                LauncherTest.write(bin.resolve(tool), "#!/bin/sh\nexec " + file + " \"$@\"\n");
            }
        }
        play("id", "echo 0");
        play("apt-get", "echo \"$*\" >>'" + folder + "/apt.log'");
    }

    private void play(String program, String script) throws IOException {
        LauncherTest.write(bin.resolve(program), "#!/bin/sh\n" + script + '\n');
    }

    @Test
    void rootInstallsWithoutATerminal() throws IOException, InterruptedException {
        Program.Result result = shell(Map.of(), TWO);

        assertThat(result.text()).isEqualTo("0\n0\n");
        assertThat(result.err()).isEqualTo("simpleray: installing gradle fonts\nsimpleray: installing xvfb\n");
        assertThat(installed()).containsExactly("gradle fonts", "xvfb");
    }

    @ParameterizedTest
    @ValueSource(strings = {"no", "NO", "never", "0", "false"})
    void theVariableForbidsIt(String value) throws IOException, InterruptedException {
        assertThat(shell(Map.of("SIMPLERAY_INSTALL", value), TWO).text()).isEqualTo("1\n1\n");
        assertThat(installed()).isEmpty();
    }

    @Test
    void nobodyIsAskedIfTheVariableForbidsIt() throws IOException, InterruptedException {
        assertThat(onTerminal(Map.of("SIMPLERAY_INSTALL", "no"), TWO, "y\ny\n")).doesNotContain("apt-get?");
        assertThat(installed()).isEmpty();
    }

    @Test
    void othersThanRootInstallNothing() throws IOException, InterruptedException {
        play("id", "echo 1000");

        assertThat(shell(Map.of("SIMPLERAY_INSTALL", "yes"), TWO).text()).isEqualTo("1\n1\n");
        assertThat(installed()).isEmpty();
    }

    @ParameterizedTest
    @ValueSource(strings = {"y", "Y", "yes"})
    void onATerminalItAsksForEach(String answer) throws IOException, InterruptedException {
        String out = onTerminal(Map.of(), TWO, answer + "\n" + answer + "\n");

        assertThat(out).contains("simpleray: install gradle fonts by apt-get? [y/N] ", "simpleray: install xvfb by apt-get? [y/N] ");
        assertThat(installed()).containsExactly("gradle fonts", "xvfb");
    }

    @ParameterizedTest
    @ValueSource(strings = {"n", "", "what"})
    void anyOtherAnswerIsNoForAll(String answer) throws IOException, InterruptedException {
        String out = onTerminal(Map.of(), TWO, answer + "\n");

        assertThat(out).contains("simpleray: install gradle fonts by apt-get? [y/N] ").doesNotContain("xvfb by apt-get");
        assertThat(installed()).isEmpty();
    }

    @Test
    void itAsksOnTheTerminalThoughTheSceneComesByStandardInput() throws IOException, InterruptedException {
        onTerminal(Map.of(), "{ " + TWO + "; } </dev/null", "y\nn\n");

        assertThat(installed()).containsExactly("gradle fonts");
    }

    @Test
    void aQuestionThatNobodyWouldSeeIsNotAsked() throws IOException, InterruptedException {
        onTerminal(Map.of(), "{ " + TWO + "; } 2>messages", "y\ny\n");

        assertThat(installed()).isEmpty();
        assertThat(checkout.root.resolve("messages")).isEmptyFile();
    }

    @Test
    void theVariableAnswersInAdvance() throws IOException, InterruptedException {
        assertThat(onTerminal(Map.of("SIMPLERAY_INSTALL", "yes"), TWO, "")).doesNotContain("apt-get?");

        assertThat(installed()).containsExactly("gradle fonts", "xvfb");
    }

    @Test
    void openingAPictureAsksBeforeItInstallsGradle() throws IOException, InterruptedException {
        assumeTrue(Files.isExecutable(Path.of(System.getProperty("java.home"), "bin/javac")), "no JDK");
        Files.delete(checkout.jar);
        String scene = "./simpleray scenes/thesis-as-printed.scene; echo exit $?";

        assertThat(onTerminal(Map.of(), scene, "n\n")).contains("simpleray: install gradle by apt-get? [y/N] ")
            .endsWith("simpleray: no Gradle that works: install one (Debian: apt-get install gradle)\r\nexit " + INTERNAL + "\r\n");
        assertThat(installed()).isEmpty();

        assertThat(shell(Map.of(), scene).text()).isEqualTo("exit " + INTERNAL + "\n");
        assertThat(installed()).containsExactly("gradle");
    }

    @ParameterizedTest
    @CsvSource({"openjdk version \"11.0.2\" 2019-01-15, ' (%s is Java 11)'", "java version \"1.8.0_202\", ' (%s is Java 8)'",
        "openjdk version \"16\" 2021-03-16, ' (%s is Java 16)'", "openjdk version \"17.0.9\" 2023-10-17, ''",
        "openjdk version \"25\" 2025-09-16, ''", "nonsense, ' (%s is none that tells its version)'"})
    void aJavaThatIsTooOldIsNamed(String says, String expected) throws IOException, InterruptedException {
        play("java", "echo '" + says + "' >&2");
        Program.Result result = shell(Map.of("SIMPLERAY_INSTALL", "no"), "unset JAVA_HOME; need_jdk 16 'no JDK'");

        assertThat(result.err()).isEqualTo("simpleray: no JDK" + String.format(expected, bin + "/java")
            + ": install it (Debian: apt-get install openjdk-17-jdk)\n");
        assertThat(result.exitCode()).isEqualTo(INTERNAL);
    }

    @Test
    void aHomeThatIsTooOldIsNamed() throws IOException, InterruptedException {
        Path home = folder.resolve("jdk-11");
        Files.createDirectories(home.resolve("bin"));
        LauncherTest.write(home.resolve("bin/java"), "#!/bin/sh\n");
        Files.writeString(home.resolve("release"), "JAVA_VERSION=\"11.0.2\"\n");

        assertThat(shell(Map.of("JAVA_HOME", home.toString()), "old_java").text()).isEqualTo(" (" + home + "/bin/java is Java 11)");
    }

    /** {@return what was installed} */
    private List<String> installed() throws IOException {
        Path log = folder.resolve("apt.log");
        String option = " install --no-install-recommends ";
        return !Files.exists(log) ? List.of() : Files.readAllLines(log).stream().filter(line -> line.contains(option))
            .map(line -> line.substring(line.indexOf(option) + option.length())).toList();
    }

    /** {@return the result of commands, without a terminal, after setup.sh} */
    private Program.Result shell(Map<String, String> environment, String commands) throws IOException, InterruptedException {
        return finish(environment, List.of("/bin/sh", "-c", sourced(commands)), "");
    }

    /** {@return what commands write, after setup.sh, on a terminal on which is typed} */
    private String onTerminal(Map<String, String> environment, String commands, String typed) throws IOException, InterruptedException {
        assumeTrue(Files.isExecutable(Path.of("/usr/bin/script")), "no script of util-linux");
        Program.Result result = finish(environment, List.of("/usr/bin/script", "-qec", sourced(commands), "/dev/null"), typed);
        return new String(result.out(), StandardCharsets.UTF_8);
    }

    private static String sourced(String commands) {
        return "me=simpleray; root=$PWD; . gradle/setup.sh; " + commands;
    }

    private Program.Result finish(Map<String, String> environment, List<String> line, String typed)
            throws IOException, InterruptedException {
        ProcessBuilder builder = checkout.with(environment);
        builder.command(line).directory(checkout.root.toFile());
        builder.environment().putAll(Map.of("PATH", bin.toString(), "SHELL", "/bin/sh", "LC_ALL", "C.UTF-8"));
        return Program.finish(builder.start(), typed.getBytes(StandardCharsets.UTF_8));
    }
}
