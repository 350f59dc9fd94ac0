package simpleray.cli;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class JobCommandTest {
    private static final String TRIANGLE = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
    private static final String MATERIAL = " 0 0 0 1 1 1 0 0 0 1 ";

    @TempDir
    Path folder;
    private Path scene;
    private Path job;

    @BeforeEach
    void writeScene() throws IOException {
        scene = Files.writeString(folder.resolve("ball.scene"), SmallScenes.ROUGH);
        job = folder.resolve("job");
    }

    private static Program.Result run(Path scene, Path job, String options) {
        List<String> words = Stream.of(List.of("job", scene.toString(), "-o", job.toString()), List.of(options.split(" ")))
            .flatMap(List::stream).toList();
        return InProcess.run(words.toArray(String[]::new));
    }

    private void assertRefused(Program.Result result, int exitCode, String message) {
        assertThat(result.err()).isEqualTo(message + '\n');
        assertThat(result.exitCode()).isEqualTo(exitCode);
        assertThat(result.out()).isEmpty();
        assertThat(job).doesNotExist();
    }

    private static List<String> files(Path folder) throws IOException {
        try (Stream<Path> all = Files.walk(folder)) {
            return all.filter(Files::isRegularFile).map(file -> folder.relativize(file).toString().replace('\\', '/')).sorted().toList();
        }
    }

    @Test
    void aJobForSlurmIsAFolder() throws IOException {
        Program.Result result = run(scene, job, "--for slurm --bands 3 --size 40x30");

        assertThat(result.err()).isEqualTo(job + ": one picture of 40x30 in 3 bands, 3 tasks: README.txt there says how to run them\n");
        assertThat(result.exitCode()).isZero();
        assertThat(files(job)).containsExactly("README.txt", "job.sh", "merge.sbatch", "render.sbatch", "scene/ball.scene");
        assertThat(job.resolve("scene/ball.scene")).hasSameBinaryContentAs(scene);
        assertThat(job.resolve("log")).isEmptyDirectory();
        assertThat(job.resolve("parts")).isEmptyDirectory();
        assertThat(job.resolve("render.sbatch")).content().contains("#SBATCH --job-name=ball\n", "#SBATCH --array=0-2%3\n",
            "#SBATCH --requeue\n", "#SBATCH --time=5\n", "#SBATCH --cpus-per-task=1\n", "#SBATCH --output=log/%x-%A_%a.txt\n")
            .containsPattern("#SBATCH --mem=\\d{3,4}M\n").endsWith("\nexec sh job.sh task \"$SLURM_ARRAY_TASK_ID\"\n");
        assertThat(job.resolve("merge.sbatch")).content().contains("#SBATCH --job-name=ball-merge\n").doesNotContain("--array")
            .endsWith("\nexec sh job.sh finish\n");
        assertThat(job.resolve("job.sh")).content().contains("scene='scene/ball.scene'\n", " --size 40x30 ", "bands=3 chunk=1 ");
        assertThat(job.resolve("README.txt")).content().hasLineCount(10)
            .contains("    job=$(sbatch --parsable render.sbatch) && sbatch --dependency=afterany:${job%%;*} merge.sbatch\n");
    }

    @Test
    void aJobForOpenJobDescriptionIsAFolder() throws IOException {
        Program.Result result = run(scene, job, "--for OpenJD --bands 2 --camera 0,0,5,0,0,0,40 --stage lighting --samples adaptive");

        assertThat(result.exitCode()).as(result.err()).isZero();
        assertThat(files(job)).containsExactly("README.txt", "job.sh", "scene/ball.scene", "template.json");
        assertThat(job.resolve("README.txt")).content().hasLineCount(10).contains("    openjd check template.json && openjd run template.json\n");
        assertThat(job.resolve("job.sh")).content().contains(
            "program \"$what\" \"$scene\" --stage lighting --samples adaptive --camera 0,0,5,0,0,0,40 \"$@\"\n");
        assertThat(job.resolve("template.json")).content().contains("\"name\": \"ball\"", "{\"name\": \"Band\", \"type\": \"INT\", \"range\": \"1-2\"}",
            "\"dependencies\": [{\"dependsOn\": \"Render\"}]").doesNotContain("TASK_CHUNKING", "Frame", folder.toString());
    }

    @Test
    void withoutBandsThereIsNothingToMerge() throws IOException {
        assertThat(run(scene, job, "--for openjd").exitCode()).isZero();

        assertThat(job.resolve("template.json")).content().doesNotContain("parameterSpace", "Merge", "Film");
        assertThat(job.resolve("parts")).doesNotExist();
    }

    private void writeFilm(int frames) throws IOException {
        Files.writeString(scene, SmallScenes.ROUGH.stripTrailing() + "\nframes " + frames + " 24\nkey 0 light 1 0 0 0\n");
    }

    @Test
    void aFilmIsItsFramesInChunks() throws IOException {
        writeFilm(24);

        Program.Result result = run(scene, job, "--for openjd --bands 3 --chunk 5 --frames 20-23,0-9 --size 40x30");

        assertThat(result.err()).isEqualTo(job + ": 14 frames of 40x30 in 3 bands each, 9 tasks: README.txt there says how to run them\n");
        assertThat(job.resolve("frames")).isEmptyDirectory();
        assertThat(job.resolve("job.sh")).content().contains("still= frames=0-9,20-23\nbands=3 chunk=5 digits=4 ", "film='film.apng'\n");
        assertThat(job.resolve("template.json")).content().contains("\"extensions\": [\"TASK_CHUNKING\"]", "{\"name\": \"Frame\", "
            + "\"type\": \"CHUNK[INT]\", \"range\": \"0-9,20-23\", \"chunks\": {\"defaultTaskCount\": 5, \"rangeConstraint\": \"CONTIGUOUS\"}}",
            "\"name\": \"Film\",\n      \"dependencies\": [{\"dependsOn\": \"Merge\"}]");
    }

    @Test
    void aTaskOfOneFrameNeedsNoChunks() throws IOException {
        writeFilm(24);

        assertThat(run(scene, job, "--for openjd --film my.gif").exitCode()).isZero();

        assertThat(job.resolve("template.json")).content().contains("{\"name\": \"Frame\", \"type\": \"INT\", \"range\": \"0-23\"}",
            "\"name\": \"Film\",\n      \"dependencies\": [{\"dependsOn\": \"Render\"}]").doesNotContain("extensions", "Band");
        assertThat(job.resolve("job.sh")).content().contains("film='my.gif'\n");
        assertThat(job.resolve("README.txt")).content().contains("Pictures are in frames/, and the film is my.gif.");
    }

    @ParameterizedTest
    @ValueSource(strings = {"--film none", "--frames 5"})
    void aFilmMayBeLeftOut(String options) throws IOException {
        writeFilm(24);

        assertThat(run(scene, job, "--for openjd " + options).exitCode()).isZero();

        assertThat(job.resolve("template.json")).content().doesNotContain("Film\"");
        assertThat(job.resolve("job.sh")).content().contains("film=\n");
    }

    @Test
    void aFrameBeyondTheFilmIs2() throws IOException {
        writeFilm(24);

        assertRefused(run(scene, job, "--for slurm --frames 0-24"), ExitCode.USAGE,
            "simpleray job: --frames must be from 0 to 23, and there is 24 (see simpleray job --help)");
        assertThat(run(scene, job, "--for slurm --frames 0-23 --chunk 100").err()).contains(": 24 frames of ", ", 1 task: ");
    }

    @Test
    void aFolderThatIsEmptyWillDo() throws IOException {
        Files.createDirectory(job);

        assertThat(run(scene, job, "--for openjd").exitCode()).isZero();
    }

    @Test
    void foldersAboveItAreMade() {
        assertThat(run(scene, folder.resolve("a/b/c"), "--for openjd").exitCode()).isZero();
        assertThat(folder.resolve("a/b/c/README.txt")).exists();
    }

    @Test
    void aFolderThatIsNotEmptyIs73() throws IOException {
        Files.createDirectory(job);
        Files.writeString(job.resolve("mine"), "mine");

        Program.Result result = run(scene, job, "--for slurm");

        assertThat(result.err()).isEqualTo("simpleray: " + job + ": is not empty: a job has a folder of its own\n");
        assertThat(result.exitCode()).isEqualTo(ExitCode.NO_OUTPUT);
        assertThat(files(job)).containsExactly("mine");
    }

    @Test
    void aFileInThePlaceOfTheFolderIs73() throws IOException {
        Files.writeString(job, "mine");

        Program.Result result = run(scene, job, "--for slurm");

        assertThat(result.err()).isEqualTo("simpleray: " + job + ": cannot be created: " + job + " is no folder\n");
        assertThat(result.exitCode()).isEqualTo(ExitCode.NO_OUTPUT);
        assertThat(job).hasContent("mine");
    }

    @Test
    void aFolderThatMayNotBeWrittenIs73() {
        Path read = Path.of("/proc/self");
        assumeTrue(Files.isDirectory(read), "no folder that nobody may write");

        Program.Result result = run(scene, read.resolve("job"), "--for slurm");

        assertThat(result.err()).startsWith("simpleray: " + read.resolve("job") + ": cannot be created: ").hasLineCount(1);
        assertThat(result.exitCode()).isEqualTo(ExitCode.NO_OUTPUT);
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {
        "--bands 0|--bands must be 1 or more, and is 0",
        "--bands -1|--bands must be 1 or more, and is -1",
        "--bands 31 --size 40x30|--bands must be at most the picture's 30 rows, and is 31",
        "--chunk 0|--chunk must be 1 or more, and is 0",
        "--chunk x|Invalid value for option '--chunk': 'x' is not an int",
        "--frames 1|--frames must be from 0 to 0, and there is 1",
        "--frames 3-1|Invalid value for option '--frames': expected frames such as 0-99,120, found '3-1'",
        "--frames|Missing required parameter for option '--frames' (FRAMES)",
        "--film a/b.gif|Invalid value for option '--film': expected a name of letters and digits that ends with .apng or .gif, or none, found 'a/b.gif'",
        "--film x.mp4|Invalid value for option '--film': expected a name of letters and digits that ends with .apng or .gif, or none, found 'x.mp4'",
        "--depth -1|the depth must be 0 to 1000, and is -1"})
    void optionsThatMakeNoSenseAre2(String options, String message) {
        assertRefused(run(scene, job, "--for slurm " + options), ExitCode.USAGE, "simpleray job: " + message + " (see simpleray job --help)");
    }

    @Test
    void asManyBandsAsRowsAreAllowed() {
        assertThat(run(scene, job, "--for slurm --bands 30 --size 40x30").exitCode()).isZero();
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {"--for lsf|Invalid value for option '--for': expected one of [openjd, slurm], found 'lsf'",
        "--bands 1|Missing required option: '--for=ENGINE'"})
    void theEngineMustBeKnown(String options, String message) {
        assertRefused(run(scene, job, options), ExitCode.USAGE, "simpleray job: " + message + " (see simpleray job --help)");
    }

    @Test
    void standardInputHasNoMeshesBesideIt() {
        assertRefused(run(Path.of("-"), job, "--for slurm"), ExitCode.USAGE, "simpleray job: a job needs a scene's file, and standard input is "
            + "none: its meshes are copied with it (see simpleray job --help)");
    }

    @Test
    void aBadSceneLeavesNoFolder() throws IOException {
        Files.writeString(scene, "1 0 x");

        Program.Result result = run(scene, job, "--for slurm");

        assertThat(result.err()).startsWith(scene + ":1:5: error: ");
        assertThat(result.exitCode()).isEqualTo(ExitCode.BAD_SCENE);
        assertThat(job).doesNotExist();
        assertThat(run(folder.resolve("none.scene"), job, "--for slurm").exitCode()).isEqualTo(ExitCode.NO_SCENE);
    }

    @ParameterizedTest
    @ValueSource(strings = {"plain.obj", "a b.obj", "it's.obj", "50%.obj", "a/b/c.obj", "a/../b.obj", "$x`y`.obj", "-x.obj", "a;b.obj"})
    void meshesComeWithTheScene(String name) throws IOException {
        Path obj = folder.resolve(name);
        Files.createDirectories(folder.resolve("a/b"));
        Files.writeString(obj, "mtllib my.mtl\nusemtl red\n" + TRIANGLE);
        Path mtl = obj.resolveSibling("my.mtl");
        Files.writeString(mtl, "newmtl red\nKd 1 0 0\n");
        Files.writeString(folder.resolve("other.obj"), TRIANGLE);
        Files.writeString(scene, "1 4 \"" + name + "\" 0 0 0 1" + MATERIAL + "mtl 0 0 0 0");

        Program.Result result = run(scene, job, "--for slurm");

        assertThat(result.exitCode()).as(result.err()).isZero();
        assertThat(job.resolve("scene").resolve(name)).hasSameBinaryContentAs(obj);
        assertThat(job.resolve("scene").resolve(folder.relativize(mtl))).hasSameBinaryContentAs(mtl);
        assertThat(job.resolve("scene/other.obj")).doesNotExist();
        assertThat(InProcess.run("check", job.resolve("scene/ball.scene").toString()).err()).isEmpty();
    }

    @ParameterizedTest
    @ValueSource(strings = {"a b.scene", "it's \"x\".scene", "50%.scene", "a\nb.scene", "{{Param.x}}.scene", "-x.scene", "job.sh", "README.txt"})
    void theSceneMayHaveAnyName(String name) throws IOException {
        Path named = Files.move(scene, folder.resolve(name));

        Program.Result result = run(named, job, "--for openjd");

        assertThat(result.exitCode()).as(result.err()).isZero();
        assertThat(job.resolve("scene").resolve(name)).hasSameBinaryContentAs(named);
        assertThat(job.resolve("README.txt")).content().hasLineCount(10);
    }

    @Test
    void aMeshOutsideItsFolderIsNotTaken() throws IOException {
        Path below = Files.createDirectory(folder.resolve("below"));
        Files.writeString(folder.resolve("out.obj"), TRIANGLE);
        Path outside = Files.writeString(below.resolve("x.scene"), "1 4 \"../out.obj\" 0 0 0 1" + MATERIAL + "0 0 0 0");

        Program.Result result = run(outside, job, "--for slurm");

        assertThat(result.err()).contains(": error: expected object 1's OBJ file within the scene's folder");
        assertThat(result.exitCode()).isEqualTo(ExitCode.BAD_SCENE);
        assertThat(job).doesNotExist();
    }

    @Test
    void aPictureThatCarriesItsSceneIsAScene() {
        Path picture = folder.resolve("ball.png");
        assertThat(InProcess.run("render", scene.toString(), "-o", picture.toString(), "-q", "--size", "8x8").exitCode()).isZero();

        assertThat(run(picture, job, "--for slurm").exitCode()).isZero();
        assertThat(job.resolve("scene/ball.png")).hasSameBinaryContentAs(picture);
    }

    @Test
    void anArrayThatSlurmMayRefuseIsToldOf() {
        Program.Result result = run(scene, job, "--for slurm --bands 1001 --size 1x1001");

        assertThat(result.err()).endsWith("simpleray: Slurm takes an array of 1001 tasks only if its MaxArraySize is above 1000, and it is "
            + "usually 1001: a larger --chunk makes fewer tasks\n");
        assertThat(run(scene, folder.resolve("other"), "--for slurm --bands 1000 --size 1x1000").err()).hasLineCount(1);
        assertThat(run(scene, folder.resolve("third"), "--for openjd --bands 1001 --size 1x1001").err()).hasLineCount(1);
    }

    @Test
    void theFolderMayBeMoved() throws IOException {
        assertThat(run(scene, job, "--for slurm").exitCode()).isZero();

        for (String file : files(job)) {
            assertThat(job.resolve(file)).content().as(file).doesNotContain(folder.toString(), job.getFileName() + "/");
        }
    }
}
