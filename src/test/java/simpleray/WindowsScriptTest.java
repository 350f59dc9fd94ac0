package simpleray;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** The text of {@code simpleray.bat}, which only Windows can run. */
class WindowsScriptTest {
    private String text;

    @BeforeEach
    void read() throws IOException {
        text = Files.readString(Project.root().resolve("simpleray.bat"));
    }

    @Test
    void itsLinesEndAsWindowsWantsThem() {
        assertThat(text.split("(?<=\n)")).allMatch(line -> line.endsWith("\r\n"));
        assertThat(text).isASCII();
    }

    @Test
    void itStartsTheJarThatTheBuildMakes() {
        String jar = Project.root().relativize(Project.jar()).toString().replace('/', '\\');

        assertThat(text).contains("set \"jar=%~dp0" + jar + "\"\r\n", "if not exist \"%jar%\" goto nojar\r\n");
    }

    @Test
    void itPassesTheCommandLineAndTheExitCode() {
        assertThat(text).contains("\"%java%\" %options% %SIMPLERAY_OPTS% -jar \"%jar%\" %*\r\nset \"code=%ERRORLEVEL%\"\r\n",
            "exit /b %code%\r\n");
    }

    @Test
    void itGivesJavaTheOptionsThatTheOtherScriptGives() throws IOException {
        String script = Files.readString(Project.root().resolve("simpleray"));

        for (MatchResult option : Pattern.compile("-XX:[-+=\\w]+(?=[ \"\r])").matcher(text).results().toList()) {
            assertThat(script).contains(option.group());
        }
        assertThat(text).contains("-XX:-UsePerfData", "-XX:+UseSerialGC");
    }

    @Test
    void eachPlaceToGoToIsThereAndEndsWithACode() {
        for (String label : Pattern.compile("goto (\\w+)").matcher(text).results().map(m -> m.group(1)).distinct().toList()) {
            assertThat(text).containsPattern("\r\n:" + label + "\r\n>&2 echo simpleray: [^\r]+\r\nexit /b 70\r\n");
        }
    }
}
