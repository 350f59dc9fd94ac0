package simpleray.scene;

import java.io.BufferedInputStream;
import java.io.ByteArrayInputStream;
import java.io.FileInputStream;
import java.io.FileNotFoundException;
import java.io.IOException;
import java.io.InputStream;
import java.io.PushbackInputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import simpleray.image.PictureText;
import simpleray.image.png.PngChunks;
import simpleray.io.HashingInputStream;
import simpleray.io.InputFile;
import simpleray.io.MagicNumber;
import simpleray.text.Diagnostic;
import simpleray.text.SceneFormatException;
import simpleray.text.SceneReader;
import simpleray.text.SourceValues;

/**
 * A scene read from a file, with the warnings about the file. <em>Constant.</em>
 *
 * @param scene the scene
 * @param warnings the warnings, in the order of the file
 * @param text its text; null if it was not read
 */
public record SceneFile(Scene scene, List<Diagnostic> warnings, SourceText text) {
    private static final String STREAM = "<stdin>";

    /**
     * Creates a scene that was not read from a text.
     *
     * @param scene the scene
     * @param warnings the warnings
     */
    public SceneFile(Scene scene, List<Diagnostic> warnings) {
        this(scene, warnings, null);
    }

    /**
     * Reads a scene file, or the scene of a picture that carries one. It may name OBJ files in its own folder.
     *
     * @param path the file; its path as given stands in messages
     * @return the scene
     * @throws SceneFormatException if it is no scene
     * @throws simpleray.image.png.PictureFormatException if it is a picture, and damaged or without a scene
     * @throws FileSystemException if it cannot be opened, with a reason that people understand
     * @throws IOException if it cannot be read
     */
    public static SceneFile read(Path path) throws IOException {
        return read(path, Reach.FOLDER);
    }

    /**
     * Reads a scene file, or the scene of a picture that carries one.
     *
     * @param path the file; its path as given stands in messages
     * @param reach which OBJ files it may name
     * @return the scene
     * @throws SceneFormatException if it is no scene
     * @throws simpleray.image.png.PictureFormatException if it is a picture, and damaged or without a scene
     * @throws FileSystemException if it cannot be opened, with a reason that people understand
     * @throws IOException if it cannot be read
     */
    public static SceneFile read(Path path, Reach reach) throws IOException {
        if (Files.isDirectory(path)) {
            throw new FileSystemException(path.toString(), null, InputFile.folderReason(path));
        }
        try (InputStream in = new FileInputStream(path.toFile())) {
            return read(in, longestKept(path), path.toString(), path.resolveSibling(""), reach, null);
        } catch (FileNotFoundException e) {
            String reason = InputFile.refusal(path);
            throw (IOException) new FileSystemException(path.toString(), null, reason == null ? "may not be read" : reason).initCause(e);
        }
    }

    /** {@return the number of bytes of a file to keep: none if it is known to be too long} */
    private static int longestKept(Path path) {
        return path.toFile().length() > PictureText.LONGEST ? 0 : PictureText.LONGEST;
    }

    /**
     * Reads a scene from standard input. It may name OBJ files in the working directory.
     *
     * @param in the stream, read to its end and left open
     * @return the scene
     * @throws SceneFormatException if it is no scene
     * @throws simpleray.image.png.PictureFormatException if it is a picture, and damaged or without a scene
     * @throws IOException if it cannot be read
     */
    public static SceneFile read(InputStream in) throws IOException {
        return read(in, Reach.FOLDER);
    }

    /**
     * Reads a scene from standard input.
     *
     * @param in the stream, read to its end and left open
     * @param reach which OBJ files it may name
     * @return the scene
     * @throws SceneFormatException if it is no scene
     * @throws simpleray.image.png.PictureFormatException if it is a picture, and damaged or without a scene
     * @throws IOException if it cannot be read
     */
    public static SceneFile read(InputStream in, Reach reach) throws IOException {
        return read(in, STREAM, Path.of(""), reach);
    }

    /**
     * Reads a scene from a text that is not, or not yet, in its file.
     *
     * @param in the text, read to its end and left open
     * @param path the file, for messages and for the files beside it
     * @param reach which OBJ files it may name
     * @return the scene
     * @throws SceneFormatException if it is no scene
     * @throws IOException if it cannot be read
     */
    public static SceneFile read(InputStream in, Path path, Reach reach) throws IOException {
        return read(in, path.toString(), path.resolveSibling(""), reach);
    }

    /**
     * Reads a scene likewise, and lists its values.
     *
     * @param in the text, read to its end and left open
     * @param path the file, for messages and for the files beside it; null for standard input and the working directory
     * @param reach which OBJ files it may name
     * @param values gets the values; up to the first error after which the rest cannot be read
     * @return the scene
     * @throws SceneFormatException if it is no scene
     * @throws IOException if it cannot be read
     */
    public static SceneFile read(InputStream in, Path path, Reach reach, SourceValues values) throws IOException {
        return read(in, path == null ? STREAM : path.toString(), path == null ? Path.of("") : path.resolveSibling(""), reach, values);
    }

    /**
     * Reads a scene likewise, which people know by another name than its path.
     *
     * @param in the text, read to its end and left open
     * @param name the scene's name, for messages
     * @param folder the folder in which the files lie that it names
     * @param reach which OBJ files it may name
     * @param values gets the values; null for nothing
     * @return the scene
     * @throws SceneFormatException if it is no scene
     * @throws IOException if it cannot be read
     */
    public static SceneFile read(InputStream in, String name, Path folder, Reach reach, SourceValues values) throws IOException {
        return read(in, PictureText.LONGEST, name, folder, reach, values);
    }

    /**
     * Reads a scene from a string, which messages call {@code scene}. It may name OBJ files in the working directory.
     *
     * @param text the text of a scene file
     * @return the scene
     * @throws SceneFormatException if it is no scene
     * @throws IOException if an OBJ file cannot be read
     */
    public static SceneFile parse(String text) throws IOException {
        return read(new ByteArrayInputStream(text.getBytes(StandardCharsets.UTF_8)), Path.of("scene"), Reach.FOLDER);
    }

    /**
     * Finds where an object is in the file.
     *
     * @param i its index in the scene
     * @return its line, from 1; 0 if it is not known
     */
    public int lineOfObject(int i) {
        return scene.objectLine(i);
    }

    /**
     * Returns the line of a light in the file.
     *
     * @param i its index in the scene
     * @return its line, from 1; 0 if it is not known
     */
    public int lineOfLight(int i) {
        return scene.lightLine(i);
    }

    /**
     * Returns this file with other settings than its own.
     *
     * @param settings the settings, referenced
     * @return the file of {@link Scene#with the scene with these settings}
     */
    public SceneFile with(SceneSettings settings) {
        return new SceneFile(scene.with(settings), warnings, text);
    }

    /**
     * Finds where a key is in the file.
     *
     * @param i its index among the scene's keys
     * @return its line, from 1; 0 if it is not known
     */
    public int lineOfKey(int i) {
        return scene.settings.keyLines.get(i);
    }

    /**
     * Returns a frame of a film as if it were a file of its own, with the text that {@link Scene#write} gives it.
     *
     * @param frame the frame, from 0 to the film's last; need not be whole
     * @return the file of {@link Scene#still the frame's scene}; this file if it is no film
     * @throws IllegalArgumentException if there is no such frame, or it has values that no scene may have
     */
    public SceneFile still(double frame) {
        return new FrameTexts(this).of(scene.still(frame));
    }

    private static SceneFile read(InputStream in, String name, Path folder, Reach reach) throws IOException {
        return read(in, PictureText.LONGEST, name, folder, reach, null);
    }

    private static SceneFile read(InputStream file, int longestKept, String name, Path folder, Reach reach, SourceValues values)
        throws IOException {
        PushbackInputStream begun = new PushbackInputStream(file, MagicNumber.LENGTH);
        if (PngChunks.begin(begun)) {
            return PictureScene.read(new PngChunks(new BufferedInputStream(begun), name), name).open(name, folder, reach);
        }
        String kind = MagicNumber.nameOf(begun);
        if (kind != null) {
            String message = "expected a scene, as text in UTF-8, found " + kind;
            throw new SceneFormatException(List.of(new Diagnostic(name, 1, 1, true, message, null)), false);
        }
        HashingInputStream in = new HashingInputStream(begun, longestKept);
        SceneReader reader = new SceneReader(in, name, folder);
        reader.list(values);
        MeshFiles meshes = MeshFiles.of(reader, reach);
        Scene scene = read(reader, new Again() {
            @Override
            public Recount get() throws IOException {
                byte[] text = in.rest(Recount.MAX_BYTES);
                return text == null ? null : new Recount(() -> new SceneReader(new ByteArrayInputStream(text), name, folder), reach);
            }
        });
        String base = name.equals(STREAM) ? "stdin" : Path.of(name).getFileName().toString();
        byte[] kept = in.kept();
        return new SceneFile(scene, reader.warnings(),
            new SourceText(base, kept == null ? in.sha256() : null, kept, List.copyOf(meshes.read)));
    }

    /** Reads a scene of which a picture carries the text. */
    static SceneFile read(SourceText carried, String name, Path folder, Reach reach) throws IOException {
        SceneReader reader = new SceneReader(new ByteArrayInputStream(carried.bytes()), name, folder);
        MeshFiles meshes = MeshFiles.of(reader, reach);
        Scene scene = read(reader, () -> null);               // it was a scene when the picture was made
        return new SceneFile(scene, reader.warnings(),
            new SourceText(carried.name(), carried.sha256(), carried.bytes(), List.copyOf(meshes.read)));
    }

    /** Opens the scene again; null if that is impossible. */
    private interface Again {
        Recount get() throws IOException;
    }

    /** Reads a scene. If its counts are wrong and it can be read again, the error has the right ones. */
    private static Scene read(SceneReader reader, Again again) throws IOException {
        CountOverrides counts = new CountOverrides();
        Scene scene = new Scene();
        try {
            scene.read(reader, counts);
        } catch (SceneFormatException e) {
            Recount recount = counts.announced && !counts.fit ? again.get() : null;
            throw recount == null ? e : recount.explained(e);
        }
        return scene;
    }
}
