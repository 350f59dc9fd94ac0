package simpleray.cli;

/** Scenes of a line or two, each good for one test. */
final class SmallScenes {
    /** A grey wall under ambient light: every level of its picture is 128. */
    static final String GREY = "1  1 0 0 1 -2  1 1 1  0 0 0  0 0 0  1   0.5 0.5 0.5  0\n";
    /** The same, with a warning. */
    static final String WITH_HEADING = "one grey wall\n" + GREY;
    static final String HEADING_WARNING =
        "%1$s:1:1: warning: expected a value or a comment, found the heading 'one grey wall', which is skipped\none grey wall\n^\n";
    /** A sphere of no size, and a colour that is no number. */
    static final String BAD = "1  # object\n0  1 2 3  0  1 1 1  0 0 0  0 0 abc  1\n1 1 1  0\n";
    static final String BAD_REPORT = "%1$s:2:11: error: expected object 1's radius above 0, found '0'\n"
        + "0  1 2 3  0  1 1 1  0 0 0  0 0 abc  1\n"
        + " ".repeat(10) + "^\n"
        + "%1$s:2:32: error: expected object 1's specular blue, found 'abc'\n"
        + "0  1 2 3  0  1 1 1  0 0 0  0 0 abc  1\n"
        + " ".repeat(31) + "^\n";

    /** A sphere whose picture does not become small. */
    static final String ROUGH =
        "1  0  0 0 0  1.9  0.9 0.7 0.5  0.5 0.7 0.9  0.3 0.3 0.3  5  0.2 0.3 0.4  1  0 0.9 0.8 0.7  3 2 4\n";

    private SmallScenes() {
    }

    /** {@return a scene of that many spheres} */
    static String many(int n) {
        StringBuilder text = new StringBuilder().append(n).append('\n');
        for (int i = 0; i < n; i++) {
            text.append("0  ").append(i).append(" 0.5 -1.25  0.75  0.9 0.7 0.5  0.5 0.7 0.9  0.3 0.3 0.3  5\n");
        }
        return text.append("0.5 0.5 0.5  0\n").toString();
    }
}
