package simpleray;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;

/** The tables of docs/reliability.md: a fault, what happens, and the tests that show it, by their class or by class and method. */
class ReliabilityPageTest {
    private static final int CELLS = 5;                       // with those before and behind the outer bars
    private static final int TESTS = 3;
    private static final Pattern CODE = Pattern.compile("`(?:([A-Z]\\w*Test)(?:\\.(\\w+))?|([a-z]\\w*))`");

    @Test
    void eachFaultHasATestThatThereIs() throws IOException {
        Map<String, String> tests = new HashMap<>();          // two rooms may have a test of one name
        for (Path path : Project.sources("src/test")) {
            tests.merge(path.getFileName().toString().replace(".java", ""), Files.readString(path), String::concat);
        }

        List<String[]> rows = rows(Files.readAllLines(Project.root().resolve("docs/reliability.md")));

        assertThat(rows).hasSizeGreaterThan(40);
        for (String[] cells : rows) {
            assertThat(cells).as(cells[1]).hasSize(CELLS);
            String in = null;
            Matcher code = CODE.matcher(cells[TESTS]);
            while (code.find()) {
                in = code.group(1) == null ? in : tests.get(code.group(1));
                assertThat(in).as(cells[1] + ": " + code.group()).isNotNull();
                String method = code.group(1) == null ? code.group(3) : code.group(2);
                assertThat(in.contains(method == null ? "@" : " void " + method + "(")).as(cells[1] + ": " + code.group()).isTrue();
            }
            assertThat(in).as(cells[1] + " has a test").isNotNull();
        }
    }

    /** {@return the rows of the tables whose last column is that of tests} */
    private static List<String[]> rows(List<String> page) {
        List<String[]> rows = new ArrayList<>();
        boolean listed = false;
        for (int i = 0; i < page.size(); i++) {
            if (!page.get(i).startsWith("|")) {
                listed = false;
            } else if (page.get(i).endsWith("| test |")) {
                listed = true;
                i++;                                          // the line below the headings
            } else if (listed) {
                rows.add(page.get(i).split("(?<!\\\\)\\|", -1));
            }
        }
        return rows;
    }
}
