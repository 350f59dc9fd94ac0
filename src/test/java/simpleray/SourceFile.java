package simpleray;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;

/**
 * A Java source of the project.
 *
 * @param name its path from the project's folder, with slashes
 * @param lines its lines
 */
record SourceFile(String name, List<String> lines) {
    private static final Pattern IMPORT = Pattern.compile("\\s*import\\s+(?:static\\s+)?([\\w.]+(?:\\.\\*)?)\\s*;.*");
    private static final Pattern PACKAGE = Pattern.compile("[a-z0-9_]+(\\.[a-z0-9_]+)*");

    /** {@return all sources below a folder of the project} */
    static List<SourceFile> allOf(String folder) {
        return Project.sources(folder).stream().map(SourceFile::read).collect(Collectors.toList());
    }

    private static SourceFile read(Path file) {
        try {
            return new SourceFile(Project.root().relativize(file).toString().replace('\\', '/'), Files.readAllLines(file));
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    /** {@return what is imported, as it is written: {@code java.util.List}, or {@code java.util.*}} */
    List<String> imports() {
        return lines.stream().map(IMPORT::matcher).filter(Matcher::matches).map(m -> m.group(1)).collect(Collectors.toList());
    }

    /** {@return the packages that are imported from} */
    Set<String> importedPackages() {
        return imports().stream().map(PACKAGE::matcher).filter(Matcher::lookingAt).map(Matcher::group).collect(Collectors.toSet());
    }

    /** {@return the folder it lies in, with slashes} */
    String folder() {
        return name.substring(0, name.lastIndexOf('/'));
    }

    /** {@return the name of the class that the file is named after} */
    String className() {
        return name.substring(name.lastIndexOf('/') + 1, name.length() - ".java".length());
    }
}
