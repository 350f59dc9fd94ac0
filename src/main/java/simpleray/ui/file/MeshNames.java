package simpleray.ui.file;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.File;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.LinkedHashSet;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import simpleray.scene.MtlNames;

/** Finds the files that a scene's text names between double quotes, whether the text has errors or not, and the MTL files that these name. */
public final class MeshNames {
    private static final int MAX = 1000;
    private static final int LONGEST = 4096;
    private static final Pattern QUOTED = Pattern.compile("\"([^\"\n]*)\"");
    private static final int PIECE = 1 << 16;
    private static final String MTL = "mtl";

    private final Path scene;
    private final Set<String> found = new LinkedHashSet<>();
    private ByteArrayOutputStream name;                       // null outside of quotes
    private boolean comment;
    private int letters;                                      // of the word mtl so far; -1 in another word
    private boolean mtl;                                      // whether the text has that word

    private MeshNames(Path scene) {
        this.scene = scene;
    }

    /** {@return the files beside a scene file that it names; none if it cannot be read} */
    static Set<Path> of(Path scene) {
        try (InputStream in = Files.newInputStream(scene)) {
            return of(in, scene);
        } catch (IOException e) {
            return Set.of();
        }
    }

    /** {@return the files beside a scene that a text of it names} */
    static Set<Path> of(byte[] text, Path scene) throws IOException {
        return of(new ByteArrayInputStream(text), scene);
    }

    private static Set<Path> of(InputStream in, Path scene) throws IOException {
        MeshNames names = new MeshNames(scene);
        byte[] piece = new byte[PIECE];
        for (int length = in.read(piece); length >= 0 && names.found.size() < MAX; length = in.read(piece)) {
            for (int i = 0; i < length; i++) {
                names.take(piece[i]);
            }
        }
        names.take((byte) '\n');
        return names.files();
    }

    /**
     * {@return where a text of a scene names a file, between double quotes; negative if it does not}
     *
     * @param file the path of the mesh file
     * @param text the text
     * @param scene the scene's file
     */
    public static int placeOf(String file, String text, Path scene) {
        Matcher names = QUOTED.matcher(text);
        while (names.find()) {
            if (new File(new File(scene.toString()).getParentFile(), names.group(1)).getPath().equals(file)) {
                return names.start();
            }
        }
        return -1;
    }

    private Set<Path> files() {
        Set<Path> files = new LinkedHashSet<>();
        for (String each : found) {
            try {
                files.add(scene.resolveSibling(each));
                if (mtl) {
                    files.addAll(MtlNames.of(scene.resolveSibling(""), each));
                }
            } catch (InvalidPathException e) {
                continue;                                     // no file can have that name: nothing to watch
            }
        }
        return files;
    }

    private void take(byte b) {
        if (name == null && !comment) {
            lookForMtl(b);
        }
        if (b == '\n' || b == '\r') {
            name = null;
            comment = false;
        } else if (name != null && b == '"') {
            add(name.toString(StandardCharsets.UTF_8));
            name = null;
        } else if (name != null && name.size() < LONGEST) {
            name.write(b);
        } else if (b == '#') {
            comment = true;
        } else if (b == '"' && !comment) {
            name = new ByteArrayOutputStream();
        }
    }

    private void lookForMtl(byte b) {
        if (b <= ' ' || b == '#') {
            mtl |= letters == MTL.length();
            letters = 0;
        } else {
            letters = letters >= 0 && letters < MTL.length() && b == MTL.charAt(letters) ? letters + 1 : -1;
        }
    }

    private void add(String name) {
        if (!name.isEmpty()) {
            found.add(name);
        }
    }
}
