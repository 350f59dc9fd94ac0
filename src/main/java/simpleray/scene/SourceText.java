package simpleray.scene;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.io.UncheckedIOException;
import java.nio.file.Path;
import java.security.DigestOutputStream;
import java.security.MessageDigest;
import java.util.List;
import simpleray.image.PictureText;
import simpleray.io.OutputTarget;
import simpleray.io.Sha256;
import simpleray.text.SceneWriter;

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

    /** {@return the text of another scene of the same files, under the same name} */
    SourceText of(Scene scene) {
        return of(scene, PictureText.LONGEST);
    }

    /** {@return likewise, kept up to a length} */
    SourceText of(Scene scene, int longest) {
        MessageDigest digest = Sha256.begin();
        Start start = new Start(longest);
        try {
            SceneWriter os = new SceneWriter(new DigestOutputStream(start, digest));
            scene.write(os);
            os.flush();
        } catch (IOException e) {
            throw new UncheckedIOException(e);                // does not happen in memory
        }
        return new SourceText(name, Sha256.hex(digest.digest()), start.isWhole ? start.bytes.toByteArray() : null, meshes);
    }

    /** Keeps what is written, unless it is too long. */
    private static final class Start extends OutputStream {
        final ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        final int longest;
        boolean isWhole = true;

        Start(int longest) {
            this.longest = longest;
        }

        @Override
        public void write(int b) {
            isWhole &= bytes.size() < longest;
            if (isWhole) {
                bytes.write(b);
            }
        }
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
