package simpleray.cli;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.function.Predicate;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import simpleray.Project;

/** Progress on a terminal, which {@code script} of util-linux makes. */
@Timeout(60)
class TerminalTest {
    /** A rendering that no test waits for. */
    private static final String LONG = "--size 100x60000 --samples 4";
    private static final Pattern STATE = Pattern.compile("\r([^\r\u001B]*)\u001B\\[J\r");
    private static final int ENOUGH = 3;                      // states of the bar

    @TempDir
    Path folder;

    @BeforeEach
    void findScript() throws IOException {
        assumeTrue(Files.isExecutable(Path.of("/usr/bin/script")) && System.getProperty("os.name").equals("Linux"),
            "no script of util-linux");
        Files.copy(Project.scene("thesis"), folder.resolve("thesis.scene"));
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 20, 80})
    void theBarFitsTheTerminal(int columns) throws IOException {
        String out = terminal("TERM=xterm; stty cols " + columns + "; " + render(LONG), said -> states(said).size() >= ENOUGH);

        assertThat(states(out)).hasSizeGreaterThanOrEqualTo(ENOUGH).allSatisfy(state -> assertThat(state).hasSizeLessThan(columns));
        assertThat(states(out).get(0).contains("%")).isEqualTo(columns > 1);
    }

    @Test
    void theBarFitsWhenTheTerminalBecomesNarrower() throws IOException {
        String out = terminal("TERM=xterm; stty cols 100; " + render(LONG)
            + " & while [ ! -e shown ]; do sleep 0.1; done; stty cols 30; wait", said -> {
                if (states(said).size() >= ENOUGH) {
                    touch(folder.resolve("shown"));
                }
                return states(said).stream().anyMatch(state -> state.length() < 30);
            });

        assertThat(states(out).get(0)).contains(" of 60000 rows").hasSizeGreaterThan(60);
        assertThat(states(out).get(states(out).size() - 1)).matches("\\[-+] {3}\\d %(, \\d+ s left)?").hasSize(29);
    }

    @ParameterizedTest
    @ValueSource(strings = {"TERM=dumb", "unset TERM", "TERM=xterm NO_COLOR=1; export NO_COLOR"})
    void aTerminalThatIsToBePlainGetsWholeLines(String setting) throws IOException {
        String out = terminal(setting + "; " + render("--size 20x40"), said -> false).replace("\r\n", "\n");

        assertThat(out).doesNotContain("\u001B", "\r");
        assertThat(out.lines()).hasSize(11).allMatch(line -> line.matches(" *\\d+ %, \\d+ of 40 rows, .* left|thesis.png: 20x40, .*"));
    }

    private static List<String> states(String out) {
        return STATE.matcher(out).results().map(state -> state.group(1)).collect(Collectors.toList());
    }

    private static String render(String options) {
        return System.getProperty("java.home") + "/bin/java -jar " + Project.jar() + " render thesis.scene -o thesis.png " + options;
    }

    private static void touch(Path file) {
        try {
            Files.write(file, new byte[0]);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    /** {@return what commands write to a terminal until it is enough, or until their end} */
    private String terminal(String commands, Predicate<String> enough) throws IOException {
        ProcessBuilder builder = new ProcessBuilder("script", "-qfec", commands, "/dev/null").directory(folder.toFile());
        builder.environment().keySet().removeAll(List.of("JAVA_TOOL_OPTIONS", "_JAVA_OPTIONS", "JDK_JAVA_OPTIONS", "NO_COLOR", "COLUMNS"));
        builder.environment().put("SHELL", "/bin/sh");
        Process script = builder.start();
        StringBuilder said = new StringBuilder();
        try (InputStream in = script.getInputStream()) {
            byte[] bytes = new byte[8192];
            for (int length = in.read(bytes); length > 0; length = in.read(bytes)) {
                said.append(new String(bytes, 0, length, StandardCharsets.ISO_8859_1));
                if (enough.test(said.toString())) {
                    break;
                }
            }
        } finally {
            script.descendants().forEach(ProcessHandle::destroyForcibly);
            script.destroyForcibly();
        }
        return said.toString();
    }
}
