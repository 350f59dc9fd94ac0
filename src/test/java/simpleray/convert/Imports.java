package simpleray.convert;

import static org.assertj.core.api.Assertions.catchThrowableOfType;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import simpleray.scene.Scene;
import simpleray.text.Diagnostic;
import simpleray.text.SceneFormatException;
import simpleray.text.SceneReader;
import simpleray.text.SceneWriter;

/** What the tests of all formats do with a text. */
final class Imports {
    private Imports() {
    }

    /** Something that writes. */
    interface Writing {
        void write(SceneWriter os) throws IOException;
    }

    static ImportedScene read(ForeignFormat format, String text) throws IOException {
        return format.read(new ByteArrayInputStream(text.getBytes(StandardCharsets.UTF_8)), "in/a.file");
    }

    static String text(Writing writing) throws IOException {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        SceneWriter os = new SceneWriter(bytes);
        writing.write(os);
        os.flush();
        return bytes.toString(StandardCharsets.UTF_8);
    }

    /** {@return the scene that is written, which our own reader takes without a word} */
    static String scene(ForeignFormat format, String text) throws IOException {
        String scene = text(read(format, text)::write);
        SceneReader is = new SceneReader(new ByteArrayInputStream(scene.getBytes(StandardCharsets.UTF_8)), "a.scene", Path.of(""));
        new Scene().read(is);
        if (!is.warnings().isEmpty()) {
            throw new AssertionError(is.warnings());
        }
        return scene;
    }

    /** {@return all warnings, without the file's name} */
    static List<String> warnings(ForeignFormat format, String text) throws IOException {
        return read(format, text).warnings().stream().map(Diagnostic::headline).map(line -> line.replace("in/a.file:", "")).toList();
    }

    /** {@return the first line of the error, without the file's name} */
    static String error(ForeignFormat format, String text) {
        SceneFormatException error = catchThrowableOfType(SceneFormatException.class, () -> read(format, text));
        return error.problems().get(0).headline().replace("in/a.file:", "").replace(" error: expected", "");
    }
}
