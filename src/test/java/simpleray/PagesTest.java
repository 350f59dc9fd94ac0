package simpleray;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

/** The pages of documentation: their links, and the classes and methods that they name. */
class PagesTest {
    private static final Pattern LINK = Pattern.compile("]\\(([^)\\s]+)\\)");
    private static final Pattern HEADING = Pattern.compile("^#+ (.+)$", Pattern.MULTILINE);
    private static final Pattern CODE = Pattern.compile("`([^`]+)`");
    /** A class, a test or record in it, and a method of either: each as far as it is named. */
    private static final Pattern NAME = Pattern.compile("([A-Z]\\w*[a-z]\\w*)(?:\\.(\\w+))?(?:\\(.*\\))?");

    static List<Path> pages() {
        return Project.pages();
    }

    @ParameterizedTest
    @MethodSource("pages")
    void everyLinkLeadsSomewhere(Path page) throws IOException {
        for (MatchResult link : LINK.matcher(Files.readString(page)).results().toList()) {
            String[] parts = link.group(1).split("#", 2);
            if (parts[0].contains("://")) {
                continue;
            }
            Path target = parts[0].isEmpty() ? page : page.resolveSibling(parts[0]).normalize();
            assertThat(target).as(link.group(1)).exists();
            if (parts.length == 2) {
                assertThat(anchors(Files.readString(target))).as(link.group(1)).contains(parts[1]);
            }
        }
    }

    @ParameterizedTest
    @ValueSource(strings = {"docs/architecture.md", "CONTRIBUTING.md"})
    void everyClassAndMethodThatAPageNamesIsThere(String page) throws IOException {
        Map<String, String> sources = new HashMap<>();
        for (Path path : Project.sources("src")) {
            sources.merge(path.getFileName().toString().replace(".java", ""), Files.readString(path), String::concat);
        }
        String all = String.join("", sources.values());

        List<MatchResult> names = CODE.matcher(Files.readString(Project.root().resolve(page))).results()
            .map(code -> NAME.matcher(code.group(1))).filter(name -> name.matches())
            .map(name -> name.toMatchResult()).toList();

        assertThat(names).hasSizeGreaterThan(15).allSatisfy(name -> {
            String source = sources.get(name.group(1));
            if (source == null) {
                assertThat(all).as(name.group()).containsPattern("((class|record|interface|enum) |import java[\\w.]*\\.)" + name.group(1) + "\\b");
            } else if (name.group(2) != null) {
                assertThat(source).as(name.group()).containsPattern("\\b" + name.group(2) + "\\b");
            }
        });
    }

    private static Set<String> anchors(String page) {
        return HEADING.matcher(page).results().map(heading -> heading.group(1).toLowerCase(Locale.ROOT).replaceAll("[^\\w\\- ]", "")
            .replace(' ', '-')).collect(Collectors.toSet());
    }
}
