package simpleray.scene;

import java.nio.file.Path;
import java.util.List;
import simpleray.io.OutputTarget;
import simpleray.io.Sha256;

/**
 * The text from which a scene was read. <em>Constant.</em>
 *
 * @param name the file's name, without its folder
 * @param sha256 the text's SHA-256, 64 hexadecimal digits; null to have it computed of the bytes when it is asked for
 * @param bytes the text, not to be changed; null if it is too long to be kept
 * @param meshes the files that it names
 */
public record SourceText(String name, String sha256, byte[] bytes, List<MeshFile> meshes) {
    /** {@return the text's SHA-256, 64 hexadecimal digits} */
    @Override
    public String sha256() {
        return sha256 == null ? Sha256.of(bytes) : sha256;
    }

    /**
     * Tells whether writing a file would lose one that the scene names.
     *
     * @param file the file's path
     * @param folder the scene's folder
     * @return whether it is one of them
     */
    public boolean names(Path file, Path folder) {
        for (MeshFile mesh : meshes) {
            if (OutputTarget.isSame(file, folder.resolve(mesh.name))) {
                return true;
            }
        }
        return false;
    }

    /**
     * A file that a scene names. <em>Constant.</em>
     *
     * @param name its name, as it stands in the scene's text
     * @param sha256 its SHA-256, 64 hexadecimal digits
     */
    public record MeshFile(String name, String sha256) {
    }
}
