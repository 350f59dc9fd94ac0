package simpleray.scene;

import java.util.List;

/**
 * The text from which a scene was read. <em>Constant.</em>
 *
 * @param name the file's name, without its folder
 * @param sha256 the text's SHA-256, 64 hexadecimal digits
 * @param bytes the text, not to be changed; null if it is too long
 * @param meshes the files that it names
 */
public record SourceText(String name, String sha256, byte[] bytes, List<MeshFile> meshes) {
    /**
     * A file that a scene names. <em>Constant.</em>
     *
     * @param name its name, as it stands in the scene's text
     * @param sha256 its SHA-256, 64 hexadecimal digits
     */
    public record MeshFile(String name, String sha256) {
    }
}
