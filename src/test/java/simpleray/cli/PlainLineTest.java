package simpleray.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayOutputStream;
import java.io.InputStream;
import java.io.OutputStream;
import java.io.PrintStream;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import picocli.CommandLine;
import picocli.CommandLine.Model.OptionSpec;

/** A plain line of render or view means the same without picocli, and whatever is not plain is picocli's. */
class PlainLineTest {
    private static final Map<String, String> VALUES = Map.ofEntries(Map.entry("--output", "b.png"), Map.entry("--size", "64X48"),
        Map.entry("--depth", "3"), Map.entry("--samples", "adaptive"), Map.entry("--cop", "2.5"), Map.entry("--window", "-1,1,-1,1"),
        Map.entry("--camera", "3,2,5,0,0,0,40"), Map.entry("--parallel", "3,2,5,0,0,0,4"), Map.entry("--up", "0,1,1"),
        Map.entry("--background", "0.1,0.2,0.4"), Map.entry("--stage", "Lighting"),
        Map.entry("--threads", "2"), Map.entry("--progress", "plain"), Map.entry("--accel", "None"), Map.entry("--stats", "json"),
        Map.entry("--frame", "1.5"), Map.entry("--region", "8,0,16,9"), Map.entry("--band", "2/3"), Map.entry("--skip-done", ""), Map.entry("--quiet", ""),
        Map.entry("--checkpoint", "c.part"), Map.entry("--resume", ""),
        Map.entry("--restart", ""), Map.entry("--allow-outside", ""), Map.entry("--look", "Dark"));
    private final Main main = new Main(InputStream.nullInputStream(), OutputStream.nullOutputStream(),
        new PrintStream(new ByteArrayOutputStream()));

    @ParameterizedTest
    @ValueSource(strings = {
        "render a.scene -o b.png",
        "render -q -o - -",
        "render --output b.png --size 640x480 a.scene --quiet",
        "render a.scene -o b.png --depth 0 --samples 4 --cop 3 --background 0,0.5,1 --stage final --threads 1 --progress none",
        "render a.scene -o b.png --camera 1,2,3,0,0,0,50 --stage DIFFUSE",
        "render a.scene -o b.png --cop -1 --window -1,1,-2,2",
        "render a.scene -o b.png --depth 2000 --threads 0 --samples 99",
        "view",
        "view a.scene",
        "view scene",
        "view -",
        "view a.scene --size 640x480 --look dark --allow-outside --depth 3",
        "view --stage lighting --look SYSTEM"})
    void aPlainLineIsReadAsPicocliReadsIt(String line) {
        assertRead(line.split(" "), line.split(" "));
    }

    @Test
    void aFileAloneOrNothingIsALineOfView() {
        assertRead(new String[0], "view");
        assertRead(new String[] {"a.scene"}, "view", "a.scene");
        assertRead(new String[] {"./check", "--size", "64x48"}, "view", "./check", "--size", "64x48");
        assertThat(new Commands(main).line("").getSubcommands().keySet()).as("no command is taken for a file")
            .noneMatch(command -> command.contains("."));
    }

    @ParameterizedTest
    @ValueSource(strings = {"render", "view"})
    void everyOptionMayStandInAPlainLine(String command) {
        List<OptionSpec> options = new Commands(main).line(command).getSubcommands().get(command).getCommandSpec().options().stream()
            .filter(option -> !option.usageHelp() && !option.versionHelp()).collect(Collectors.toList());
        assertThat(options).hasSizeGreaterThan(8).extracting(OptionSpec::longestName).isSubsetOf(VALUES.keySet());

        for (OptionSpec option : options) {
            for (String name : option.names()) {
                List<String> line = new ArrayList<>(List.of(command, "a.scene", name));
                if (!VALUES.get(option.longestName()).isEmpty()) {
                    line.add(VALUES.get(option.longestName()));
                }
                if (command.equals("render") && !option.longestName().equals("--output")) {
                    line.addAll(List.of("-o", "a.png"));
                }
                assertRead(line.toArray(new String[0]), line.toArray(new String[0]));
            }
        }
    }

    @ParameterizedTest
    @ValueSource(strings = {"render", "print a.scene", "check", "a", "--help", "-V", "a.scene -q", "view a.scene b.scene",
        "view --look pink", "view --threads 2", "view --help", "render --help", "render a.scene", "render -o b.png",
        "render a.scene -o",
        "render a.scene -o b.png --depth", "render a.scene -o b.png --depth many", "render a.scene -o b.png --size 5",
        "render a.scene -o b.png --stage first", "render a.scene -o b.png --depth=3", "render a.scene -ob.png",
        "render a.scene -o b.png --depth 1 --depth 1", "render a.scene -o b.png --output c.png", "render a.scene -o b.png -q --quiet",
        "render a.scene c.scene -o b.png", "render -5 -o b.png", "render a.scene -o b.png --samples -x", "render a.scene -o -q",
        "render -- a.scene -o b.png",
        "render a.scene -o b.png --colour red"})
    void whatIsNotPlainIsLeftToPicocli(String line) {
        assertThat(PlainLine.read(main, line.split(" "))).isNull();
    }

    private void assertRead(String[] args, String... byPicocli) {
        CommandLine line = new Commands(main).line(byPicocli[0]);
        line.parseArgs(byPicocli);
        PlainCommand expected = line.getSubcommands().get(byPicocli[0]).getCommand();
        assertThat(PlainLine.read(main, args)).as(String.join(" ", args)).isInstanceOf(expected.getClass()).usingRecursiveComparison()
            .ignoringFields("main", "start").isEqualTo(expected);
    }
}
