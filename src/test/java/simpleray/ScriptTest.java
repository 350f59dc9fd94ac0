package simpleray;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.channels.FileChannel;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.nio.file.attribute.FileTime;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import simpleray.cli.Program;

/** The script {@code simpleray} of a checkout whose jar is there: how it starts the program, and the class archive that it makes for it. */
class ScriptTest {
    @TempDir
    Path folder;
    private Checkout made;
    private Path checkout;
    private Path jar;

    @BeforeEach
    void makeCheckout() throws IOException {
        assumeTrue(Files.isExecutable(Path.of("/bin/sh")), "no shell");
        made = new Checkout(folder.resolve("checkout"));
        checkout = made.root;
        jar = made.jar;
    }

    @Test
    void theFirstStartMakesAnArchiveAndTheSecondUsesIt() throws IOException, InterruptedException {
        byte[] picture = picture();
        assertThat(picture).isEqualTo(byTheJar());
        List<Path> archives = archives();
        assertThat(archives).hasSize(1);
        FileTime made = Files.getLastModifiedTime(archives.get(0));

        Program.Result second = script("-Xlog:class+load:stderr", "check", scene());

        assertThat(second.err()).contains("simpleray.cli.Main source: shared objects file");
        assertThat(archives()).isEqualTo(archives);
        assertThat(Files.getLastModifiedTime(archives.get(0))).isEqualTo(made);
    }

    @Test
    void anArchiveWithoutItsEndIsMadeAnew() throws IOException, InterruptedException {
        byte[] picture = picture();
        Path archive = archives().get(0);
        long size = Files.size(archive);
        archive.toFile().setWritable(true);
        try (FileChannel channel = FileChannel.open(archive, StandardOpenOption.WRITE)) {
            channel.truncate(size / 2);
        }

        assertThat(picture()).isEqualTo(picture);

        assertThat(archives()).allSatisfy(whole -> assertThat(whole.getFileName()).hasToString(Files.size(whole) + ".jsa"));
    }

    @Test
    void anArchiveOfAnOlderJarIsMadeAnew() throws IOException, InterruptedException {
        byte[] picture = picture();
        FileTime old = FileTime.fromMillis(Files.getLastModifiedTime(jar).toMillis() - 10_000);
        Files.setLastModifiedTime(archives().get(0), old);

        assertThat(picture()).isEqualTo(picture);

        assertThat(Files.getLastModifiedTime(archives().get(0))).isGreaterThan(old);
    }

    @Test
    void anArchiveThatIsNotOfThisJarIsPassedOverSilently() throws IOException, InterruptedException {
        byte[] picture = picture();
        Files.setLastModifiedTime(jar, FileTime.fromMillis(Files.getLastModifiedTime(jar).toMillis() - 10_000));
        Files.setLastModifiedTime(checkout.resolve("src/main"), FileTime.fromMillis(0));
        for (String file : List.of("build.gradle", "settings.gradle")) {
            Files.setLastModifiedTime(checkout.resolve(file), FileTime.fromMillis(0));
        }

        assertThat(picture()).isEqualTo(picture);
    }

    @Test
    void whereNoArchiveCanBeMadeTheProgramStartsAllTheSame() throws IOException, InterruptedException {
        Files.createFile(checkout.resolve("build/cds"));      // no folder can be made there

        assertThat(picture()).isEqualTo(byTheJar());
    }

    @Test
    void whenTheArchiveCannotBeMadeThatIsTriedOnce() throws IOException, InterruptedException {
        Files.delete(checkout.resolve("scenes/thesis-as-printed.scene")); // which is rendered for it

        assertThat(script("", "--version").exitCode()).isZero();

        assertThat(archives()).singleElement().satisfies(empty -> assertThat(empty).isEmptyFile());
        FileTime made = Files.getLastModifiedTime(archives().get(0));
        assertThat(script("", "--version").exitCode()).isZero();
        assertThat(Files.getLastModifiedTime(archives().get(0))).isEqualTo(made);
    }

    @Test
    void theUsersOptionsComeLast() throws IOException, InterruptedException {
        Program.Result result = script("-Xmx32m", "render", scene(), "-o", "-", "--size", "9000x9000");

        assertThat(result.err()).contains("Java has").contains("give java more by -Xmx");
        assertThat(result.exitCode()).isEqualTo(71);
    }

    @Test
    void aUserMaySeeToTheArchive() throws IOException, InterruptedException {
        assertThat(script("-Xshare:off", "--version").text()).startsWith("SimpleRay ");

        assertThat(checkout.resolve("build/cds")).doesNotExist();
    }

    @Test
    void theScriptIsFoundThroughLinks() throws IOException, InterruptedException {
        Files.move(checkout, folder.resolve("a checkout"));
        Path bin = Files.createDirectory(folder.resolve("bin"));
        Files.createSymbolicLink(bin.resolve("one"), Path.of("../a checkout/simpleray"));
        Files.createSymbolicLink(folder.resolve("two"), bin.resolve("one"));

        assertThat(made.run(folder.resolve("two"), "", "--version").text()).startsWith("SimpleRay ");
    }

    private byte[] picture() throws IOException, InterruptedException {
        Program.Result result = script("", "render", scene(), "-o", "-", "--size", "60x45");
        assertThat(result.err()).matches("<stdout>: 60x45, .*\n");
        assertThat(result.exitCode()).isZero();
        return result.out();
    }

    private byte[] byTheJar() throws IOException, InterruptedException {
        return Program.run(folder, "render", scene(), "-o", "-", "--size", "60x45").out();
    }

    private static String scene() {
        return Project.scene("thesis").toString();
    }

    private Program.Result script(String options, String... args) throws IOException, InterruptedException {
        return made.run(options, args);
    }

    private List<Path> archives() {
        try (Stream<Path> files = Files.walk(checkout.resolve("build/cds"))) {
            return files.filter(Files::isRegularFile).collect(Collectors.toList());
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }
}
