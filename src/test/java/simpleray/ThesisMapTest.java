package simpleray;

import static org.assertj.core.api.Assertions.assertThat;

import java.lang.reflect.Constructor;
import java.lang.reflect.Field;
import java.lang.reflect.Member;
import java.lang.reflect.Method;
import java.lang.reflect.Modifier;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** Every class, constructor, method and field of the thesis's chapter 5 is in the program, as docs/thesis-map.md says. */
class ThesisMapTest {
    private static final int CONSTRUCTORS_AND_METHODS = 136;
    private static final int FIELDS = 24;
    private static final ThesisMap MAP = ThesisMap.read();
    private static final Pattern FIELD = Pattern.compile("(\\S+) (\\w+)");
    private static final Pattern CALL = Pattern.compile("(static |abstract |)(?:(\\S+) )?(\\w+)\\((.*)\\)");

    @Test
    void theThesisSixteenClassesAreThereInItsOrder() {
        assertThat(MAP.classes().keySet()).containsExactly("SimpleCamera", "Vector", "Colour", "Sphere", "DirectionalLight", "SimpleRay",
            "Light", "Material", "SceneReader", "SceneWriter", "Scene", "Point", "PointLight", "Object", "Plane", "Ray");
        assertThat(MAP.classes().values()).allMatch(type -> Modifier.isPublic(type.getModifiers()));
    }

    @Test
    void noMemberIsLeftOut() {
        assertThat(MAP.rows()).filteredOn(row -> !row.kind().equals("field")).hasSize(CONSTRUCTORS_AND_METHODS);
        assertThat(MAP.rows()).filteredOn(row -> row.kind().equals("field")).hasSize(FIELDS);
        assertThat(MAP.rows()).extracting(row -> row.type() + ": " + row.here()).doesNotHaveDuplicates();
        assertThat(MAP.text()).contains(
            "16 classes with " + CONSTRUCTORS_AND_METHODS + " constructors and methods and " + FIELDS + " fields");
    }

    @Test
    void membersAreCountedFromOneUnderTheirOwnClass() {
        Map<String, Integer> last = new HashMap<>();
        assertThat(MAP.rows()).allSatisfy(row -> {
            assertThat(row.type()).isEqualTo(row.section());
            assertThat(row.number()).isEqualTo(last.merge(row.type() + ' ' + row.kind(), 1, Integer::sum));
        });
    }

    static List<ThesisMap.Row> rows() {
        return MAP.rows();
    }

    @ParameterizedTest
    @MethodSource("rows")
    void theMemberIsInTheProgram(ThesisMap.Row row) throws ReflectiveOperationException {
        Class<?> type = MAP.classes().get(row.section());
        if (row.kind().equals("field")) {
            Matcher here = matched(FIELD, row.here());
            Field field = type.getDeclaredField(here.group(2));
            assertModifiers(field, "");
            assertThat(field.getType()).isEqualTo(MAP.type(here.group(1)));
            return;
        }
        Matcher here = matched(CALL, row.here());
        Class<?>[] parameters = Stream.of(here.group(4).split(", ")).filter(name -> !name.isEmpty()).map(MAP::type)
            .toArray(Class<?>[]::new);
        if (row.kind().equals("constructor")) {
            Constructor<?> constructor = type.getDeclaredConstructor(parameters);
            assertModifiers(constructor, here.group(1));
            assertThat(here.group(2)).as("return type").isNull();
            assertThat(here.group(3)).isEqualTo(type.getSimpleName());
        } else {
            Method method = type.getDeclaredMethod(here.group(3), parameters);
            assertModifiers(method, here.group(1));
            assertThat(method.getReturnType()).isEqualTo(MAP.type(here.group(2)));
        }
    }

    @ParameterizedTest
    @MethodSource("rows")
    void theSignatureIsThatOfTheThesisButForStaticAndInitials(ThesisMap.Row row) {
        String printed = row.printed();
        String expected = row.kind().equals("field")
            ? printed.replaceFirst("(\\w+) (\\w)", "$1 " + initial(printed.split(" ")[1]))
            : printed.replace("Void Set(", "void set(").replaceAll("(\\S+) \\w+(?=[,)])", "$1");

        assertThat(row.here().replace("static ", "")).isEqualTo(expected);
    }

    private static String initial(String name) {
        return name.substring(0, 1).toLowerCase(Locale.ROOT);
    }

    private static void assertModifiers(Member member, String expected) {
        int modifiers = member.getModifiers();
        assertThat(Modifier.isPublic(modifiers)).as("public").isTrue();
        assertThat(Modifier.isStatic(modifiers)).as("static").isEqualTo(expected.equals("static "));
        assertThat(Modifier.isAbstract(modifiers)).as("abstract").isEqualTo(expected.equals("abstract "));
    }

    private static Matcher matched(Pattern pattern, String text) {
        Matcher matcher = pattern.matcher(text);
        assertThat(matcher.matches()).as(text).isTrue();
        return matcher;
    }
}
