package simpleray.scene;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import java.util.function.Predicate;

/** Finds the MTL files that an OBJ names: {@code mtllib} with one name or several, in which there may be blanks. */
public final class MtlNames {
    private static final String KEYWORD = "mtllib";
    private static final String ENDING = ".mtl";
    private static final String BLANKS = "\\s+";
    private static final char COMMENT = '#';

    private MtlNames() {
    }

    /**
     * Finds the files that an OBJ may mean, whether they are there or not.
     *
     * @param folder the folder of the scene that names the OBJ
     * @param obj its name there
     * @return the files within the folder; none if the OBJ cannot be read
     */
    public static Set<Path> of(Path folder, String obj) {
        Set<Path> files = new LinkedHashSet<>();
        try {
            Path path = folder.resolve(obj);
            if (Files.isRegularFile(path)) {
                try (InputStream in = Files.newInputStream(path)) {
                    LineReader lines = new LineReader(in, obj);
                    while (lines.read()) {
                        if (lines.text(lines.begin, Math.min(lines.end, lines.begin + KEYWORD.length())).equalsIgnoreCase(KEYWORD)) {
                            add(files, folder, obj, lines.names(lines.begin + KEYWORD.length()));
                        }
                    }
                }
            }
        } catch (IOException | InvalidPathException e) {
            return files;
        }
        return files;
    }

    private static void add(Set<Path> files, Path folder, String obj, String names) {
        Set<String> all = new LinkedHashSet<>(readings(names));
        all.addAll(split(names, name -> false));
        all.addAll(List.of(names.split(BLANKS)));
        for (String name : all) {
            String full = besideObj(obj, name);
            if (!name.isEmpty() && !MeshFiles.leavesByName(full)) {
                files.add(folder.resolve(full));
            }
        }
    }

    /** {@return the name of a file beside an OBJ as the scene would name it} */
    static String besideObj(String obj, String name) {
        String there = name.replace('\\', '/');
        return MeshFiles.isRooted(there) ? there : obj.substring(0, Math.max(obj.lastIndexOf('/'), obj.lastIndexOf('\\')) + 1) + there;
    }

    /**
     * Splits what stands behind {@code mtllib}.
     *
     * @param text one name or several, perhaps with a comment behind
     * @param exists whether there is a file of this name
     * @return the names
     */
    static List<String> split(String text, Predicate<String> exists) {
        List<String> readings = readings(text);
        for (String reading : readings) {
            if (exists.test(reading)) {
                return List.of(reading);
            }
        }
        String names = readings.stream().filter(reading -> reading.toLowerCase(Locale.ROOT).endsWith(ENDING)).findFirst()
            .orElse(readings.get(readings.size() - 1));
        List<String> words = List.of(names.split(BLANKS));
        return words.stream().allMatch(exists) ? words : List.of(names.split("(?i)(?<=\\" + ENDING + ")" + BLANKS));
    }

    /** {@return what a name may be, to which a {@code #} may belong, or begin a comment: the longest first} */
    static List<String> readings(String name) {
        List<String> readings = new ArrayList<>(List.of(name));
        for (int comment = name.lastIndexOf(COMMENT); comment > 0; comment = name.lastIndexOf(COMMENT, comment - 1)) {
            readings.add(name.substring(0, comment).strip());
        }
        return readings;
    }
}
