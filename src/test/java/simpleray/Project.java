package simpleray;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** Where the build put what the tests look at; build.gradle says it by system properties. */
public final class Project {
    private Project() {
    }

    /** {@return the folder of the whole project} */
    public static Path root() {
        return path("simpleray.root");
    }

    /** {@return the folder of what the build makes} */
    public static Path build() {
        return path("simpleray.build");
    }

    /** {@return the program} */
    public static Path jar() {
        return path("simpleray.jar");
    }

    /** {@return the sample scene of that name, without its ending} */
    public static Path scene(String name) {
        return path("simpleray.scenes").resolve(name + ".scene");
    }

    /** {@return the names of all sample scenes, without their endings, in order} */
    public static List<String> scenes() {
        return names(path("simpleray.scenes"), ".scene");
    }

    /** {@return the folder of test resources of that name} */
    public static Path resources(String name) {
        return root().resolve("src/test/resources/simpleray").resolve(name);
    }

    /** {@return the names of the files in a folder that end so, without that ending, in order} */
    public static List<String> names(Path folder, String ending) {
        try (Stream<Path> files = Files.list(folder)) {
            return files.map(file -> file.getFileName().toString()).filter(name -> name.endsWith(ending))
                .map(name -> name.substring(0, name.length() - ending.length())).sorted().collect(Collectors.toList());
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    /** {@return all Java sources below a folder of the project, in order} */
    public static List<Path> sources(String folder) {
        return files(folder, Integer.MAX_VALUE, ".java");
    }

    /** {@return the pages of documentation, in order} */
    public static List<Path> pages() {
        return Stream.concat(files("", 1, ".md").stream(), files("docs", Integer.MAX_VALUE, ".md").stream()).collect(Collectors.toList());
    }

    private static List<Path> files(String folder, int depth, String ending) {
        try (Stream<Path> files = Files.walk(root().resolve(folder), depth)) {
            return files.filter(file -> file.toString().endsWith(ending)).sorted().collect(Collectors.toList());
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    private static Path path(String property) {
        return Path.of(System.getProperty(property));
    }
}
