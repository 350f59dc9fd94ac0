package simpleray.text;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;

/** Readers of strings and writers to strings, for tests. */
public final class SceneText {
    /** Something that writes itself. */
    @FunctionalInterface
    public interface Writing {
        /** Writes. */
        void to(SceneWriter os) throws IOException;
    }

    private SceneText() {
    }

    /** {@return a reader of this text, which messages call {@code <stdin>}} */
    public static SceneReader reader(String text) {
        return new SceneReader(new ByteArrayInputStream(text.getBytes(StandardCharsets.UTF_8)));
    }

    /** {@return what is written} */
    public static String written(Writing what) {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        try (SceneWriter os = new SceneWriter(bytes)) {
            what.to(os);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
        return bytes.toString(StandardCharsets.UTF_8);
    }
}
