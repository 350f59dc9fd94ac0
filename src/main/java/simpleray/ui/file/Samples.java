package simpleray.ui.file;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.net.JarURLConnection;
import java.net.URISyntaxException;
import java.net.URL;
import java.nio.file.FileSystems;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Comparator;
import java.util.List;
import java.util.stream.Stream;

/** The sample scenes that come with the program, in its jar, with the files that they name. They cannot be written over. */
public final class Samples {
    private static final String FOLDER = "/simpleray/scenes";
    private static final String FIRST = "thesis.scene";
    private static final String UNTITLED = "untitled.scene";
    private static final String NEW = "/simpleray/new.scene";

    private Samples() {
    }

    /** {@return the sample scenes, the thesis's own first, the others by name} Reads the jar. */
    public static List<SceneSource> all() {
        try (Stream<Path> files = Files.list(Folder.PATH)) {
            return files.filter(file -> file.toString().endsWith(".scene"))
                .sorted(Comparator.comparing((Path file) -> !file.endsWith(FIRST)).thenComparing(Path::toString))
                .map(Samples::source).toList();
        } catch (IOException e) {
            throw new UncheckedIOException(e);                // the program is not whole
        }
    }

    /** {@return a small scene to begin with, which has no file; its meshes are to lie in the working directory} */
    public static SceneSource template() {
        return new UntitledSource(UNTITLED, Path.of(UNTITLED), () -> {
            try (InputStream in = Samples.class.getResourceAsStream(NEW)) {
                return in.readAllBytes();
            }
        });
    }

    private static SceneSource source(Path file) {
        return new UntitledSource(file.getFileName().toString(), file, () -> Files.readAllBytes(file));
    }

    /** Opened once, when it is asked for first, and open until the program ends. */
    private static final class Folder {
        static final Path PATH = find();

        private static Path find() {
            try {
                URL url = Samples.class.getResource(FOLDER + '/' + FIRST);
                if (!url.getProtocol().equals("jar")) {
                    return Path.of(url.toURI()).getParent();  // classes that are in no jar
                }
                Path jar = Path.of(((JarURLConnection) url.openConnection()).getJarFileURL().toURI());
                return FileSystems.newFileSystem(jar).getPath(FOLDER);
            } catch (IOException | URISyntaxException e) {
                throw new IllegalStateException("the sample scenes cannot be found", e);
            }
        }
    }
}
