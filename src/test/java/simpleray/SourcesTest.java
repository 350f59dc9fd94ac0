package simpleray;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.util.List;
import java.util.Set;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;

/** Rules that hold for the text of every source. */
class SourcesTest {
    private static final List<SourceFile> MAIN = SourceFile.allOf("src/main/java");
    private static final List<SourceFile> ALL = SourceFile.allOf("src");

    @Test
    void nothingIsImportedByAsterisk() {
        assertThat(ALL).hasSizeGreaterThan(MAIN.size())
            .allSatisfy(file -> assertThat(file.imports()).as(file.name()).noneMatch(name -> name.endsWith("*")));
    }

    @Test
    void everyPackageSaysWhatItIsFor() {
        Set<String> folders = MAIN.stream().map(SourceFile::folder).collect(Collectors.toSet());
        Set<String> told = MAIN.stream().filter(file -> file.name().endsWith("/package-info.java"))
            .filter(file -> file.lines().stream().anyMatch(line -> line.startsWith("/**"))).map(SourceFile::folder)
            .collect(Collectors.toSet());

        assertThat(told).isEqualTo(folders);
    }

    /** Nor in two packages: a name alone says which class is meant. */
    @Test
    void noTopLevelClassNameOccursTwice() {
        assertThat(MAIN).extracting(SourceFile::className).filteredOn(name -> !name.equals("package-info")).doesNotHaveDuplicates();
    }

    /** The tables of docs/architecture.md under "Where is what" and "One tracer": questions and terms, each with its classes. */
    @Test
    void theGlossaryNamesClassesThatExist() throws IOException {
        String page = Files.readString(Project.root().resolve("docs/architecture.md"));
        Set<String> named = Pattern.compile("(?m)^\\|.*").matcher(page.substring(page.indexOf("## Where is what"), page.indexOf("## One run"))).results()
            .flatMap(row -> Pattern.compile("`([A-Z]\\w*)").matcher(row.group()).results()).map(name -> name.group(1))
            .collect(Collectors.toSet());

        assertThat(named).isNotEmpty().isSubsetOf(MAIN.stream().map(SourceFile::className).collect(Collectors.toSet()));
    }
}
