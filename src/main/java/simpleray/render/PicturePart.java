package simpleray.render;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import simpleray.image.PictureText;
import simpleray.image.png.PictureFormatException;
import simpleray.image.png.PngRowReader;
import simpleray.image.png.PngSeal;
import simpleray.scene.PictureScene;
import simpleray.scene.SourceText;

/**
 * A file that is a part of a picture: the rows of one of its bands. <em>Constant.</em>
 *
 * @param band the band
 * @param whole the rectangle that was cut into bands
 * @param channels the numbers of a pixel, {@link simpleray.image.Picture#RGB} or {@link simpleray.image.Picture#RGBA}
 * @param identity all that decides the whole picture's file, as names and values
 * @param texts what the whole picture's file tells
 */
public record PicturePart(Band band, Region whole, int channels, Map<String, String> identity, List<PictureText> texts) {
    /**
     * Reads what a part tells, and makes sure that it is as it was written.
     *
     * @param path the file
     * @return the part
     * @throws PictureFormatException if it is no part, is damaged, or was made by another version
     * @throws IOException if it cannot be read
     */
    public static PicturePart read(Path path) throws IOException {
        PictureScene told = PictureScene.read(path);
        if (!told.software().equals(Provenance.SOFTWARE)) {
            throw new PictureFormatException(told.file(), "was made by " + told.software() + ", and this is " + Provenance.SOFTWARE
                + ": the parts of a picture are of one version");
        }
        RenderRequest request = Provenance.request(told, Accel.AUTO, 1);
        if (request.band() == null) {
            throw new PictureFormatException(told.file(), "is no part of a picture");
        }
        try (InputStream in = Files.newInputStream(path)) {
            requireWhole(request, in, Files.size(path), told.file());
        }
        List<String> options = new ArrayList<>(told.others());
        options.removeIf(line -> line.startsWith(Provenance.BAND));
        options.addAll(told.settings().lines().lines().toList());
        return new PicturePart(request.band(), request.whole(request.settings()), channels(path), identity(told.text(), options),
            PictureScene.texts(told.software(), String.join("\n", options) + '\n', told.text()));
    }

    private static int channels(Path path) throws IOException {
        try (PngRowReader rows = new PngRowReader(path)) {
            return rows.channels();
        }
    }

    private static Map<String, String> identity(SourceText text, List<String> options) {
        Map<String, String> identity = new LinkedHashMap<>();
        identity.put(PictureIdentity.SCENE, text.sha256());
        identity.put("scene's name", text.name());
        text.meshes().forEach(mesh -> identity.put("mesh " + mesh.name(), mesh.sha256()));
        for (String line : options) {
            String[] words = line.split(" ", 2);
            identity.put(words[0], words[words.length - 1]);
        }
        return identity;
    }

    /**
     * Makes sure that a part is as it was written.
     *
     * @param request what was asked for when it was made, with a band
     * @param in the file, from its first byte; read to its end
     * @param size its number of bytes
     * @param file its name in messages
     * @throws PictureFormatException if it is not
     * @throws IOException if it cannot be read
     */
    public static void requireWhole(RenderRequest request, InputStream in, long size, String file) throws IOException {
        boolean holds;
        try {
            holds = PngSeal.holds(in, size, request.band().rows(request.whole(request.settings())));
        } catch (IllegalArgumentException e) {
            throw (PictureFormatException) new PictureFormatException(file, "was made with options that do not fit: " + e.getMessage())
                .initCause(e);
        }
        if (!holds) {
            throw new PictureFormatException(file, "is damaged: it does not end with its checksum");
        }
    }
}
