package simpleray.film;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Films by a script in ffmpeg's place; AnimateCommandTest makes some by ffmpeg itself, where it is there. */
class FfmpegFilmTest {
    private static final byte[] FRAME = new byte[3 * 4 * 2];

    @TempDir
    Path folder;

    @BeforeEach
    void thereAreScripts() {
        assumeTrue(Files.isExecutable(Path.of("/bin/sh")), "needs a system with /bin/sh");
    }

    private FfmpegFilm film(FfmpegFilm.Format format, String script) throws IOException {
        Path program = folder.resolve("program");
        Files.writeString(program, "#!/bin/sh\n" + script + '\n');
        program.toFile().setExecutable(true);
        return new FfmpegFilm(program.toString(), format, 4, 2, new FrameRate(29.97), folder.resolve("out"));
    }

    @Test
    void framesArePipedAndTheFormatIsSaid() throws IOException {
        try (FfmpegFilm film = film(FfmpegFilm.Format.MP4, "echo \"$@\" >" + folder + "/line; cat >" + folder + "/out")) {
            film.frame(FRAME);
            film.frame(FRAME);
            film.end();
        }
        assertThat(folder.resolve("out")).hasSize(2 * FRAME.length);
        assertThat(folder.resolve("line")).content().contains("-f rawvideo -pixel_format rgb24 -video_size 4x2 -framerate 2997/100 -i pipe:0")
            .contains("-c:v libx264").contains("-f mp4").endsWith("file:" + folder.resolve("out") + '\n');
    }

    @Test
    void webmIsVp9() throws IOException {
        try (FfmpegFilm film = film(FfmpegFilm.Format.WEBM, "echo \"$@\" >" + folder + "/line; cat >/dev/null")) {
            film.end();
        }
        assertThat(folder.resolve("line")).content().contains("-c:v libvpx-vp9").contains("-f webm");
    }

    @Test
    void itsLastLineTellsWhyItFailed() throws IOException {
        try (FfmpegFilm film = film(FfmpegFilm.Format.MP4, "cat >/dev/null; echo first; echo; echo 'Unknown encoder' >&2; exit 3")) {
            film.frame(FRAME);
            assertThatThrownBy(film::end).isInstanceOf(IOException.class).hasMessage("ffmpeg: Unknown encoder");
        }
        try (FfmpegFilm film = film(FfmpegFilm.Format.MP4, "exit 3")) {
            assertThatThrownBy(film::end).isInstanceOf(IOException.class).hasMessage("ffmpeg: ended with 3");
        }
    }

    @Test
    void oneThatEndsInTheMiddleIsNoticed() throws IOException {
        byte[] much = new byte[1 << 20];
        try (FfmpegFilm film = film(FfmpegFilm.Format.MP4, "echo no room; exit 1")) {
            assertThatThrownBy(() -> film.frame(much)).isInstanceOf(IOException.class).hasMessage("ffmpeg: no room");
        }
        try (FfmpegFilm film = film(FfmpegFilm.Format.MP4, "exit 0")) {
            assertThatThrownBy(() -> film.frame(much)).isInstanceOf(IOException.class);
        }
    }

    @Test
    void aProgramThatIsNotThereDoesNotStart() {
        assertThatThrownBy(() -> new FfmpegFilm(folder.resolve("none").toString(), FfmpegFilm.Format.MP4, 4, 2, new FrameRate(25),
            folder.resolve("out"))).isInstanceOf(IOException.class);
    }
}
