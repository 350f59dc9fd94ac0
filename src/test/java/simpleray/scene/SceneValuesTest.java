package simpleray.scene;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import simpleray.text.SceneFormatException;
import simpleray.text.SourceSpan;
import simpleray.text.SourceValue;
import simpleray.text.SourceValues;

/** What a reader says that the values of a scene's text are. */
class SceneValuesTest {
    private static final Path FOLDER = Path.of(System.getProperty("simpleray.scenes"));
    private static final Pattern NUMBER = Pattern.compile("(?<!\\S)[-+.]?[0-9]\\S*");
    private static final String TEXT = "2\n0 0 1 -2  1.5  .1 .2 .3  .4 .5 .6  .7 .8 .9 8\n"
        + "1 0 1 0 2  .1 .2 .3  .4 .5 .6  .7 .8 .9 8 mirror .11 .12 .13\n.01 .02 .03\n1\n0 1 1 1  5 6 7\nbackground 0 .55 1\n";

    static List<Path> scenes() throws IOException {
        try (Stream<Path> files = Files.list(FOLDER)) {
            return files.filter(file -> file.toString().endsWith(".scene")).sorted().collect(Collectors.toList());
        }
    }

    @ParameterizedTest
    @MethodSource("scenes")
    void everyNumberOfASampleSceneHasAName(Path scene) throws IOException {
        byte[] bytes = Files.readAllBytes(scene);
        String text = new String(bytes, StandardCharsets.ISO_8859_1);
        String bare = Pattern.compile("(?m)#.*|^(number|light) .*").matcher(text).replaceAll(comment -> " ".repeat(comment.group().length()));
        List<SourceSpan> numbers = NUMBER.matcher(bare).results().map(found -> new SourceSpan(found.start(), found.end())).toList();
        SourceValues values = new SourceValues();
        SceneFile.read(new ByteArrayInputStream(bytes), scene, Reach.FOLDER, values);

        List<SourceValue> named = values.all().stream().filter(value -> value.type() != SourceValue.Type.WORD).toList();
        assertThat(named.stream().map(SourceValue::span)).containsExactlyElementsOf(numbers);
        assertThat(named).allSatisfy(value -> assertThat(value.name()).isNotBlank().isNotEqualTo("a number").isNotEqualTo("an integer"));
    }

    @Test
    void namesAreTheReadersOwn() throws IOException {
        SourceValues values = new SourceValues();
        read(TEXT, values);

        String kinds = " (" + ObjectKind.TABLE.list() + "; 2 objects announced)";
        assertThat(values.all().stream().map(value -> text(value.span()) + ": " + value)).contains(
            "2: the number of objects", "0: object 1 of 2, sphere: type" + kinds, "-2: object 1 of 2, sphere: centre z",
            "1.5: object 1 of 2, sphere: radius", ".6: object 1 of 2, sphere: diffuse blue", "1: object 2 of 2, plane: type" + kinds,
            "mirror: object 2 of 2, plane: keyword mirror", ".13: object 2 of 2, plane: mirrored blue", ".01: the scene's ambient red",
            "6: light 1 of 1, point light: origin y", "background: keyword background", ".55: background's green");
    }

    @Test
    void whatCouldBeReadBeforeAnErrorHasNames() {
        SourceValues values = new SourceValues();

        assertThatThrownBy(() -> read(TEXT.replace("1 0 1 0 2", "9 0 1 0 2"), values)).isInstanceOf(SceneFormatException.class);
        assertThat(values.all().get(1)).hasToString("object 1 of 2, sphere: type (" + ObjectKind.TABLE.list() + "; 2 objects announced)");
        assertThat(values.all()).hasSize(17);
    }

    private static void read(String text, SourceValues values) throws IOException {
        SceneFile.read(new ByteArrayInputStream(text.getBytes(StandardCharsets.UTF_8)), null, Reach.FOLDER, values);
    }

    private static String text(SourceSpan span) {
        return TEXT.substring((int) span.start(), (int) span.end());
    }
}
