package simpleray.image.png;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import simpleray.image.Picture;
import simpleray.image.Pictures;
import simpleray.io.FileInUseException;

class PictureFileTest {
    @TempDir
    private Path folder;
    private Path target;

    @BeforeEach
    void nameTheTarget() {
        target = folder.resolve("picture.png");
    }

    @Test
    void thePictureIsWrittenAsPng() throws IOException {
        write(target, 0.5);

        assertThat(Files.readAllBytes(target)).isEqualTo(png(0.5));
        assertThat(names(folder)).containsExactly("picture.png");
    }

    @Test
    void theTargetAppearsOnlyWhenItIsWhole() throws IOException {
        try (PictureFile file = new PictureFile(target)) {
            assertThat(target).doesNotExist();
            assertThat(names(folder)).as("what is beside it meanwhile").allMatch(name -> name.startsWith("."));

            file.write(Pictures.plain(2, 2, 0.5));

            assertThat(Files.readAllBytes(target)).isEqualTo(png(0.5));
        }
        assertThat(names(folder)).containsExactly("picture.png");
    }

    @Test
    void theOldPictureStaysUntilTheNewOneIsWhole() throws IOException {
        write(target, 0.25);
        try (PictureFile file = new PictureFile(target)) {
            assertThat(Files.readAllBytes(target)).isEqualTo(png(0.25));

            file.write(Pictures.plain(2, 2, 0.5));
        }
        assertThat(Files.readAllBytes(target)).isEqualTo(png(0.5));
        assertThat(names(folder)).containsExactly("picture.png");
    }

    @Test
    void theOldPictureStaysWhenNothingIsWritten() throws IOException {
        write(target, 0.25);
        new PictureFile(target).close();

        assertThat(Files.readAllBytes(target)).isEqualTo(png(0.25));
        assertThat(names(folder)).containsExactly("picture.png");
    }

    @Test
    void whereNothingIsWrittenNothingIsLeft() throws IOException {
        new PictureFile(target).close();
        assertThat(names(folder)).isEmpty();
    }

    @Test
    void theOldPictureStaysWhenWritingFails() throws IOException {
        write(target, 0.25);
        try (PictureFile file = new PictureFile(target)) {
            assertThatThrownBy(() -> file.write(new Picture(1, 1))).isInstanceOf(IllegalStateException.class);
        }
        assertThat(Files.readAllBytes(target)).isEqualTo(png(0.25));
        assertThat(names(folder)).containsExactly("picture.png");
    }

    @Test
    void aSecondInTheMakingForOneTargetIsRefusedUntilTheFirstIsDone() throws IOException {
        try (PictureFile one = new PictureFile(target)) {
            assertThatThrownBy(() -> new PictureFile(target)).isInstanceOf(FileInUseException.class).hasMessage(target
                + ": is being written by another run of SimpleRay: wait until it has ended, or choose another name");
            one.write(Pictures.plain(2, 2, 0.25));
        }
        write(target, 0.5);

        assertThat(Files.readAllBytes(target)).isEqualTo(png(0.5));
        assertThat(names(folder)).containsExactly("picture.png");
    }

    static List<String> names(Path folder) throws IOException {
        try (Stream<Path> files = Files.list(folder)) {
            return files.map(file -> file.getFileName().toString()).sorted().collect(Collectors.toList());
        }
    }

    static void write(Path path, double light) throws IOException {
        try (PictureFile file = new PictureFile(path)) {
            file.write(Pictures.plain(2, 2, light));
        }
    }

    static byte[] png(double light) throws IOException {
        return Pictures.png(Pictures.plain(2, 2, light));
    }
}
