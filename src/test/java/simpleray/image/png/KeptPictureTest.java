package simpleray.image.png;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import simpleray.image.Picture;
import simpleray.image.PictureText;

class KeptPictureTest {
    private static final List<PictureText> TEXTS = List.of(new PictureText("Software", "a program"), new PictureText("scene", "a scene"));
    private static final int HEADER = 33;                     // the signature and IHDR

    @TempDir
    Path folder;

    private Path written(List<PictureText> texts) throws IOException {
        Picture picture = new Picture(2, 1);
        picture.setRow(0, new double[6]);
        picture.tell(texts);
        Path file = folder.resolve("picture.png");
        try (PictureFile png = new PictureFile(file)) {
            png.write(picture);
        }
        return file;
    }

    private KeptPicture found(byte[] file) throws IOException {
        return KeptPicture.find(Files.write(folder.resolve("file"), file), TEXTS);
    }

    @Test
    void aPictureOfTheseTextsIsWhole() throws IOException {
        assertThat(KeptPicture.find(written(TEXTS), TEXTS)).isEqualTo(KeptPicture.WHOLE);
        assertThat(KeptPicture.find(written(List.of()), List.of())).isEqualTo(KeptPicture.WHOLE);
    }

    @Test
    void whereNothingIsThereIsNone() throws IOException {
        assertThat(KeptPicture.find(folder.resolve("none.png"), TEXTS)).isEqualTo(KeptPicture.NONE);
    }

    @Test
    void onePictureIsNotAnother() throws IOException {
        PictureText software = TEXTS.get(0);
        for (List<PictureText> other : List.of(List.<PictureText>of(), List.of(software), List.of(TEXTS.get(1), software),
            List.of(software, new PictureText("scene", "a scenf")), List.of(software, TEXTS.get(1), new PictureText("more", "")))) {
            assertThat(KeptPicture.find(written(other), TEXTS)).as("%s", other).isEqualTo(KeptPicture.OTHER);
        }
    }

    @Test
    void whatIsNoPictureIsAnother() throws IOException {
        assertThat(found("a text".getBytes())).isEqualTo(KeptPicture.OTHER);
        assertThat(found(new byte[100])).isEqualTo(KeptPicture.OTHER);
        assertThat(KeptPicture.find(folder, TEXTS)).isEqualTo(KeptPicture.OTHER);
    }

    @Test
    void cutOffAnywhereItIsBroken() throws IOException {
        byte[] file = Files.readAllBytes(written(TEXTS));
        for (int length = 0; length < file.length; length++) {
            assertThat(found(Arrays.copyOf(file, length))).as("%d bytes", length).isEqualTo(KeptPicture.BROKEN);
        }
    }

    @Test
    void aChangedByteOrOneTooMuchMakesItBroken() throws IOException {
        byte[] file = Files.readAllBytes(written(TEXTS));
        assertThat(found(Arrays.copyOf(file, file.length + 1))).isEqualTo(KeptPicture.BROKEN);
        file[HEADER - 1]++;
        assertThat(found(file)).isEqualTo(KeptPicture.BROKEN);
        file[HEADER - 1]--;
        file[file.length - 20]++;
        assertThat(found(file)).isEqualTo(KeptPicture.BROKEN);
    }
}
