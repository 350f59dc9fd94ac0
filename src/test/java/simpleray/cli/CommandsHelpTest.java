package simpleray.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.lang.reflect.Field;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import simpleray.Project;

/** {@code --help}, {@code help} and {@code --version}: asked for, so on standard output and with exit code 0. */
class CommandsHelpTest {
    private static final int TERMINAL = 80;

    @TempDir
    Path folder;

    @Test
    void theHelpNamesEveryCommandAndEveryExitCode() throws ReflectiveOperationException {
        String help = text("--help");

        assertThat(help).startsWith("SimpleRay: a text file of spheres, planes and lights becomes a picture.\n\n"
            + "Usage: simpleray SCENE [OPTIONS]\n       simpleray COMMAND ...\n");
        for (String command : List.of("view", "render", "figures", "explain", "print", "check", "convert", "export",
            "verify", "compare", "bench", "generate-completion", "help")) {
            assertThat(help).contains("\n  " + command + " ");
        }
        List<String> codes = new ArrayList<>();
        for (Field code : ExitCode.class.getDeclaredFields()) {
            if (code.getType() == int.class && !code.isSynthetic()) {
                codes.add(code.get(null).toString());
            }
        }
        Matcher told = Pattern.compile("^  (\\d+) +\\S", Pattern.MULTILINE).matcher(help);
        assertThat(told.results().map(match -> match.group(1))).containsExactlyElementsOf(codes);
    }

    @Test
    void thePageTellsTheSameOfEveryExitCodeAndMoreOfSome() throws IOException {
        Pattern row = Pattern.compile("^(?:  |\\| )(\\d+) [ |]*(\\S.*?)(?: \\|)?$", Pattern.MULTILINE);
        String help = text("--help");
        List<String> codes = codes(row.matcher(help.substring(help.indexOf("Exit codes:"))));
        String page = Files.readString(Project.root().resolve("README.md"));
        List<String> told = codes(row.matcher(page.substring(page.indexOf("| exit code |"))));

        assertThat(told).hasSameSizeAs(codes);
        for (int i = 0; i < codes.size(); i++) {
            assertThat(told.get(i).replace("`", "")).startsWith(codes.get(i));
        }
    }

    private static List<String> codes(Matcher rows) {
        return rows.results().map(match -> match.group(1) + ' ' + match.group(2)).toList();
    }

    @ParameterizedTest
    @ValueSource(strings = {"view", "render", "figures", "explain", "print", "check", "convert", "export", "verify", "compare", "bench",
        "generate-completion"})
    void aCommandHasAHelpOfItsOwn(String command) {
        assertThat(text(command, "--help")).startsWith("Usage: simpleray " + command + " ");
        assertThat(text("help", command)).isEqualTo(text(command, "--help"));
        assertThat(text(command, "-h")).isEqualTo(text(command, "--help"));
    }

    @ParameterizedTest
    @CsvSource({"view, 9", "render, 19"})
    void theHelpTellsEveryOptionOfThePage(String command, int most) throws IOException {
        // README's tables of options: the first is for view and render, the second for render alone
        Matcher options = Pattern.compile("^\\| `(?:-\\w, )?(-[-\\w]+)[^`]*` \\|", Pattern.MULTILINE)
            .matcher(Files.readString(Project.root().resolve("README.md")));
        List<String> told = options.results().map(match -> match.group(1)).limit(most).toList();

        assertThat(told).hasSize(most)
            .allSatisfy(option -> assertThat(text(command, "--help")).containsPattern("[ ,]" + option + "[=,\\n ]"));
    }

    @ParameterizedTest
    @ValueSource(strings = {"view", "render", "explain"})
    void theHelpNamesTheElevenStages(String command) {
        assertThat(text(command, "--help")).containsPattern(
            "--stage=STAGE +original, lighting, final, ambient, diffuse,\\s+specular, normals, depth, objects, bounces,\\s+shadows ");
    }

    @Test
    void theHelpOfViewNamesTheLooks() {
        assertThat(text("view", "--help")).containsPattern("--look=LOOK +light, dark, system: ");
    }

    @Test
    void theHelpFitsATerminal() {
        for (String command : List.of("view", "render", "print", "check", "convert", "figures", "explain", "export",
            "verify", "compare", "bench", "generate-completion")) {
            assertThat(text("help", command).lines()).allMatch(line -> line.length() <= TERMINAL);
        }
        assertThat(text("--help").lines()).allMatch(line -> line.length() <= TERMINAL);
    }

    @Test
    void theVersionIsThatOfTheBuildAndOfTheJava() throws IOException, InterruptedException {
        Matcher version = Pattern.compile("^version = '(.+)'$", Pattern.MULTILINE)
            .matcher(Files.readString(Project.root().resolve("build.gradle")));
        assertThat(version.find()).isTrue();

        Program.Result result = Program.run(folder, "--version");

        assertThat(result.text()).isEqualTo("SimpleRay " + version.group(1) + "\nJava " + System.getProperty("java.version") + ", "
            + System.getProperty("java.vm.name") + "\n");
        assertThat(result.err()).isEmpty();
        assertThat(result.exitCode()).isZero();
    }

    private static String text(String... args) {
        Program.Result result = InProcess.run(args);

        assertThat(result.err()).isEmpty();
        assertThat(result.exitCode()).isZero();
        return result.text();
    }
}
