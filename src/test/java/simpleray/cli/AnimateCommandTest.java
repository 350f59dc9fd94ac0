package simpleray.cli;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.File;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import javax.imageio.ImageIO;
import javax.imageio.ImageReader;
import javax.imageio.stream.ImageInputStream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import simpleray.film.Turntable;
import simpleray.render.RenderRequest;
import simpleray.scene.PerspectiveCamera.Pose;
import simpleray.scene.SceneSettings;

/** {@code animate}: films as numbered pictures, and as one file. */
class AnimateCommandTest {
    private static final String STILL = "2\n0 0 0 0 0.5  1 0 0  0.5 0 0  0 0 0 0\n1 0 1 0 -1  0 0 1  0 0 0.5  0 0 0 0\n0.5 0.5 0.5\n1\n"
        + "0 1 1 1  2 2 2\nresolution 12 8\n";
    private static final String FILM = STILL + "frames 5 24\nkey 0 object 1 0 0 0\nkey 3 object 1 1 0 0\nkey 2 camera 0 0 3 0 0 0 50\n"
        + "key 4 camera 1 0 3 0 0 0 50\n";
    private static final List<String> NAMES = List.of("f.0.png", "f.1.png", "f.2.png", "f.3.png", "f.4.png");

    @TempDir
    Path folder;

    @BeforeEach
    void writeScenes() throws IOException {
        Files.writeString(folder.resolve("film.scene"), FILM);
        Files.writeString(folder.resolve("still.scene"), STILL);
    }

    private Program.Result run(String line) {
        return InProcess.run(line.replace("@", folder + "/").split(" "));
    }

    private void good(String line) {
        Program.Result result = run(line);

        assertThat(result.err()).isEmpty();
        assertThat(result.exitCode()).isZero();
    }

    private byte[] bytes(String name) throws IOException {
        return Files.readAllBytes(folder.resolve(name));
    }

    private List<String> files() throws IOException {
        try (Stream<Path> files = Files.list(folder)) {
            return files.map(file -> file.getFileName().toString()).filter(name -> !name.endsWith(".scene")).sorted().toList();
        }
    }

    /** From (0, 0, 5) to (0, 4, 5) in 4 frames: at frame 2 the view is along (0, -2, -5). */
    @Test
    void aFrameThatLooksAlongUpIsAnErrorBeforeTheFirst() throws IOException {
        String keys = STILL.strip() + "\nframes 5 25\ncurve linear\nkey 0 camera 0 0 5 0 0 0 40\nkey 4 camera 0 4 5 0 0 0 40\n";
        Files.writeString(folder.resolve("rising.scene"), keys);
        Files.writeString(folder.resolve("bad.scene"), keys + "up 0 2 5\n");
        Program.Result option = run("animate @rising.scene -o @u.%d.png --up 0,2,5 -q");
        Program.Result file = run("animate @bad.scene -o @u.%d.png -q");

        assertThat(option.exitCode()).isEqualTo(2);
        assertThat(option.err()).startsWith("simpleray animate: expected frame 2's camera with a view that is not along up, "
            + "found 0.0 2.0 5.0 0.0 0.0 0.0 40.0").hasLineCount(1);
        assertThat(file.exitCode()).isEqualTo(65);
        assertThat(file.err()).contains("error: expected frame 2's camera with a view that is not along up");
        assertThat(files()).isEmpty();
        good("animate @rising.scene -o @u.%d.png --up 0,2,5 --camera 0,0,5,0,0,0,40 -q --frames 2 --size 4x3");
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 2})
    void eachFrameIsWhatRenderMakesOfItByteForByte(int threads) throws IOException {
        good("animate @film.scene -o @f.%d.png --threads " + threads + " -q");

        assertThat(files()).isEqualTo(NAMES);
        for (int f = 0; f < 5; f++) {
            good("render @film.scene --frame " + f + " -o @one.png -q");
            assertThat(bytes("f." + f + ".png")).as("frame %d", f).isEqualTo(bytes("one.png"));
            assertThat(run("verify @f." + f + ".png").exitCode()).isZero();
        }
    }

    @Test
    void someFramesKeepTheirNumbers() throws IOException {
        Program.Result result = run("animate @film.scene -o @f.%03d.png --frames 3-4,1 --size 6x4 --progress plain");

        assertThat(files()).containsExactly("f.001.png", "f.003.png", "f.004.png");
        assertThat(result.err().lines()).anyMatch(line -> line.startsWith(" 66 %, 2 of 3 frames, "))
            .last().asString().matches(".*f\\.%03d\\.png: 3 frames of 6x4, .* s");
        good("render @film.scene --frame 3 -o @one.png --size 6x4 -q");
        assertThat(bytes("f.003.png")).isEqualTo(bytes("one.png"));
    }

    @Test
    void aSceneWithoutFramesIsAFilmOfOne() throws IOException {
        good("animate @still.scene -o @f.%d.png -q");
        good("render @still.scene -o @one.png -q");

        assertThat(bytes("f.0.png")).isEqualTo(bytes("one.png"));
        assertThat(files()).hasSize(2);
    }

    @Test
    void onATurntableTheCameraGoesRound() throws IOException {
        good("animate @still.scene --turntable 4 -o @f.%d.png --cop 3 --depth 2 -q");
        SceneSettings asked = new SceneSettings();
        asked.cop = 3.0;
        SceneSettings still = new SceneSettings();
        still.resolution = new SceneSettings.Resolution(12, 8);
        Turntable table = new Turntable(still, new RenderRequest().with(asked), 4);

        assertThat(files()).isEqualTo(NAMES.subList(0, 4));
        for (int f = 0; f < 4; f++) {
            Pose p = table.camera(f).camera;
            good("render @still.scene --depth 2 -o @one.png -q --camera " + p.ex() + ',' + p.ey() + ',' + p.ez() + ',' + p.lx() + ',' + p.ly()
                + ',' + p.lz() + ',' + p.fov());
            assertThat(bytes("f." + f + ".png")).as("frame %d", f).isEqualTo(bytes("one.png"));
        }
    }

    @Test
    void aTurntableHasAsManyFramesAsTheSceneOr120() {
        assertThat(run("animate --turntable @still.scene -o @f.%d.png --size 2x2").err()).contains(": 120 frames of 2x2, ");
        assertThat(run("animate @film.scene -o @g.%d.png --size 2x2 --turntable").err()).contains(": 5 frames of 2x2, ");
        assertThat(run("animate @film.scene -o @h.%d.png --size 2x2 --turntable 7").err()).contains(": 7 frames of 2x2, ");
    }

    @Test
    void aGifHasTheFramesAndTheRate() throws IOException {
        good("animate @film.scene -o @film.gif -q");
        good("animate @film.scene -o @f.%d.png -q");

        try (ImageInputStream in = ImageIO.createImageInputStream(folder.resolve("film.gif").toFile())) {
            ImageReader reader = ImageIO.getImageReadersByFormatName("gif").next();
            reader.setInput(in);
            assertThat(reader.getNumImages(true)).isEqualTo(5);
            for (int f = 0; f < 5; f++) {
                assertThat(reader.read(f).getRGB(0, 0, 12, 8, null, 0, 12))
                    .isEqualTo(ImageIO.read(folder.resolve("f." + f + ".png").toFile()).getRGB(0, 0, 12, 8, null, 0, 12));
            }
        }
        assertThat(files()).as("no frame is left").hasSize(6);
        assertThat(run("animate @film.scene -o @fast.gif --fps 60").err())
            .startsWith("simpleray: " + folder + "/fast.gif: most programs show at most 50 frames a second of a GIF, and this one has 60.0\n");
    }

    /** Its first picture is that of the first frame, for programs that know no APNG, and carries its scene. */
    @Test
    void anApngIsItsFirstFrameToo() throws IOException {
        good("animate @film.scene -o @film.apng --frames 2-4 --fps 30000/1001 -q");
        good("render @film.scene --frame 2 -o @one.png -q");

        assertThat(run("verify @film.apng").text()).endsWith(": good: all 96 pixels are the same\n");
        assertThat(run("compare @film.apng @one.png").exitCode()).isZero();
        assertThat(new String(bytes("film.apng"), StandardCharsets.ISO_8859_1)).contains("acTL\0\0\0\3\0\0\0\0", "\003\351\165\060");
        assertThat(files()).containsExactly("film.apng", "one.png");
    }

    @Test
    void wholeFramesStayAndBrokenOnesAreMadeAgain() throws IOException {
        good("animate @film.scene -o @f.%d.png -q");
        List<byte[]> whole = List.of(bytes("f.0.png"), bytes("f.1.png"), bytes("f.2.png"), bytes("f.3.png"), bytes("f.4.png"));
        FileTime old = FileTime.from(1000, TimeUnit.SECONDS);
        Files.delete(folder.resolve("f.3.png"));
        Files.write(folder.resolve("f.1.png"), Arrays.copyOf(whole.get(1), 300));
        for (int f : new int[] {0, 2, 4}) {
            Files.setLastModifiedTime(folder.resolve("f." + f + ".png"), old);
        }

        Program.Result result = run("animate @film.scene -o @f.%d.png --resume");

        assertThat(result.err()).startsWith("simpleray: going on with 3 of 5 frames, kept in " + folder + "/f.%d.png\n");
        for (int f = 0; f < 5; f++) {
            assertThat(bytes("f." + f + ".png")).isEqualTo(whole.get(f));
            assertThat(Files.getLastModifiedTime(folder.resolve("f." + f + ".png")).equals(old)).as("frame %d", f).isEqualTo(f % 2 == 0);
        }
        assertThat(files()).isEqualTo(NAMES);
    }

    @ParameterizedTest
    @ValueSource(strings = {"--depth 3", "--frames 0 --size 6x4", "--stage lighting"})
    void aFrameOfAnotherFilmIsRefusedAndStays(String options) throws IOException {
        good("animate @film.scene -o @f.%d.png -q " + options);
        byte[] other = bytes("f.0.png");

        Program.Result result = run("animate @film.scene -o @f.%d.png --resume");

        assertThat(result.err()).isEqualTo("simpleray: " + folder + "/f.0.png: is not frame 0 of this film, or was made with other options or by "
            + "another version: without --resume it is written over\n");
        assertThat(result.exitCode()).isEqualTo(ExitCode.BAD_SCENE);
        assertThat(bytes("f.0.png")).isEqualTo(other);
    }

    @ParameterizedTest
    @ValueSource(strings = {"gif", "apng"})
    void aFilmGoesOnWithTheFramesBesideIt(String kind) throws IOException {
        good("animate @film.scene -o @whole." + kind + " -q");
        Files.createDirectory(folder.resolve("film." + kind + ".frames"));
        good("animate @film.scene -o @film." + kind + ".frames/%06d.png --frames 1-2 -q");
        good("animate @still.scene -o @still." + kind + " -q");

        Program.Result refused = run("animate @film.scene -o @film." + kind);
        assertThat(refused.err()).isEqualTo("simpleray: " + folder + "/film." + kind + ".frames holds frames of an earlier run: --resume goes on with "
            + "them, --restart discards them\n");
        assertThat(refused.exitCode()).isEqualTo(ExitCode.NO_OUTPUT);
        Program.Result foreign = run("animate @film.scene --depth 1 --resume -o @film." + kind);
        assertThat(foreign.err()).contains("/000001.png: is not frame 1 of this film").endsWith(": --restart discards it\n");
        assertThat(foreign.exitCode()).isEqualTo(ExitCode.BAD_SCENE);
        Program.Result result = run("animate @film.scene --resume -o @film." + kind);
        assertThat(result.err()).startsWith("simpleray: going on with 2 of 5 frames, kept in ");
        assertThat(bytes("film." + kind)).isEqualTo(bytes("whole." + kind));
        assertThat(run("animate @film.scene --resume -o @film." + kind).err()).startsWith("simpleray: no frame is kept: beginning with the first\n");
        Files.createDirectory(folder.resolve("film." + kind + ".frames"));
        good("animate @still.scene -o @film." + kind + ".frames/%06d.png -q");
        good("animate @film.scene --restart -q -o @film." + kind);
        assertThat(bytes("film." + kind)).isEqualTo(bytes("whole." + kind));
        assertThat(files()).containsExactly("film." + kind, "still." + kind, "whole." + kind);
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {
        "@film.scene -o @f.png | the output @f.png has no place for the frame's number: expected one such as film.%04d.png (%% is a per cent sign), or a .gif, .apng, .mp4 or .webm",
        "@film.scene -o @%d%d.png | the output @%d%d.png has 2 places for the frame's number: expected one such as film.%04d.png (%% is a per cent sign), or a .gif, .apng, .mp4 or .webm",
        "@film.scene -o @%s.png | the output @%s.png has a % that stands for no number: expected one such as film.%04d.png (%% is a per cent sign), or a .gif, .apng, .mp4 or .webm",
        "@film.scene -o @%d.gif | the output @%d.gif has a place for numbers: numbered frames are PNG files such as film.%04d.png",
        "@film.scene -o @f.avi | a film is written as numbered PNG files such as film.%04d.png, or as .gif, .apng, .mp4 or .webm, and not as @f.avi",
        "@film.scene -o - | a film is written as numbered PNG files such as film.%04d.png, or as .gif, .apng, .mp4 or .webm, and not as -",
        "@film.scene -o @%d.png --frames 3-5 | the film has the frames 0 to 4, and not 5",
        "@film.scene -o @%d.png --turntable 2 --frames 2 | the film has the frames 0 to 1, and not 2",
        "@film.scene -o @%d.png --turntable 0 | --turntable must be 1 to 1000000, and is '0'",
        "@film.scene -o @%d.png --turntable=x | --turntable must be 1 to 1000000, and is 'x'",
        "@film.scene -o @%d.png --turntable 1000001 | --turntable must be 1 to 1000000, and is '1000001'",
        "@film.scene -o @f.mp4 --resume | --resume needs frames that stay: those of @f.mp4 go to ffmpeg at once; film.%04d.png keeps them, and ffmpeg makes a film of these",
        "@film.scene -o @f.gif --fps 0.001 | a GIF shows a frame for at most 655.35 s, and 0.001 frames a second are fewer",
        "@film.scene -o @f.apng --fps 0.00001 | a frame is shown for at most 65535 s, and 1.0E-5 frames a second are fewer",
        "@film.scene -o @f.gif --cop 0 | the centre of projection must be above 0, and is 0.0"})
    void whatMakesNoSenseIsAUsageError(String line, String message) throws IOException {
        Program.Result result = run("animate " + line);

        assertThat(result.err()).isEqualTo("simpleray animate: " + message.replace("@", folder + "/") + " (see simpleray animate --help)\n");
        assertThat(result.exitCode()).isEqualTo(ExitCode.USAGE);
        assertThat(files()).isEmpty();
    }

    @ParameterizedTest
    @ValueSource(strings = {"--fps 0", "--fps 1001", "--fps x", "--fps 1/0", "--frames 2-1", "--frames x"})
    void aValueThatIsNoneIsAUsageError(String option) {
        Program.Result result = run("animate @film.scene -o @%d.png " + option);

        assertThat(result.err()).contains(option.startsWith("--fps") ? "expected frames a second above 0 and at most 1000, such as 25 or 30000/1001, found '"
            : "expected numbers of frames such as 0-99,120, found '").hasLineCount(1);
        assertThat(result.exitCode()).isEqualTo(ExitCode.USAGE);
    }

    /** Here the scene is read from a picture that has the name of a frame. */
    @Test
    void noFrameIsWrittenOverTheScene() throws IOException {
        good("render @still.scene -o @f.2.png -q");
        byte[] scene = bytes("f.2.png");

        Program.Result result = run("animate @f.2.png --turntable 3 -o @f.%d.png");

        assertThat(result.err()).isEqualTo("simpleray animate: the output " + folder + "/f.2.png is the scene itself (see simpleray animate --help)\n");
        assertThat(result.exitCode()).isEqualTo(ExitCode.USAGE);
        assertThat(bytes("f.2.png")).isEqualTo(scene);
        assertThat(files()).containsExactly("f.2.png");
    }

    @Test
    void aFolderThatIsNotThereIs73() {
        for (String name : List.of("none/%d.png", "none/f.gif")) {
            Program.Result result = run("animate @film.scene -o @" + name);

            assertThat(result.err()).endsWith(": cannot be created: there is no folder " + folder + "/none\n");
            assertThat(result.exitCode()).isEqualTo(ExitCode.NO_OUTPUT);
        }
    }

    @Test
    void aFullDiskIs74() throws IOException {
        assumeTrue(Files.exists(Path.of("/dev/full")), "no /dev/full here");
        for (String kind : List.of("gif", "apng")) {
            Path full = Files.createSymbolicLink(folder.resolve("full." + kind), Path.of("/dev/full"));

            Program.Result result = run("animate @film.scene -o " + full);

            Files.delete(full);
            assertThat(result.err()).isEqualTo("simpleray: " + full + ": cannot be written: No space left on device\n");
            assertThat(result.exitCode()).isEqualTo(ExitCode.WRITE_ERROR);
        }
    }

    private static boolean isThere(String program) {
        return Stream.of(System.getenv("PATH").split(File.pathSeparator)).anyMatch(path -> Files.isExecutable(Path.of(path, program)));
    }

    /** Sides of an odd length get a column or row more. */
    @ParameterizedTest
    @CsvSource({"mp4, h264", "webm, vp9"})
    void ffmpegMakesAFilmOfTheFrames(String kind, String codec) throws IOException, InterruptedException {
        assumeTrue(isThere("ffmpeg") && isThere("ffprobe"), "no ffmpeg here");
        good("animate @film.scene -o @film." + kind + " --size 31x20 --fps 30000/1001 -q");

        Process probe = new ProcessBuilder("ffprobe", "-v", "error", "-count_frames", "-show_entries",
            "stream=codec_name,width,height,avg_frame_rate,nb_read_frames", "-of", "csv=p=0", folder.resolve("film." + kind).toString()).start();
        assertThat(Program.finish(probe, new byte[0]).text().strip()).isEqualTo(codec + ",32,20,30000/1001,5");
        assertThat(files()).containsExactly("film." + kind);
    }

    @Test
    void withoutFfmpegIs69() throws IOException, InterruptedException {
        ProcessBuilder builder = Program.program(folder, List.of(), "animate", "film.scene", "-o", "film.mp4");
        builder.environment().put("PATH", folder.toString());

        Program.Result result = Program.finish(builder.start(), new byte[0]);

        assertThat(result.err()).isEqualTo("simpleray: film.mp4: ffmpeg makes it, and is not on the PATH: install it (Debian: apt-get install ffmpeg), "
            + "or make a .gif or .apng\n");
        assertThat(result.exitCode()).isEqualTo(ExitCode.UNAVAILABLE);
        assertThat(files()).isEmpty();
    }

    @Test
    @Timeout(value = 120, threadMode = Timeout.ThreadMode.SEPARATE_THREAD)
    void oneThatIsToldToStopSaysHowToGoOn() throws IOException, InterruptedException {
        String[] line = {"animate", "film.scene", "-o", "film.gif", "--threads", "1", "--size", "200x150", "--turntable", "40", "--progress", "plain"};
        Path err = folder.resolve("err.scene");
        Process process = Program.program(folder, List.of(), line).redirectError(err.toFile()).start();
        assumeTrue(process.supportsNormalTermination(), "no SIGTERM here");
        try {
            while (process.isAlive() && !Files.readString(err).startsWith(" 10 %, 4 of 40 frames, ")) {
                Thread.sleep(20);
            }
            process.destroy();                                // which closes its streams, but not the file
            assertThat(process.waitFor(30, TimeUnit.SECONDS)).isTrue();
        } finally {
            process.destroyForcibly();
        }
        String said = Files.readAllLines(err).stream().reduce((a, b) -> b).orElseThrow();
        assertThat(process.exitValue()).isEqualTo(ExitCode.TERMINATED);
        assertThat(said).matches("simpleray: interrupted: \\d+ of 40 frames are kept in film\\.gif\\.frames; to go on: simpleray animate film\\.scene "
            + "-o film\\.gif --threads 1 --size 200x150 --turntable 40 --progress plain --resume");
        assertThat(files()).as("no half file").containsExactly("film.gif.frames");
        Program.Result result = run("animate @film.scene -o @film.gif --size 200x150 --turntable 40 --resume");
        assertThat(result.err()).contains("going on with ").doesNotContain("going on with 0");
        good("animate @film.scene -o @whole.gif --size 200x150 --turntable 40 -q");
        assertThat(bytes("film.gif")).isEqualTo(bytes("whole.gif"));
        assertThat(files()).containsExactly("film.gif", "whole.gif");
    }

    @Test
    @Timeout(value = 120, threadMode = Timeout.ThreadMode.SEPARATE_THREAD)
    void anFfmpegThatTakesNoFrameEndsWithTheProgram() throws IOException, InterruptedException {
        Path bin = Files.createDirectory(folder.resolve("bin"));
        Path pid = folder.resolve("pid.scene");
        Path ffmpeg = Files.writeString(bin.resolve("ffmpeg"), "#!/bin/sh\necho $$ >" + pid + "\nexec sleep 100\n");
        assumeTrue(ffmpeg.toFile().setExecutable(true) && Files.isExecutable(Path.of("/bin/sh")), "no scripts here");
        ProcessBuilder program = Program.program(folder, List.of(), "animate", "film.scene", "-o", "film.mp4", "--size", "400x300", "--turntable", "9");
        program.environment().merge("PATH", bin.toString(), (old, own) -> own + File.pathSeparator + old);
        Process process = program.redirectErrorStream(true).redirectOutput(folder.resolve("err.scene").toFile()).start();
        assumeTrue(process.supportsNormalTermination(), "no SIGTERM here");
        try {
            while (process.isAlive() && (!Files.exists(pid) || Files.size(pid) == 0)) {
                Thread.sleep(20);
            }
            Thread.sleep(1000);                               // it waits for ffmpeg, or renders still: both must end
            process.destroy();
            assertThat(process.waitFor(30, TimeUnit.SECONDS)).isTrue();
        } finally {
            process.destroyForcibly();
        }
        assertThat(process.exitValue()).isEqualTo(ExitCode.TERMINATED);
        assertThat(files()).containsExactly("bin");
        assertThat(ProcessHandle.of(Long.parseLong(Files.readString(pid).strip())).filter(ProcessHandle::isAlive)).isEmpty();
    }

    @ParameterizedTest
    @ValueSource(strings = {"film.gif", "%d.png"})
    @Timeout(value = 120, threadMode = Timeout.ThreadMode.SEPARATE_THREAD)
    void oneThatIsKilledGoesOnToTheSameBytes(String out) throws IOException, InterruptedException {
        String line = "--size 200x150 --turntable 30 --threads 1";
        Path err = folder.resolve("err.scene");
        Process process = Program.program(folder, List.of(), ("animate film.scene --progress plain -o " + out + ' ' + line).split(" "))
            .redirectError(err.toFile()).start();
        try {
            while (process.isAlive() && !Files.readString(err).startsWith(" 10 %, 3 of 30 frames, ")) {
                Thread.sleep(20);
            }
        } finally {
            process.destroyForcibly();                        // kill -9
        }
        assertThat(process.waitFor(30, TimeUnit.SECONDS)).isTrue();
        assertThat(process.exitValue()).isNotZero();
        Files.delete(err);
        assertThat(folder.resolve("film.gif")).doesNotExist();

        Program.Result result = run("animate @film.scene --resume -o @" + out + ' ' + line);

        assertThat(result.exitCode()).as(result.err()).isZero();
        assertThat(result.err()).containsPattern("going on with [1-9]\\d* of 30 frames");
        List<String> there = files();
        Files.createDirectory(folder.resolve("unbroken"));
        good("animate @film.scene -q -o @unbroken/" + out + ' ' + line);
        assertThat(there).hasSize(out.equals("film.gif") ? 1 : 30).allSatisfy(name ->
            assertThat(bytes(name)).as(name).isEqualTo(bytes("unbroken/" + name)));
    }

    @Test
    void aRegionIsThatOfEachFrame() throws IOException {
        good("animate @film.scene -o @f.%d.png --region 2,1,6,5 -q");
        good("render @film.scene --frame 3 -o @one.png --region 2,1,6,5 -q");

        assertThat(bytes("f.3.png")).isEqualTo(bytes("one.png"));
        assertThat(run("animate @film.scene -o @g.%d.png --region 20,1,6,5").exitCode()).isEqualTo(ExitCode.USAGE);
    }

    @Test
    void statisticsAreThoseOfAllFrames() {
        Program.Result one = run("animate @film.scene -o @f.%d.png --frames 0 --stats json -q");
        Program.Result two = run("animate @film.scene -o @f.%d.png --frames 0,1 --stats json -q");

        assertThat(one.text()).contains("\"primary\":96,");
        assertThat(two.text()).contains("\"primary\":192,");
    }

    /** Frames 0 to 2 are alike, and 4 to 6: three are rendered, of 96 pixels each. */
    @ParameterizedTest
    @ValueSource(strings = {"f.%d.png", "f.apng", "f.gif"})
    void framesInWhichNothingHasChangedAreNotRenderedAgain(String output) throws IOException {
        Files.writeString(folder.resolve("holds.scene"), STILL + "frames 7 24\nkey 2 object 1 0 0 0\nkey 4 object 1 1 0 0\n");
        Program.Result result = run("animate @holds.scene -o @" + output + " --stats json -q");

        assertThat(result.text()).contains("\"primary\":288,");
        good("animate @holds.scene -o @g.%d.png -q");
        for (int f = 0; f < 7; f++) {
            good("render @holds.scene --frame " + f + " -o @one.png -q");
            assertThat(bytes("g." + f + ".png")).as("frame %d", f).isEqualTo(bytes("one.png"));
        }
    }

    @Test
    void whatStaysOfAnEndedRunIsNotTheFrameThatIsRepeated() throws IOException {
        Files.writeString(folder.resolve("holds.scene"), STILL + "frames 5 24\nkey 0 light 1 0 0 0\n");
        good("animate @holds.scene -o @f.%d.png -q");
        byte[] whole = bytes("f.3.png");
        for (int f : new int[] {0, 2, 3}) {
            Files.delete(folder.resolve("f." + f + ".png"));
        }
        Program.Result result = run("animate @holds.scene -o @f.%d.png --resume --stats json -q");

        assertThat(result.text()).contains("\"primary\":96,");
        assertThat(files()).isEqualTo(NAMES);
        assertThat(bytes("f.3.png")).isEqualTo(whole);
    }

    /** Frames 0 to 4 are alike: whether rendered or written again, the one that cannot be written is named. */
    @ParameterizedTest
    @ValueSource(ints = {0, 1})
    void aFrameThatTheDiskDoesNotTakeIsNamed(int frame) throws IOException {
        assumeTrue(Files.exists(Path.of("/dev/full")), "no full device here");
        Files.createSymbolicLink(folder.resolve("f." + frame + ".png"), Path.of("/dev/full"));
        Files.writeString(folder.resolve("holds.scene"), STILL + "frames 5 24\n");
        Program.Result result = run("animate @holds.scene -o @f.%d.png -q");

        assertThat(result.exitCode()).isEqualTo(ExitCode.WRITE_ERROR);
        assertThat(result.err()).startsWith("simpleray: " + folder.resolve("f." + frame + ".png") + ": cannot be written: ").hasLineCount(1);
    }

    @Test
    void whereNothingCanBeCreatedNothingIsWritten() throws IOException {
        Files.createDirectory(folder.resolve("f.1.png"));
        Files.writeString(folder.resolve("g.gif.frames"), "a file");
        Files.writeString(folder.resolve("holds.scene"), STILL + "frames 5 24\n");
        Program.Result frames = run("animate @holds.scene -o @f.%d.png -q");
        Program.Result film = run("animate @holds.scene -o @g.gif -q");

        assertThat(frames.exitCode()).isEqualTo(ExitCode.NO_OUTPUT);
        assertThat(frames.err()).contains("f.1.png: cannot be created: ").hasLineCount(1);
        assertThat(film.exitCode()).isEqualTo(ExitCode.NO_OUTPUT);
        assertThat(film.err()).contains("g.gif.frames").hasLineCount(1);
        assertThat(files()).containsExactly("f.0.png", "f.1.png", "g.gif.frames");
    }

    @Test
    void whatFfmpegCannotTakeIsRefusedAtOnce() throws IOException {
        Files.createSymbolicLink(folder.resolve("f.mp4"), Path.of("/dev/null"));
        Program.Result device = run("animate @film.scene -o @f.mp4");
        Program.Result large = run("animate @film.scene -o @g.mp4 --size 40000x40000");

        assertThat(device.exitCode()).isEqualTo(ExitCode.USAGE);
        assertThat(device.err()).contains("f.mp4 is no file, which ffmpeg needs").hasLineCount(1);
        assertThat(large.exitCode()).isEqualTo(ExitCode.USAGE);
        assertThat(large.err()).contains("a film of frames of 40000x40000 is too large for ffmpeg").hasLineCount(1);
    }
}
