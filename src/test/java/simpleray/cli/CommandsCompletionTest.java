package simpleray.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** The script that {@code generate-completion} prints, as bash understands it. */
class CommandsCompletionTest {
    @TempDir
    Path folder;
    private Path script;

    @BeforeEach
    void writeScript() throws IOException {
        Program.Result result = InProcess.run("generate-completion");
        assertThat(result.exitCode()).isZero();
        assertThat(result.err()).isEmpty();
        script = Files.write(folder.resolve("completion.bash"), result.out());
    }

    @Test
    void theScriptIsGoodBash() throws IOException, InterruptedException {
        assertThat(bash("bash -n completion.bash")).isEmpty();
    }

    @ParameterizedTest
    @CsvSource({
        "'render a.scene --stage ', 'original lighting final ambient diffuse specular normals depth objects bounces shadows'",
        "'view --stage ', 'original lighting final ambient diffuse specular normals depth objects bounces shadows'",
        "'render --stage di', diffuse",
        "'explain --format ', 'text json'",
        "'render --progress ', 'auto bar plain openjd none'",
        "'ren', render",
        "'render --thr', --threads"})
    void bashOffers(String typed, String offered) throws IOException, InterruptedException {
        String[] words = ("simpleray " + typed).split(" ", -1);
        StringBuilder quoted = new StringBuilder();
        Arrays.stream(words).forEach(word -> quoted.append('\'').append(word).append("' "));

        // what bash does at a tab; compopt would complain that it is not bash who does it
        int last = words.length - 1;
        String completed = bash(". ./completion.bash; compopt() { :; }; "
            + "COMP_WORDS=(" + quoted + "); COMP_CWORD=" + last + "; COMP_LINE='simpleray " + typed + "'; COMP_POINT=${#COMP_LINE}; "
            + "$(complete -p simpleray | sed 's/.*-F \\([^ ]*\\).*/\\1/') simpleray '" + words[last] + "'; echo \"${COMPREPLY[*]}\"");

        assertThat(completed.strip().split("\\s+")).containsExactlyInAnyOrder(offered.split(" "));
    }

    private String bash(String commands) throws IOException, InterruptedException {
        Process process = new ProcessBuilder("bash", "--norc", "-c", commands).directory(folder.toFile()).start();
        Program.Result result = Program.finish(process, new byte[0]);
        assertThat(result.err()).isEmpty();
        assertThat(result.exitCode()).isZero();
        return result.text();
    }
}
