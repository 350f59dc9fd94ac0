package simpleray.scene;

import java.io.BufferedInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import simpleray.image.PictureText;
import simpleray.image.png.PictureFormatException;
import simpleray.image.png.PngChunks;
import simpleray.image.png.PngTextReader;
import simpleray.io.Sha256;
import simpleray.scene.SourceText.MeshFile;
import simpleray.text.Diagnostic;

/**
 * The description of how a picture was made, from the texts that its file carries. <em>Constant.</em>
 *
 * @param file the picture's name, for messages
 * @param software the program that made it and its version
 * @param settings size, depth, samples, camera and background, as far as they were set
 * @param others the other options, a line each
 * @param text the scene, perhaps without its bytes, and its meshes and their MTL files
 */
public record PictureScene(String file, String software, SceneSettings settings, List<String> others, SourceText text) {
    private static final String SOFTWARE = "Software";
    private static final String OPTIONS = "simpleray.options";
    private static final String SUMS = "simpleray.sha256";
    private static final String TEXT = "simpleray.scene";
    private static final int SUM = 64;
    private static final String GAP = "  ";                   // as sha256sum writes

    /**
     * Reads the description from a picture.
     *
     * @param path the picture's file
     * @return the description
     * @throws PictureFormatException if it is no PNG, is damaged, or has no description
     * @throws IOException if it cannot be read
     */
    public static PictureScene read(Path path) throws IOException {
        try (InputStream in = Files.newInputStream(path)) {
            return read(in, path.toString());
        }
    }

    /**
     * Reads the description from a picture that comes as a stream.
     *
     * @param in the stream, which stays open
     * @param name the picture's name, for messages
     * @return the description
     * @throws PictureFormatException if it is no PNG, is damaged, or has no description
     * @throws IOException if it cannot be read
     */
    public static PictureScene read(InputStream in, String name) throws IOException {
        return read(new PngChunks(new BufferedInputStream(in), name).begin(), name);
    }

    /** Reads what a picture tells. */
    static PictureScene read(PngChunks chunks, String file) throws IOException {
        Map<String, byte[]> texts = PngTextReader.read(chunks);
        String software = string(texts, SOFTWARE);
        String options = string(texts, OPTIONS);
        String sums = string(texts, SUMS);
        if (software == null || options == null || sums == null) {
            throw new PictureFormatException(file, "carries no scene: it is not of SimpleRay, or another program has written it anew");
        }
        List<String> others = new ArrayList<>();
        StringBuilder known = new StringBuilder();
        options.lines().forEach(line -> {
            if (SceneSettings.isSetting(line)) {
                known.append(line).append('\n');
            } else {
                others.add(line);
            }
        });
        return new PictureScene(file, software, SceneSettings.of(known.toString(), file + " (its options)"), List.copyOf(others),
            text(file, sums.lines().toList(), texts.get(TEXT)));
    }

    private static SourceText text(String file, List<String> sums, byte[] text) throws IOException {
        List<MeshFile> all = new ArrayList<>();
        for (String line : sums) {
            if (line.length() <= SUM + GAP.length() || !line.startsWith(GAP, SUM)) {
                throw new PictureFormatException(file, "carries a digest that cannot be read: " + Diagnostic.quoted(line));
            }
            all.add(new MeshFile(line.substring(SUM + GAP.length()), line.substring(0, SUM)));
        }
        if (all.isEmpty()) {
            throw new PictureFormatException(file, "carries no digest of its scene");
        }
        MeshFile scene = all.remove(0);
        if (text != null && !Sha256.of(text).equals(scene.sha256())) {
            throw new PictureFormatException(file, "carries another scene than it was made of: the digests differ");
        }
        return new SourceText(scene.name(), scene.sha256(), text, List.copyOf(all));
    }

    private static String string(Map<String, byte[]> texts, String keyword) {
        byte[] text = texts.get(keyword);
        return text == null ? null : new String(text, StandardCharsets.UTF_8);
    }

    /**
     * Makes the texts of a picture, in the form that {@link #read} reads.
     *
     * @param software the program that makes it and its version
     * @param options the options, a line each
     * @param text the scene
     * @return the texts
     */
    public static List<PictureText> texts(String software, String options, SourceText text) {
        StringBuilder sums = new StringBuilder(text.sha256() + GAP + line(text.name()) + '\n');
        for (MeshFile mesh : text.meshes()) {
            sums.append(mesh.sha256()).append(GAP).append(line(mesh.name())).append('\n');
        }
        List<PictureText> texts = new ArrayList<>(List.of(new PictureText(SOFTWARE, software), new PictureText(OPTIONS, options),
            new PictureText(SUMS, sums.toString())));
        if (text.bytes() != null) {
            texts.add(new PictureText(TEXT, text.bytes()));
        }
        return texts;
    }

    private static String line(String name) {
        StringBuilder line = new StringBuilder(name);
        for (int i = 0; i < line.length(); i++) {
            if (Character.isISOControl(line.charAt(i))) {
                line.setCharAt(i, '?');
            }
        }
        return line.toString();
    }

    /**
     * Returns the meshes that have changed since the picture was made.
     *
     * @param now the meshes as read now
     * @return their names
     */
    public List<String> changed(List<MeshFile> now) {
        return text.meshes().stream().filter(mesh -> now.stream().noneMatch(other -> line(other.name()).equals(mesh.name())
            && other.sha256().equals(mesh.sha256()))).map(MeshFile::name).toList();
    }

    /**
     * Reads the scene, with the picture's settings.
     *
     * @param name its name for messages
     * @param folder the folder of the files that it names
     * @param reach the files that it may name
     * @return the scene
     * @throws PictureFormatException if the picture carries only the digest
     * @throws IOException if there are errors in it, or a mesh cannot be read
     */
    SceneFile open(String name, Path folder, Reach reach) throws IOException {
        if (text.bytes() == null) {
            throw new PictureFormatException(file, "carries only the digest of its scene, which is too long: open " + text.name());
        }
        SceneFile read = SceneFile.read(text, name, folder, reach);
        read.scene().settings = read.scene().settings.under(settings);
        List<Diagnostic> warnings = new ArrayList<>(read.warnings());
        for (String mesh : changed(read.text().meshes())) {
            String kind = mesh.endsWith(".mtl") ? "MTL file " : "mesh ";
            warnings.add(new Diagnostic(name, 1, 1, false, "the " + kind + Diagnostic.quoted(mesh) + " is not the one that the picture was made of",
                text.name()));
        }
        return new SceneFile(read.scene(), List.copyOf(warnings), read.text());
    }
}
