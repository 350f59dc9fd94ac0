package simpleray.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Decimal commas, a dotless i and other digits: pictures, texts and options are the same wherever a computer stands. */
class LocalesTest {
    private static final Locale DEFAULT = Locale.getDefault();
    private static final String SCENE = "2\n0 0 0.5 -1e0 .8  0.9 0.3 0.2  0.9 0.3 0.2  0.5 0.5 0.5  20\n"
        + "1 0 1 0 -1.3  0.4 0.4 0.4  0.6 0.6 0.6  0 0 0  1.5\n0.2 0.2 0.2\n1\n0 0.9 0.9 0.8 -2 3 2\nresolution 8 6\n";
    private static final List<String> LINES = List.of("render SCENE -q -o OUT.png --camera 0.5,1.25,4,0,0,-1,40.5 --stage LIGHTING --samples 2",
        "export --pov SCENE -o OUT.pov", "convert SCENE OUT.scene", "still FILM --frame 1.5 -o OUT.still", "render FILM --frame 3 -o OUT.png", "print SCENE", "check SCENE", "check SCENE --errors json",
        "explain SCENE --pixel 4,3 --background 0.1,0.2,0.4", "explain SCENE --pixel 4,3 --format JSON --stage final",
        "print BAD", "check BAD --errors json", "render SCENE -o OUT.png --cop 2,5", "render SCENE -o OUT.png --size 0x0");

    @TempDir
    private Path folder;

    @AfterEach
    void theLocaleIsAsItWas() {
        Locale.setDefault(DEFAULT);
    }

    @ParameterizedTest
    @ValueSource(strings = {"de-DE", "tr-TR", "ar-EG-u-nu-arab"})
    void allThatIsWrittenIsTheSame(String tag) throws IOException {
        Files.writeString(folder.resolve("a.scene"), SCENE);
        Files.writeString(folder.resolve("film.scene"), SCENE + "frames 3 12.5\nkey 0 object 1 0 0 0\nkey 2 object 1 0 0.75 0\n");
        Files.writeString(folder.resolve("bad.scene"), SCENE.replace(".8", "0,8").replace("1.5", "-1.5"));
        Locale.setDefault(Locale.ROOT);
        List<String> expected = written();

        Locale.setDefault(Locale.forLanguageTag(tag));
        assertThat(written()).isEqualTo(expected);
    }

    /** {@return what each command line says and writes} */
    private List<String> written() throws IOException {
        List<String> all = new ArrayList<>();
        for (String line : LINES) {
            Program.Result result = InProcess.run(line.replace("SCENE", folder.resolve("a.scene").toString())
                .replace("FILM", folder.resolve("film.scene").toString()).replace("BAD", folder.resolve("bad.scene").toString()).replace("OUT", folder.resolve("out").toString()).split(" "));
            all.add(line + ": " + result.exitCode() + "\n" + result.text() + result.err());
        }
        for (String ending : List.of("png", "pov", "scene", "still")) {
            byte[] bytes = Files.readAllBytes(folder.resolve("out." + ending));
            assertThat(bytes).as(ending).isNotEmpty();
            all.add(ending + ": " + new String(bytes, StandardCharsets.ISO_8859_1));
        }
        return all;
    }
}
