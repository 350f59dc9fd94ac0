package simpleray.scene;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.io.UncheckedIOException;
import java.security.MessageDigest;
import simpleray.image.PictureText;
import simpleray.io.Sha256;
import simpleray.text.SceneWriter;

/**
 * The frames of a film as files of their own, each with the text that {@link Scene#write} gives it. If only settings differ from the frame before, such as
 * the camera, nothing else is written again. <em>Mutable</em>; any thread may call.
 */
public final class FrameTexts {
    private final SceneFile file;
    private final int longest;
    private Scene last;                                       // the scene of which the beginning was written; null before that
    private Text beginning;

    /** The bytes of a text, and their digest. */
    private static final class Text extends OutputStream {
        final MessageDigest digest;
        final int longest;
        final ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        boolean isWhole = true;                               // else it is too long to be kept

        Text(MessageDigest digest, int longest) {
            this.digest = digest;
            this.longest = longest;
        }

        @Override
        public void write(int b) {
            write(new byte[] {(byte) b}, 0, 1);
        }

        @Override
        public void write(byte[] b, int off, int len) {
            digest.update(b, off, len);
            isWhole = isWhole && len <= longest - bytes.size();
            if (isWhole) {
                bytes.write(b, off, len);
            }
        }
    }

    /**
     * Prepares to write.
     *
     * @param file the film
     */
    public FrameTexts(SceneFile file) {
        this(file, PictureText.LONGEST);
    }

    /** Prepares to write; texts are kept up to a length. */
    FrameTexts(SceneFile file, int longest) {
        this.file = file;
        this.longest = longest;
    }

    /**
     * Returns the file of a frame.
     *
     * @param still the frame's scene, by {@link Film#still}
     * @return its file; the film's if that is no film
     */
    public synchronized SceneFile of(Scene still) {
        SourceText text = file.text();
        if (still == file.scene() || text == null) {
            return still == file.scene() ? file : new SceneFile(still, file.warnings(), null);
        }
        try {
            if (last == null || !still.hasThingsOf(last)) {
                beginning = new Text(Sha256.begin(), longest);
                SceneWriter os = new SceneWriter(beginning);
                still.writeThings(os);
                os.flush();
                last = still;
            }
            Text all = new Text((MessageDigest) beginning.digest.clone(), longest);
            if (beginning.isWhole) {
                beginning.bytes.writeTo(all.bytes);
            }
            all.isWhole = beginning.isWhole;
            SceneWriter os = new SceneWriter(all);
            still.settings.write(os);
            os.flush();
            return new SceneFile(still, file.warnings(),
                new SourceText(text.name(), Sha256.hex(all.digest.digest()), all.isWhole ? all.bytes.toByteArray() : null, text.meshes()));
        } catch (IOException | CloneNotSupportedException e) {
            throw new UncheckedIOException(new IOException(e));   // does not happen in memory, nor with the JDK's SHA-256
        }
    }
}
