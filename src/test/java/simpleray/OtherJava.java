package simpleray;

import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Comparator;
import java.util.List;
import java.util.Properties;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** Another Java, of those that lie beside the running one. */
final class OtherJava {
    static final Path HOME = Path.of(System.getProperty("java.home"));
    private static final int OLDEST = 17;

    private OtherJava() {
    }

    /** {@return the newest other one; without one the test is skipped} */
    static Path home() throws IOException {
        try (Stream<Path> homes = Files.list(HOME.toRealPath().getParent())) {
            List<Path> others = homes.filter(home -> Files.isExecutable(home.resolve("bin/java")))
                .filter(home -> version(home) >= OLDEST && version(home) != Runtime.version().feature())
                .sorted(Comparator.comparing(OtherJava::version).thenComparing(Path::toString)).collect(Collectors.toList());
            assumeTrue(!others.isEmpty(), "no other Java beside " + HOME);
            return others.get(others.size() - 1);
        }
    }

    /** {@return the folder or the jar that a class came from} */
    static String place(Class<?> type) {
        try {
            return Path.of(type.getProtectionDomain().getCodeSource().getLocation().toURI()).toString();
        } catch (java.net.URISyntaxException e) {
            throw new IllegalStateException(e);
        }
    }

    /** {@return the feature version of a Java, as the file beside it says; 0 if it does not} */
    private static int version(Path home) {
        Properties release = new Properties();
        try (var in = Files.newInputStream(home.resolve("release"))) {
            release.load(in);
            return Runtime.Version.parse(release.getProperty("JAVA_VERSION", "0").replace("\"", "")).feature();
        } catch (IOException | IllegalArgumentException e) {
            return 0;
        }
    }
}
