package simpleray.cli;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/**
 * A disk that becomes full: a real one of 64 KiB, mounted where only this test sees it. Where nothing can be mounted, a limit to the size
 * of files stands for it.
 */
class FullDiskTest {
    private static final String MOUNTED = "mount -t tmpfs -o size=64k tmpfs disk && ";
    private static final String LIMITED = "ulimit -f 64 && ";
    private static final String THEN = "printf 'the old one' >disk/%1$s && { \"$@\"; echo \"$?\"; ls -A disk; cat disk/%1$s; }";

    @TempDir
    Path folder;

    @ParameterizedTest
    @CsvSource({"render, render rough.scene -o disk/out --size 500x500 -q", "convert, convert many.scene disk/out",
        "export, export --pov many.scene -o disk/out", "compare, compare one.png other.png --heatmap disk/out",
        "figures, figures rough.scene -d disk --size 500x500 -q"})
    void theOldFileStaysAndNothingHalfIsLeft(String command, String line) throws IOException, InterruptedException {
        assumeTrue(Files.isExecutable(Path.of("/bin/sh")), "no shell");
        Files.writeString(folder.resolve("rough.scene"), SmallScenes.ROUGH);
        Files.writeString(folder.resolve("many.scene"), SmallScenes.many(2000));
        if (command.equals("compare")) {
            render("one.png", "0.9");
            render("other.png", "0.8");
        }
        Files.createDirectory(folder.resolve("disk"));
        boolean mounted = folder.toFile().getUsableSpace() > 0 && shell(MOUNTED + "true").exitCode() == 0;

        String out = command.equals("figures") ? "rough-stages.png" : "out";

        Program.Result result = shell((mounted ? MOUNTED : LIMITED) + String.format(THEN, out), line.split(" "));

        assertThat(result.text()).as(result.err()).isEqualTo("74\n" + out + "\nthe old one");
        assertThat(result.err()).endsWith("simpleray: disk/" + out + ": cannot be written: "
            + (mounted ? "No space left on device" : "File too large") + "\n").doesNotContain("\tat ");
    }

    /** The picture has no room beside them; another rendering goes on with the rows that it kept. */
    @Test
    void rowsForWhichThereIsNoRoomAreGoneWhenThePictureIsWhole() throws IOException, InterruptedException {
        Files.writeString(folder.resolve("rough.scene"), SmallScenes.ROUGH);
        Files.createDirectory(folder.resolve("disk"));
        assumeTrue(Files.isExecutable(Path.of("/bin/sh")) && shell(MOUNTED + "true").exitCode() == 0, "nothing can be mounted");
        String rows = "simpleray: disk/rows: rows are not kept any more: No space left on device\n";

        Program.Result result = shell(MOUNTED + "{ \"$@\" -o disk/out; echo $?; ls -A disk; \"$@\" --resume -o out; echo $?; ls -A disk; }",
            "render rough.scene --size 200x200 --checkpoint disk/rows".split(" "));

        assertThat(result.text()).as(result.err()).isEqualTo("74\nrows\n0\n");
        assertThat(result.err()).contains(rows).containsPattern("going on with \\d+ of 200 rows").doesNotContain("\tat ");
    }

    private void render(String out, String background) throws IOException, InterruptedException {
        Files.writeString(folder.resolve("rough.scene"), SmallScenes.ROUGH);
        assertThat(Program.run(folder, "render", "rough.scene", "-o", out, "--size", "500x500", "-q", "--depth", "0", "--background",
            background + ",0,0", "--cop", out.equals("one.png") ? "2" : "2.1").exitCode()).isZero();
    }

    /** A mount in a name space of its own is seen by nobody else, and ends with it; nothing needs to be undone. */
    private Program.Result shell(String script, String... args) throws IOException, InterruptedException {
        ProcessBuilder program = Program.program(folder, List.of("-XX:-UsePerfData", "-Xshare:auto"), args);
        List<String> line = program.command();
        line.addAll(0, List.of("/bin/sh", "-c", script, "sh"));
        if (script.startsWith(MOUNTED)) {
            line.addAll(0, List.of("/usr/bin/env", "unshare", "-rm"));
        }
        return Program.finish(program.start(), new byte[0]);
    }

    @Test
    void aFilmKeepsItsWholeFramesAndGoesOnOnceThereIsRoom() throws IOException, InterruptedException {
        Files.writeString(folder.resolve("rough.scene"), SmallScenes.ROUGH);
        Files.createDirectory(folder.resolve("disk"));
        assumeTrue(Files.isExecutable(Path.of("/bin/sh")) && shell(MOUNTED + "true").exitCode() == 0, "nothing can be mounted");

        Program.Result result = shell(MOUNTED + "{ \"$@\" -o disk/%d.png; echo $?; ls -A disk | tr -d '\\n' | sed 's/[1-7].png//g'; echo; "
            + "mount -o remount,size=9m disk; \"$@\" --resume -o disk/%d.png; echo $?; \"$@\" -o whole.%d.png; "
            + "for f in 0 1 2 3 4 5 6 7; do cmp disk/$f.png whole.$f.png; done; ls -A disk | wc -l; }",
            "animate rough.scene --size 200x200 --turntable 8".split(" "));

        assertThat(result.text()).as(result.err()).isEqualTo("74\n0.png\n0\n8\n");
        assertThat(result.err()).containsPattern("simpleray: disk/[1-7].png: cannot be written: No space left on device")
            .containsPattern("going on with [1-7] of 8 frames").doesNotContain("\tat ");
    }
}
