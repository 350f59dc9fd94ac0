package simpleray.cli;

import java.io.BufferedInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import simpleray.image.Picture;
import simpleray.image.PictureText;
import simpleray.image.png.PngChunks;
import simpleray.image.png.PngRowReader;
import simpleray.image.png.PngSeal;
import simpleray.image.png.PngTextReader;

/** The picture that a command is to make, as an earlier run may have left it. */
final class DonePicture {
    private DonePicture() {
    }

    /**
     * Looks for the picture.
     *
     * @param file its place
     * @param texts what it is to tell, which is all that decides about its pixels
     * @param picture gives its size
     * @param rows names its rows, if it is a part of a picture; null for a whole one
     * @return whether it is there, tells the same and is whole
     */
    static boolean isThere(Path file, List<PictureText> texts, Picture picture, String rows) {
        try {
            return Files.isRegularFile(file) && tells(file, texts, rows) && isWhole(file, picture);
        } catch (IOException e) {
            return false;                                     // then it is made, or that says what is wrong
        }
    }

    private static boolean tells(Path file, List<PictureText> texts, String rows) throws IOException {
        try (InputStream in = new BufferedInputStream(Files.newInputStream(file))) {
            Map<String, byte[]> told = PngTextReader.read(new PngChunks(in, file.toString()).begin());
            boolean same = told.size() == texts.size() + (rows == null ? 0 : 1);
            for (PictureText text : texts) {
                same &= Arrays.equals(text.text(), told.get(text.keyword()));
            }
            if (!same || rows == null) {
                return same;
            }
        }
        try (InputStream in = Files.newInputStream(file)) {
            return PngSeal.holds(in, Files.size(file), rows);
        }
    }

    private static boolean isWhole(Path file, Picture picture) throws IOException {
        try (PngRowReader reader = new PngRowReader(file)) {
            if (reader.width() != picture.width() || reader.height() != picture.height()) {
                return false;
            }
            for (int y = 0; y < picture.height(); y++) {
                reader.next();
            }
            reader.end();
            return true;
        }
    }
}
