package simpleray.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.lang.reflect.Field;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import simpleray.Project;

/** {@code --help}, {@code help} and {@code --version}: asked for, so on standard output and with exit code 0. */
class CommandsHelpTest {
    private static final int TERMINAL = 80;
    private static final List<String> COMMANDS = List.of("view", "render", "animate", "merge", "figures", "explain", "print", "check", "convert", "still",
        "import", "export", "job", "verify", "compare", "bench", "generate-completion");
    private static final String PICTURE_OPTIONS = "--size --depth --samples --cop --window --camera --background --allow-outside";

    @TempDir
    Path folder;

    @Test
    void theHelpNamesEveryCommandAndEveryExitCode() throws ReflectiveOperationException {
        String help = text("--help");

        assertThat(help).startsWith("SimpleRay: a text file of spheres, planes and lights becomes a picture.\n\n"
            + "Usage: simpleray SCENE [OPTIONS]\n       simpleray COMMAND ...\n");
        assertThat(COMMANDS).allSatisfy(command -> assertThat(help).contains("\n  " + command + " "));
        assertThat(help).contains("\n  help ");
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
        String page = Files.readString(Project.root().resolve("docs/reliability.md"));
        String table = page.substring(page.indexOf("| exit code |"));
        List<String> told = codes(row.matcher(table.substring(0, table.indexOf("\n\n"))));

        assertThat(told).hasSameSizeAs(codes);
        for (int i = 0; i < codes.size(); i++) {
            assertThat(told.get(i).replace("`", "")).startsWith(codes.get(i));
        }
    }

    private static List<String> codes(Matcher rows) {
        return rows.results().map(match -> match.group(1) + ' ' + match.group(2)).toList();
    }

    @ParameterizedTest
    @ValueSource(strings = {"view", "render", "animate", "merge", "figures", "explain", "print", "check", "convert", "still",
        "import", "export", "job", "verify", "compare", "bench",
        "generate-completion"})
    void aCommandHasAHelpOfItsOwn(String command) {
        assertThat(text(command, "--help")).startsWith("Usage: simpleray " + command + " ");
        assertThat(text("help", command)).isEqualTo(text(command, "--help"));
        assertThat(text(command, "-h")).isEqualTo(text(command, "--help"));
    }

    @ParameterizedTest
    @CsvSource({"view, --look",
        "render, -o --frame --region --band --skip-done --threads --accel --progress --stats -q --checkpoint --resume --restart",
        "animate, -o --frames --turntable --fps --stage --threads --accel --progress -q --resume --restart",
        "figures, -d --frame --sweep --threads --accel --progress -q", "explain, --frame --pixel --format --stage --accel -q"})
    void theHelpTellsEveryOptionOfACommandThatRenders(String command, String options) {
        String help = text(command, "--help");

        assertThat(List.of(PICTURE_OPTIONS.split(" "))).allSatisfy(option -> assertThat(help).containsPattern(pattern(option)));
        assertThat(List.of(options.split(" "))).allSatisfy(option -> assertThat(help).containsPattern(pattern(option)));
    }

    @Test
    void everyOptionThatThePagesNameIsInTheHelpOfACommand() throws IOException {
        String help = COMMANDS.stream().map(command -> text(command, "--help")).collect(Collectors.joining());
        Set<String> named = new TreeSet<>();
        for (Path page : Project.pages()) {
            Pattern.compile("simpleray.*? (--[a-z]+[-a-z]*)|`(--[a-z]+[-a-z]*)").matcher(Files.readString(page)).results()
                .forEach(match -> named.add(match.group(1) == null ? match.group(2) : match.group(1)));
        }

        assertThat(named).hasSizeGreaterThan(15).allSatisfy(option -> assertThat(help).containsPattern(pattern(option)));
    }

    private static String pattern(String option) {
        return "[ ,]" + option + "[\\[=,\\n ]";
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
        for (String command : COMMANDS) {
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
