package simpleray;

import static com.tngtech.archunit.base.DescribedPredicate.not;
import static com.tngtech.archunit.core.domain.JavaClass.Predicates.assignableTo;
import static com.tngtech.archunit.core.domain.JavaClass.Predicates.resideInAPackage;
import static com.tngtech.archunit.core.domain.JavaClass.Predicates.resideInAnyPackage;
import static com.tngtech.archunit.core.domain.JavaClass.Predicates.type;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.classes;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.noClasses;
import static java.util.Map.entry;
import static org.assertj.core.api.Assertions.assertThat;

import com.tngtech.archunit.core.domain.JavaClass;
import com.tngtech.archunit.core.domain.JavaClasses;
import com.tngtech.archunit.core.importer.ClassFileImporter;
import java.awt.Component;
import java.awt.Rectangle;
import java.io.IOException;
import java.nio.file.Files;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import simpleray.cli.Main;

/** The rooms of docs/architecture.md, and what only one of them may do. */
class RoomsTest {
    /** The floor of each room; rooms of one floor do not know each other. */
    private static final Map<String, Integer> FLOORS = new TreeMap<>(Map.ofEntries(entry("simpleray.io", 0), entry("simpleray.text", 0),
        entry("simpleray.math", 1), entry("simpleray.image", 1), entry("simpleray.image.png", 2), entry("simpleray.accel", 2),
        entry("simpleray.scene", 3), entry("simpleray.trace", 4), entry("simpleray.pov", 4), entry("simpleray.convert", 4),
        entry("simpleray.render", 5), entry("simpleray.rays", 6), entry("simpleray.film", 6),
        entry("simpleray.ui.widget", 7), entry("simpleray.ui.file", 7), entry("simpleray.ui.picture", 8),
        entry("simpleray.ui.editor", 9), entry("simpleray.ui.compare", 9), entry("simpleray.ui.inspect", 9),
        entry("simpleray.ui.desktop", 9), entry("simpleray.ui.film", 9), entry("simpleray.ui", 10), entry("simpleray.cli", 11)));
    private static final String SCENE = "simpleray.scene";
    private static final String UI = "simpleray.ui..";
    private static final String CLI = "simpleray.cli";
    private static final String IMAGE = "simpleray.image";
    private static final String RAYS = "simpleray.rays";
    private static final String FILM = "simpleray.film";
    private static final String PNG = "simpleray.image.png";
    private static final JavaClasses PROGRAM =
        new ClassFileImporter().importUrl(Main.class.getProtectionDomain().getCodeSource().getLocation());

    @Test
    void everyClassIsInARoom() {
        classes().should().resideInAnyPackage(FLOORS.keySet().toArray(new String[0])).check(PROGRAM);
    }

    static List<String> rooms() {
        return List.copyOf(FLOORS.keySet());
    }

    @ParameterizedTest
    @MethodSource("rooms")
    void aRoomUsesOnlyTheFloorsBelow(String room) {
        noClasses().that().resideInAPackage(room).should().dependOnClassesThat().resideInAnyPackage(closedTo(room).toArray(new String[0]))
            .allowEmptyShould(true).check(PROGRAM);
    }

    /** Classes that the compiler leaves no trace of, such as those of constants, are seen in the sources alone. */
    @ParameterizedTest
    @MethodSource("rooms")
    void aRoomImportsOnlyFromTheFloorsBelow(String room) {
        String folder = "/" + room.replace('.', '/');
        assertThat(SourceFile.allOf("src/main/java")).filteredOn(file -> file.folder().endsWith(folder))
            .allSatisfy(file -> assertThat(file.importedPackages()).as(file.name()).noneMatch(closedTo(room)::contains));
    }

    private static List<String> closedTo(String room) {
        return FLOORS.keySet().stream().filter(other -> !other.equals(room) && FLOORS.get(other) >= FLOORS.get(room))
            .collect(Collectors.toList());
    }

    /** Nor text, though that lies below. */
    @Test
    void boxesAndRaysKnowNothingButMath() {
        noClasses().that().resideInAPackage("simpleray.accel").should().dependOnClassesThat(
            resideInAPackage("simpleray..").and(not(resideInAnyPackage("simpleray.accel", "simpleray.math")))).check(PROGRAM);
    }

    @Test
    void onlyTheWindowKnowsSwing() {
        noClasses().that().resideOutsideOfPackages(UI, IMAGE, PNG, RAYS, FILM).should().dependOnClassesThat()
            .resideInAnyPackage("java.awt..", "javax.swing..", "javax.accessibility..", "javax.imageio..", "com.formdev..",
                "org.fife..").check(PROGRAM);
        noClasses().that().resideInAnyPackage(IMAGE, PNG, FILM).should().dependOnClassesThat(
            resideInAnyPackage("java.awt..", "javax.swing..", "javax.accessibility..", "com.formdev..", "org.fife..")
                .and(not(resideInAPackage("java.awt.image.."))).and(not(type(Rectangle.class)))).check(PROGRAM);
        noClasses().that().resideInAPackage(RAYS).should().dependOnClassesThat(resideInAnyPackage("java.awt.event..", "javax.swing..")
            .or(assignableTo(Component.class))).check(PROGRAM);
    }

    /** All other parts of the window know it as an interface. */
    @Test
    void onlyClassesThatOpenTheWindowKnowItsFrame() {
        noClasses().that().haveNameNotMatching("simpleray\\.ui\\.(Viewer|ViewerFrame|CdsTrainingRun)(\\$.*)?")
            .should().dependOnClassesThat().haveFullyQualifiedName("simpleray.ui.ViewerFrame").check(PROGRAM);
    }

    @Test
    void onlyTheCommandLineKnowsPicocli() {
        noClasses().that().resideOutsideOfPackage(CLI).should().dependOnClassesThat().resideInAPackage("picocli..").check(PROGRAM);
    }

    @Test
    void nothingElseIsUsedFromOutsideTheJdk() {
        noClasses().should().dependOnClassesThat(not(resideInAnyPackage("simpleray..", "java..", "javax..", "picocli..", "com.formdev..",
            "org.fife..")).and(not(resideInAPackage("")))).check(PROGRAM); // "": int and the like
    }

    @Test
    void onlyMainEndsTheProgram() {
        noClasses().that().doNotBelongToAnyOf(Main.class).should().callMethod(System.class, "exit", int.class)
            .orShould().callMethod(Runtime.class, "exit", int.class).orShould().callMethod(Runtime.class, "halt", int.class).check(PROGRAM);
    }

    @Test
    void onlyMainTouchesTheStandardStreams() {
        noClasses().that().doNotBelongToAnyOf(Main.class).should().accessField(System.class, "out")
            .orShould().accessField(System.class, "err").orShould().accessField(System.class, "in")
            .orShould().callMethod(Throwable.class, "printStackTrace").check(PROGRAM);
    }

    @Test
    void thePageOnArchitectureHasTheSameFloors() throws IOException {
        Pattern row = Pattern.compile("\\| (\\d+) \\| `(simpleray\\.[\\w.]+)` \\|.*");
        Map<String, Integer> told = Files.readAllLines(Project.root().resolve("docs/architecture.md")).stream()
            .map(row::matcher).filter(Matcher::matches).collect(Collectors.toMap(m -> m.group(2), m -> Integer.valueOf(m.group(1))));

        assertThat(told).isNotEmpty().allSatisfy((room, floor) -> assertThat(floor).as(room).isEqualTo(FLOORS.get(room)));
        assertThat(told.keySet()).isEqualTo(PROGRAM.stream().map(JavaClass::getPackageName).collect(Collectors.toSet()));
    }
}
