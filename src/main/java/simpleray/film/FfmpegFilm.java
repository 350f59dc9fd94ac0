package simpleray.film;

import java.io.BufferedReader;
import java.io.Closeable;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.OutputStream;
import java.io.UncheckedIOException;
import java.nio.charset.Charset;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

/** A film that ffmpeg makes of frames that are piped to it. <em>Mutable,</em> for one thread. */
public final class FfmpegFilm implements Closeable {
    /** The program, unless another is named. */
    public static final String PROGRAM = "ffmpeg";

    private static final int MAX_FRACTION = 1_000_000_000;
    /** Sides of an even length, which the formats ask for; colours as high-definition television has it. */
    private static final String FILTER = "pad=ceil(iw/2)*2:ceil(ih/2)*2,scale=out_color_matrix=bt709";

    private final Process process;
    private final OutputStream in;
    private final Thread listener;
    private volatile String last = "";                        // what it has said last

    /** What ffmpeg makes. */
    public enum Format {
        /** H.264 in an MP4. */
        MP4("libx264", "-preset", "medium", "-crf", "18", "-movflags", "+faststart"),
        /** VP9 in a WebM. */
        WEBM("libvpx-vp9", "-b:v", "0", "-crf", "24", "-row-mt", "1");

        private final List<String> options = new ArrayList<>();

        Format(String codec, String... quality) {
            options.addAll(List.of("-c:v", codec));
            options.addAll(List.of(quality));
            options.addAll(List.of("-f", name().toLowerCase(Locale.ROOT)));
        }
    }

    /**
     * Starts ffmpeg.
     *
     * @param program its name or path
     * @param format what to make
     * @param width a frame's width in pixels
     * @param height its height
     * @param rate how many frames are shown a second
     * @param file the file to write, over what is there
     * @throws IOException if it does not start
     */
    public FfmpegFilm(String program, Format format, int width, int height, FrameRate rate, Path file) throws IOException {
        List<String> line = new ArrayList<>(List.of(program, "-hide_banner", "-loglevel", "error", "-y", "-f", "rawvideo", "-pixel_format", "rgb24",
            "-video_size", width + "x" + height, "-framerate", rate.fraction(MAX_FRACTION).toString(), "-i", "pipe:0",
            "-vf", FILTER, "-pix_fmt", "yuv420p", "-colorspace", "bt709", "-color_primaries", "bt709", "-color_trc", "bt709",
            "-fflags", "+bitexact", "-flags:v", "+bitexact"));
        line.addAll(format.options);
        line.add("file:" + file.toAbsolutePath());
        process = new ProcessBuilder(line).redirectErrorStream(true).start();
        in = process.getOutputStream();
        listener = new Thread("simpleray-ffmpeg") {
            @Override
            public void run() {
                listen();
            }
        };
        listener.setDaemon(true);
        listener.start();
    }

    private void listen() {
        try (BufferedReader said = new BufferedReader(new InputStreamReader(process.getInputStream(), Charset.defaultCharset()))) {
            said.lines().filter(line -> !line.isBlank()).forEach(line -> last = line.strip());
        } catch (IOException | UncheckedIOException e) {
            return;                                           // it has ended
        }
    }

    /**
     * Adds a frame.
     *
     * @param levels red, green and blue of each pixel from the left, the top row first
     * @throws IOException if ffmpeg takes no more; the message has its last line
     */
    public void frame(byte[] levels) throws IOException {
        try {
            in.write(levels);
        } catch (IOException e) {
            end();
            throw e;                                          // it has ended well, but too soon
        }
    }

    /**
     * Ends the film, and waits for ffmpeg.
     *
     * @throws IOException if it has failed; the message has its last line
     */
    public void end() throws IOException {
        try {
            try {
                in.close();
            } catch (IOException e) {
                // as its exit code says
            }
            int code = process.waitFor();
            listener.join();
            if (code != 0) {
                throw new IOException("ffmpeg: " + (last.isEmpty() ? "ended with " + code : last));
            }
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            throw new IOException("interrupted", e);
        }
    }

    /** Ends ffmpeg, if it is still at work: the film is not wanted any more. */
    @Override
    public void close() {
        process.destroyForcibly();
    }
}
