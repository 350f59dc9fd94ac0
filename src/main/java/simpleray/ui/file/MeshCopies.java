package simpleray.ui.file;

import java.io.IOException;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.Map;

/** Takes the files that a scene names along when it is saved in another folder. */
public final class MeshCopies {
    private MeshCopies() {
    }

    /**
     * Copies the files beside a scene, or below its folder, that its text names to the same places beside another. Nothing is written over,
     * and nothing is copied if one of them would have to be.
     *
     * @param text the scene's text
     * @param scene the scene's path, or the one it would have
     * @param target where its text is to be written
     * @throws FileSystemException if another file has the name of one of them already
     * @throws IOException if one cannot be read or written
     */
    public static void copy(byte[] text, Path scene, Path target) throws IOException {
        Path from = scene.toAbsolutePath().normalize().getParent();
        Path to = target.toAbsolutePath().normalize().getParent();
        if (from.equals(to)) {
            return;
        }
        Map<Path, Path> copies = new LinkedHashMap<>();
        for (Path named : MeshNames.of(text, scene)) {
            Path file = named.toAbsolutePath().normalize();
            if (file.startsWith(from) && Files.isRegularFile(file)) {
                Path copy = to.resolve(from.relativize(file).toString());
                if (!Files.exists(copy)) {
                    copies.put(file, copy);
                } else if (!Arrays.equals(Files.readAllBytes(file), Files.readAllBytes(copy))) {
                    throw new FileSystemException(copy.toString(), null,
                        "The scene needs its " + file.getFileName() + " beside it, and another file has that name: choose another folder");
                }
            }
        }
        for (Map.Entry<Path, Path> copy : copies.entrySet()) {
            Files.createDirectories(copy.getValue().getParent());
            Files.copy(copy.getKey(), copy.getValue());
        }
    }
}
