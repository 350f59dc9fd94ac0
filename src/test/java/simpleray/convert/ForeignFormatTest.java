package simpleray.convert;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatCode;

import java.io.IOException;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import simpleray.text.SceneFormatException;

/** What all formats share. */
class ForeignFormatTest {
    private static final int MUTANTS = 3000;
    private static final String RT = "R 64 48\nA 0.2 255,255,255\nC 0,0,5 0,0,-1 70\nL -3,4,2 0.7 255,9,255\nsp 0,0,0 2 255,0,0\n"
        + "pl 0,-1,0 0,1,0 9,9,9\ncy 1,0,0 0,1,0 1 2 5,5,5\nco 1,0,0 0,1,0 1 2 5,5,5\ntr 0,0,0 1,0,0 0,1,0 1,2,3 rest\nsq 0,0,0 0,0,1 2 1,1,1\n";
    private static final String NFF = "b .1 .2 .3\nv\nfrom 0 0 5\nat 0 0 0\nup 0 1 0\nangle 45\nhither 1\nresolution 64 48\nl 1 2 3\nl 1 2 3 .5 .5 .5\n"
        + "f 1 .5 .2 .5 .5 3 .5 1.5\ns 0 0 0 1\nc 0 0 0 1\n0 1 0 .5\np 5\n4 0 0\n0 4 0\n1 1 0\n0 -4 0\n2 -2 0\n"
        + "pp 3\n0 0 0 0 0 1\n1 0 0 0 0 1\n0 1 0 0 0 1\n";
    /** What mutants get: what numbers and words are made of, and what breaks them. */
    private static final String[] PIECES = {" ", "\n", "\r", ",", "#", "-", "0", "1", "9", ".", "e", "e99", "-1", "0 0 0", "nan", "p", "pp", "v", "s", "c", "sp", "\0",
        "\u00E9", "\uD83D\uDE00", "180", "65535", "\t"};

    @Test
    void aNameTellsItsFormat() {
        assertThat(ForeignFormat.of("a/b.rt")).isEqualTo(ForeignFormat.RT);
        assertThat(ForeignFormat.of("B.NFF")).isEqualTo(ForeignFormat.NFF);
        assertThat(ForeignFormat.of("b.nff.txt")).isNull();
        assertThat(ForeignFormat.of("nff")).isNull();
    }

    /** A mutant is read, and then written so that our own reader takes it, or it is refused in a line with its place. */
    @ParameterizedTest
    @EnumSource
    void noMutantIsMoreThanAnError(ForeignFormat format) {
        Random random = new Random(1987);
        int[] ends = new int[2];
        for (int i = 0; i < MUTANTS; i++) {
            StringBuilder text = new StringBuilder(format == ForeignFormat.RT ? RT : NFF);
            for (int k = random.nextInt(3); k >= 0; k--) {
                int from = random.nextInt(text.length());
                text.replace(from, Math.min(text.length(), from + random.nextInt(4)), PIECES[random.nextInt(PIECES.length)]);
            }
            String mutant = text.toString();
            assertThatCode(() -> ends[outcome(format, mutant)]++).as(mutant).doesNotThrowAnyException();
        }
        assertThat(ends[0]).isGreaterThan(MUTANTS / 20);
        assertThat(ends[1]).isGreaterThan(MUTANTS / 20);
    }

    private static int outcome(ForeignFormat format, String text) throws IOException {
        ImportedScene read;
        try {
            read = Imports.read(format, text);
        } catch (SceneFormatException e) {
            assertThat(e.getMessage().lines().findFirst().orElse("")).matches("in/a\\.file:\\d+:\\d+: error: expected .+, found .+");
            return 0;
        }
        read.warnings().forEach(warning -> assertThat(warning.toString()).isNotEmpty());
        Imports.scene(format, text);
        if (read.facets().areMesh()) {
            assertThat(Imports.text(os -> read.writeObj(os, "a.mtl"))).contains("\nf ");
        }
        return 1;
    }
}
