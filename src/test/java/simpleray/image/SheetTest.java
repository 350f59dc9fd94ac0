package simpleray.image;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;

/** Where a sheet's pictures and labels are, to the pixel. A small picture's dots are pixels: 12 of margin, 7 above a label. */
class SheetTest {
    private static final String PAPER = ".";

    @Test
    void picturesStandSideBySideWithTheirLabelsBelow() {
        Sheet sheet = new Sheet(7, 2, List.of("T", "L"));

        assertThat(sheet.width()).isEqualTo(12 + 7 + 12 + 7 + 12);
        assertThat(sheet.height()).isEqualTo(12 + 2 + 7 + 9 + 12);
        List<String> rows = rows(sheet.with(List.of(Pictures.plain(7, 2, 0.5), Pictures.plain(7, 2, 0))));
        assertThat(rows.subList(0, 12)).containsOnly(PAPER.repeat(50));
        assertThat(rows.subList(12, 30)).containsExactly(
            "............5555555............0000000............",
            "............5555555............0000000............",
            "..................................................",
            "..................................................",
            "..................................................",
            "..................................................",
            "..................................................",
            "..................................................",
            "..................................................",
            ".............#####..............#.................",
            "...............#................#.................",
            "...............#................#.................",
            "...............#................#.................",
            "...............#................#.................",
            "...............#................#.................",
            "...............#................#####.............",
            "..................................................",
            "..................................................");
        assertThat(rows.subList(30, 42)).containsOnly(PAPER.repeat(50));
    }

    @Test
    void aPicturesLinearLightIsKept() {
        Picture bright = new Picture(9, 1);
        double[] light = new double[27];
        Arrays.setAll(light, i -> 3.0 - i / 7.0);
        bright.setRow(0, light);

        Picture filled = new Sheet(9, 1, List.of("x")).with(List.of(bright));

        assertThat(Arrays.copyOfRange(filled.row(12), 3 * 12, 3 * 21)).isEqualTo(light);
    }

    @Test
    void aWordWiderThanItsPictureMakesRoomAndThePictureStandsInTheMiddle() {
        Sheet sheet = new Sheet(3, 1, List.of("LL", "L"));   // two letters are 11 dots

        assertThat(sheet.width()).isEqualTo(12 + 11 + 12 + 11 + 12);
        List<String> rows = rows(sheet.with(List.of(Pictures.plain(3, 1, 0), Pictures.plain(3, 1, 0))));
        assertThat(rows.get(12)).isEqualTo(PAPER.repeat(16) + "000" + PAPER.repeat(20) + "000" + PAPER.repeat(16));
        assertThat(rows.get(26)).isEqualTo(PAPER.repeat(12) + "#####.#####" + PAPER.repeat(15) + "#####" + PAPER.repeat(15));
    }

    @Test
    void aLabelWiderThanItsPictureGoesOnInTheNextLine() {
        Sheet sheet = new Sheet(23, 1, List.of("L LL L", "L")); // "L LL" is 23 dots

        assertThat(sheet.width()).isEqualTo(12 + 23 + 12 + 23 + 12);
        assertThat(sheet.height()).isEqualTo(12 + 1 + 7 + 9 + 2 + 9 + 12);
        List<String> rows = rows(sheet.with(List.of(Pictures.plain(23, 1, 0), Pictures.plain(23, 1, 0))));
        assertThat(rows.get(26)).isEqualTo(
            PAPER.repeat(12) + "#####.......#####.#####" + PAPER.repeat(12) + PAPER.repeat(9) + "#####" + PAPER.repeat(9 + 12));
        assertThat(rows.get(37)).isEqualTo(PAPER.repeat(12 + 9) + "#####" + PAPER.repeat(9 + 12 + 23 + 12));
    }

    @Test
    void lettersAndMarginsGrowWithThePictures() {
        assertThat(new Sheet(299, 299, List.of("L")).width()).isEqualTo(12 + 299 + 12);
        assertThat(new Sheet(4000, 299, List.of("L")).width()).isEqualTo(12 + 4000 + 12);
        Sheet sheet = new Sheet(300, 300, List.of("L"));
        assertThat(sheet.width()).isEqualTo(2 * 12 + 300 + 2 * 12);
        assertThat(sheet.height()).isEqualTo(300 + 2 * (12 + 7 + 9 + 12));

        List<String> rows = rows(sheet.with(List.of(Pictures.plain(300, 300, 0))));

        // the foot of the L is the 7th of its rows, and 10 pixels long
        int foot = 24 + 300 + 2 * (7 + 6);
        assertThat(rows.get(foot)).isEqualTo(PAPER.repeat(24 + 145) + "#".repeat(10) + PAPER.repeat(145 + 24));
        assertThat(rows.get(foot + 1)).isEqualTo(rows.get(foot));
        assertThat(rows.get(foot + 2)).isEqualTo(PAPER.repeat(348));
    }

    @Test
    void aSheetTooLargeForAPictureIsRefused() {
        assertThatThrownBy(() -> new Sheet(30000, 2, List.of("a", "b", "c"))).isInstanceOf(IllegalArgumentException.class)
            .hasMessage("a sheet of 3 pictures of 30000x2 would have 90048x42 pixels, and a side has at most 65535");
        assertThatThrownBy(() -> new Sheet(1, 65500, List.of("a"))).isInstanceOf(IllegalArgumentException.class)
            .hasMessage("a sheet of 1 picture of 1x65500 would have 29x65540 pixels, and a side has at most 65535");
    }

    @Test
    void onlyThePicturesThatItIsLaidOutForFillASheet() {
        Sheet sheet = new Sheet(7, 2, List.of("T", "L"));
        Picture right = Pictures.plain(7, 2, 0);
        String message = "the sheet is laid out for 2 pictures of 7x2";

        assertThatThrownBy(() -> sheet.with(List.of(right))).isInstanceOf(IllegalArgumentException.class).hasMessage(message);
        assertThatThrownBy(() -> sheet.with(List.of(right, Pictures.plain(2, 7, 0)))).isInstanceOf(IllegalArgumentException.class)
            .hasMessage(message);
    }

    /** {@return a sign for each pixel: . for paper, # for ink, else its tenths of light} */
    private static List<String> rows(Picture sheet) {
        String[] rows = new String[sheet.height()];
        for (int y = 0; y < rows.length; y++) {
            StringBuilder row = new StringBuilder();
            for (int x = 0; x < sheet.width(); x++) {
                double light = sheet.row(y)[3 * x];
                row.append(light == 1 ? PAPER : light == 0.1 ? "#" : String.valueOf((int) (10 * light)));
            }
            rows[y] = row.toString();
        }
        return List.of(rows);
    }
}
