package simpleray.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Standard streams that fail. */
class BrokenStreamsTest {
    @Test
    void standardInputThatCannotBeReadIs66() {
        InputStream broken = new InputStream() {
            @Override
            public int read() throws IOException {
                throw new IOException("unplugged");
            }
        };

        Program.Result result = InProcess.run(broken, OutputStream.nullOutputStream(), "print", "-");

        assertThat(result.err()).isEqualTo("simpleray: -: cannot be read: unplugged\n");
        assertThat(result.exitCode()).isEqualTo(ExitCode.NO_SCENE);
    }

    @Test
    void aFaultOfTheProgramItselfIs70WithATraceForItsAuthors() {
        InputStream faulty = new InputStream() {
            @Override
            public int read() {
                throw new IllegalStateException("a fault of the test");
            }
        };

        Program.Result result = InProcess.run(faulty, OutputStream.nullOutputStream(), "print", "-");

        assertThat(result.err()).startsWith("simpleray: internal error, which should not happen whatever the input: "
            + "java.lang.IllegalStateException: a fault of the test\n").contains("\n\tat simpleray.scene.SceneFile.read(");
        assertThat(result.exitCode()).isEqualTo(ExitCode.INTERNAL);
    }

    @ParameterizedTest
    @ValueSource(strings = {"print", "check"})
    void standardOutputThatCannotBeWrittenIs74(String command) {
        assertBroken("simpleray: standard output cannot be written: no paper\n", command, "-");
    }

    @ParameterizedTest
    @ValueSource(strings = {"--help", "--version", "help", "generate-completion", "render --help"})
    void helpThatCannotBeWrittenIs74(String line) {
        assertBroken("simpleray: standard output cannot be written\n", line.split(" "));
    }

    @Test
    void anErrorOfTheProgramItselfIs70Too() {
        InputStream faulty = new InputStream() {
            @Override
            public int read() {
                throw new StackOverflowError("a fault of the test");
            }
        };

        Program.Result result = InProcess.run(faulty, OutputStream.nullOutputStream(), "print", "-");

        assertThat(result.err()).startsWith("simpleray: internal error, which should not happen whatever the input: "
            + "java.lang.StackOverflowError: a fault of the test\n");
        assertThat(result.exitCode()).isEqualTo(ExitCode.INTERNAL);
    }

    @Test
    void aPictureThatCannotBeWrittenToStandardOutputIs74() {
        assertBroken("simpleray: the picture cannot be written to standard output: no paper\n", "render", "-", "-o", "-");
    }

    private static void assertBroken(String message, String... args) {
        OutputStream broken = new OutputStream() {
            @Override
            public void write(int b) throws IOException {
                throw new IOException("no paper");
            }
        };

        Program.Result result = InProcess.run(new ByteArrayInputStream(SmallScenes.GREY.getBytes(StandardCharsets.UTF_8)), broken, args);

        assertThat(result.err()).isEqualTo(message);
        assertThat(result.exitCode()).isEqualTo(ExitCode.WRITE_ERROR);
    }
}
