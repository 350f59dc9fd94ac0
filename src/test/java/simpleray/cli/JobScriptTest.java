package simpleray.cli;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** What {@code job.sh} does, with a program that only notes what it is told, and makes empty pictures. */
class JobScriptTest {
    private static final String PROGRAM = """
        #!/bin/sh
        { printf '%s' "${0##*/}"; printf ' [%s]' "$@"; echo; } >>"$LOG"
        echo "${SIMPLERAY_OPTS-}" >"$LOG.options"
        status=$(sed -n 1p "$LOG.codes" 2>/dev/null)
        [ "$status" ] && sed -i 1d "$LOG.codes"
        [ "${status:-0}" = 0 ] || exit "$status"
        while [ $# -gt 0 ]; do
            [ "$1" != -o ] || [ -e "$2" ] || : >"$2"
            shift
        done
        """;

    @TempDir
    Path folder;
    private Path job;
    private Path bin;

    @BeforeEach
    void makeProgram() throws IOException {
        assumeTrue(Files.isExecutable(Path.of("/bin/sh")), "no shell");
        bin = Files.createDirectory(folder.resolve("bin"));
        executable("simpleray", PROGRAM);
        executable("sleep", "#!/bin/sh\necho \"sleep $1\" >>\"$LOG\"\n");
    }

    private void executable(String name, String text) throws IOException {
        Files.setPosixFilePermissions(Files.writeString(bin.resolve(name), text), PosixFilePermissions.fromString("rwxr-xr-x"));
    }

    private void write(JobPlan plan) throws IOException {
        job = Files.createDirectories(folder.resolve("the job"));
        Files.createDirectory(job.resolve("scene"));
        Files.createDirectory(job.resolve("frames"));
        Files.createDirectory(job.resolve("parts"));
        Files.writeString(job.resolve("scene").resolve(plan.scene()), "0 0 0 0 0");
        Files.writeString(job.resolve("job.sh"), JobScript.of(plan));
    }

    private void codes(String... codes) throws IOException {
        Files.write(folder.resolve("log.codes"), List.of(codes));
    }

    private Program.Result run(String line) throws IOException, InterruptedException {
        return run(Map.of(), line);
    }

    private Program.Result run(Map<String, String> variables, String line) throws IOException, InterruptedException {
        List<String> words = new ArrayList<>(List.of("/bin/sh", job.resolve("job.sh").toString()));
        words.addAll(line.isEmpty() ? List.of() : List.of(line.split(" ")));
        ProcessBuilder shell = new ProcessBuilder(words).directory(folder.toFile());
        shell.environment().keySet().removeIf(name -> name.startsWith("SLURM") || name.startsWith("SIMPLERAY"));
        shell.environment().put("LOG", folder.resolve("log").toString());
        shell.environment().put("PATH", bin + ":" + System.getenv("PATH"));
        shell.environment().putAll(variables);
        return Program.finish(shell.start(), new byte[0]);
    }

    private List<String> log() throws IOException {
        Path log = folder.resolve("log");
        List<String> lines = Files.exists(log) ? Files.readAllLines(log) : List.of();
        Files.deleteIfExists(log);
        return lines;
    }

    @Test
    void aPieceIsABandOfAChunkOfFrames() throws IOException, InterruptedException {
        write(JobPlanTest.plan("a.scene", "0-2,8-9", 2, 3, "--size", "40x30"));

        assertThat(run("task 3").exitCode()).isZero();

        assertThat(log()).containsExactly(
            "simpleray [render] [scene/a.scene] [--size] [40x30] [-q] [--frame] [8] [--band] [2/2] [-o] [parts/0008-2.png] [--skip-done] [--resume]",
            "simpleray [render] [scene/a.scene] [--size] [40x30] [-q] [--frame] [9] [--band] [2/2] [-o] [parts/0009-2.png] [--skip-done] [--resume]");
    }

    @ParameterizedTest
    @CsvSource({"0, 0-2", "1, '3-3,8-9'", "2, '20-22'", "3, '23-23'"})
    void withoutBandsOneProgramRendersAllFramesOfAPiece(int piece, String frames) throws IOException, InterruptedException {
        write(JobPlanTest.plan("a.scene", "0-3,8-9,20-23", 1, 3));

        assertThat(run("task " + piece).exitCode()).isZero();

        assertThat(log()).containsExactly("simpleray [animate] [scene/a.scene] [-q] [--frames] [" + frames + "] [-o] [frames/%04d.png] [--resume]");
    }

    @Test
    void allPiecesTogetherAreTheJob() throws IOException, InterruptedException {
        JobPlan plan = JobPlanTest.plan("a.scene", "0-2,8-9", 3, 2);
        write(plan);

        for (long k = 0; k < plan.tasks(); k++) {
            run("task " + k);
        }

        assertThat(log()).hasSize(15);
        assertThat(run("finish").exitCode()).isZero();
        assertThat(log()).hasSize(6).endsWith(
            "simpleray [animate] [scene/a.scene] [-q] [--frames] [0-2,8-9] [-o] [film.apng] [--resume]").startsWith("simpleray [merge] [-q] [-o] [frames/0000.png] [parts/0000-1.png] [parts/0000-2.png] [parts/0000-3.png]");
        assertThat(job.resolve("frames")).isDirectoryNotContaining("glob:**.tmp");
        assertThat(job.resolve("film.apng")).exists();
        assertThat(job.resolve("film.apng.frames")).isDirectoryContaining("glob:**/000009.png");
        assertThat(run("finish").exitCode()).isZero();
        assertThat(log()).isEmpty();
        assertThat(run("task " + plan.tasks()).err()).isEqualTo("job.sh: there is no piece 9\n");
    }

    @Test
    void aSceneWithoutFramesIsOnePicture() throws IOException, InterruptedException {
        write(JobPlanTest.plan("a.scene", null, 1, 1));

        assertThat(run("task 0").exitCode()).isZero();

        assertThat(log()).containsExactly("simpleray [render] [scene/a.scene] [-q] [-o] [picture.png] [--skip-done] [--resume]");
        assertThat(run("finish").exitCode()).isZero();
        assertThat(log()).isEmpty();
    }

    @Test
    void itsBandsAreMerged() throws IOException, InterruptedException {
        write(JobPlanTest.plan("a.scene", null, 2, 1));

        assertThat(run("task 0").exitCode()).isZero();
        assertThat(run("task 1").exitCode()).isZero();
        assertThat(run("finish").exitCode()).isZero();

        assertThat(log()).containsExactly("simpleray [render] [scene/a.scene] [-q] [--band] [1/2] [-o] [parts/band-1.png] [--skip-done] [--resume]",
            "simpleray [render] [scene/a.scene] [-q] [--band] [2/2] [-o] [parts/band-2.png] [--skip-done] [--resume]",
            "simpleray [merge] [-q] [-o] [picture.png] [parts/band-1.png] [parts/band-2.png]");
    }

    @ParameterizedTest
    @ValueSource(strings = {"a b.scene", "it's.scene", "\"x\".scene", "50%.scene", "a\nb.scene", "$HOME.scene", "-x.scene", "{{Param.x}}.scene",
        "`id`.scene", "a;b&c.scene", "*.scene", "# x.scene", "\\.scene", "Käse\t.scene"})
    void namesOfAllKindsReachTheProgram(String scene) throws IOException, InterruptedException {
        write(JobPlanTest.plan(scene, null, 1, 1, "--window", "-2,2,-2,2", "--x", "a 'b'"));

        Program.Result result = run("task 0");

        assertThat(result.err()).isEmpty();
        assertThat(String.join("\n", log())).isEqualTo("simpleray [render] [scene/" + scene
            + "] [--window] [-2,2,-2,2] [--x] [a 'b'] [-q] [-o] [picture.png] [--skip-done] [--resume]");
    }

    @Test
    void theNumberOfThreadsAndTheHeapAreWhatSlurmGrants() throws IOException, InterruptedException {
        write(JobPlanTest.plan("a.scene", null, 1, 1));

        run(Map.of("SLURM_CPUS_PER_TASK", "4", "SLURM_MEM_PER_NODE", "448"), "task 0");

        assertThat(log()).containsExactly(
            "simpleray [render] [scene/a.scene] [-q] [--threads] [4] [-o] [picture.png] [--skip-done] [--resume]");
        assertThat(folder.resolve("log.options")).hasContent("-Xmx256m ");
        run(Map.of("SLURM_MEM_PER_NODE", "300", "SIMPLERAY_OPTS", "-Xss1m"), "task 0");
        assertThat(folder.resolve("log.options")).hasContent("-Xmx150m -Xss1m");
        run(Map.of("SLURM_MEM_PER_NODE", "0"), "task 0");      // all of the node's
        assertThat(folder.resolve("log.options")).hasContent("\n");
    }

    @Test
    void progressIsToldAsTheEngineWantsIt() throws IOException, InterruptedException {
        write(JobPlanTest.plan("a.scene", "0-9", 1, 1));

        run("openjd render 3-5");

        assertThat(log()).containsExactly(
            "simpleray [animate] [scene/a.scene] [--progress] [openjd] [--frames] [3-5] [-o] [frames/%04d.png] [--resume]");
    }

    @Test
    void theProgramMayBeNamed() throws IOException, InterruptedException {
        write(JobPlanTest.plan("a.scene", null, 1, 1));
        executable("my ray", PROGRAM);

        run(Map.of("SIMPLERAY", bin.resolve("my ray").toString()), "task 0");

        assertThat(log().get(0)).startsWith("my ray [render]");
        Program.Result none = run(Map.of("SIMPLERAY", "/none/ray"), "task 0");
        assertThat(none.err()).isEqualTo("job.sh: no program /none/ray: put it on the PATH, or its path into SIMPLERAY\n");
        assertThat(none.exitCode()).isEqualTo(69);
    }

    @ParameterizedTest
    @ValueSource(ints = {71, 74, 75, 130, 137, 143})
    void whatMayPassIsTriedTwiceMore(int code) throws IOException, InterruptedException {
        write(JobPlanTest.plan("a.scene", null, 1, 1));
        codes("" + code, "" + code, "0");

        Program.Result result = run("task 0");

        assertThat(result.exitCode()).isZero();
        assertThat(log()).filteredOn(line -> line.startsWith("sleep")).containsExactly("sleep 5", "sleep 25");
        assertThat(result.err()).isEqualTo("job.sh: exit code " + code + ": trying again in 5 s\njob.sh: exit code " + code + ": trying again in 25 s\n");
        codes("" + code, "" + code, "" + code, "0");
        assertThat(run("task 0").exitCode()).isEqualTo(code);
        assertThat(log()).hasSize(5);
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 2, 65, 66, 69, 70, 73})
    void whatDoesNotPassIsNotTriedAgain(int code) throws IOException, InterruptedException {
        write(JobPlanTest.plan("a.scene", null, 1, 1));
        codes("" + code, "0");

        assertThat(run("task 0").exitCode()).isEqualTo(code);
        assertThat(log()).hasSize(1);
    }

    @Test
    void aFrameThatFailsDoesNotEndItsPiece() throws IOException, InterruptedException {
        write(JobPlanTest.plan("a.scene", "0-2", 2, 3));
        codes("0", "65", "0");

        assertThat(run("task 0").exitCode()).isEqualTo(65);

        assertThat(log()).hasSize(3);
    }

    @Test
    void whatIsMissingIsNamedAndTheRestIsMerged() throws IOException, InterruptedException {
        write(JobPlanTest.plan("a.scene", "0-2", 2, 3));
        run("task 0");
        run("task 1");
        log();
        Files.delete(job.resolve("parts/0001-2.png"));

        Program.Result result = run("finish");

        assertThat(result.err()).isEqualTo("job.sh: missing: parts/0001-2.png\n"
            + "job.sh: to render what is missing, submit the job again: what is there and whole stays\n");
        assertThat(result.exitCode()).isEqualTo(66);
        assertThat(log()).hasSize(2).allMatch(line -> line.startsWith("simpleray [merge]"));
        run("task 1");
        log();
        assertThat(run("finish").exitCode()).isZero();
        assertThat(log()).hasSize(2);                         // a picture, and the film
    }

    @Test
    void ofManyThatAreMissingTwentyAreNamed() throws IOException, InterruptedException {
        write(JobPlanTest.plan("a.scene", "0-24", 1, 1));

        Program.Result result = run("film");

        assertThat(result.err().lines()).hasSize(22).contains("job.sh: missing: frames/0019.png", "job.sh: missing: 5 more")
            .doesNotContain("job.sh: missing: frames/0020.png");
        assertThat(result.exitCode()).isEqualTo(66);
        assertThat(log()).isEmpty();
    }

    @Test
    void aBandThatIsNewerThanItsPictureIsMergedAgain() throws IOException, InterruptedException {
        write(JobPlanTest.plan("a.scene", null, 2, 1));
        run("task 0");
        run("task 1");
        run("merge");
        log();
        assertThat(run("merge").exitCode()).isZero();
        assertThat(log()).isEmpty();

        Files.setLastModifiedTime(job.resolve("parts/band-1.png"), FileTime.fromMillis(System.currentTimeMillis() + 10_000));
        run("merge");

        assertThat(log()).containsExactly("simpleray [merge] [-q] [-o] [picture.png] [parts/band-1.png] [parts/band-2.png]");
    }

    @Test
    void aMergeThatWasKilledWhenItsPictureWasThereIsNotRepeated() throws IOException, InterruptedException {
        write(JobPlanTest.plan("a.scene", null, 2, 1));
        run("task 0");
        run("task 1");
        log();
        codes("137");
        executable("sleep", "#!/bin/sh\n: >'" + job.resolve("picture.png") + "'\n");   // as if it had been written

        assertThat(run("merge").exitCode()).isZero();
        assertThat(log()).hasSize(1);
    }

    @Test
    void bandsMayBeDeletedOnceTheyAreMerged() throws IOException, InterruptedException {
        write(JobPlanTest.plan("a.scene", "4", 2, 1));
        run("task 0");
        run("task 1");
        run("merge");
        log();
        Files.delete(job.resolve("parts/0004-1.png"));
        Files.delete(job.resolve("parts/0004-2.png"));

        assertThat(run("task 0").exitCode()).isZero();
        assertThat(run("finish").exitCode()).isZero();

        assertThat(log()).isEmpty();
    }

    @ParameterizedTest
    @ValueSource(strings = {"", "paint", "render", "render 0 1 2", "task", "task x", "task 1-2", "task -1", "task 1 1", "film 1", "merge 1 2",
        "render 1;2", "openjd"})
    void aLineThatMakesNoSenseIs2(String line) throws IOException, InterruptedException {
        write(JobPlanTest.plan("a.scene", "0-2", 2, 3));

        Program.Result result = run(line);

        assertThat(result.err()).startsWith("job.sh: expected render FRAMES [BAND], task K, ").hasLineCount(1);
        assertThat(result.exitCode()).isEqualTo(2);
        assertThat(log()).isEmpty();
    }

    @ParameterizedTest
    @ValueSource(strings = {"0", "3"})
    void aBandThatThereIsNotIs2(String band) throws IOException, InterruptedException {
        write(JobPlanTest.plan("a.scene", "0-2", 2, 3));

        Program.Result result = run("render 0 " + band);

        assertThat(result.err()).isEqualTo("job.sh: expected a band from 1 to 2, found " + band + "\n");
        assertThat(result.exitCode()).isEqualTo(2);
    }

    @Test
    void withoutItsSceneItEnds() throws IOException, InterruptedException {
        write(JobPlanTest.plan("a.scene", null, 1, 1));
        Files.delete(job.resolve("scene/a.scene"));

        Program.Result result = run("task 0");

        assertThat(result.err()).isEqualTo("job.sh: there is no scene/a.scene here: run it in the job's folder, where it lies\n");
        assertThat(result.exitCode()).isEqualTo(66);
    }
}
