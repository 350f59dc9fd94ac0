package simpleray;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Set;
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
}
