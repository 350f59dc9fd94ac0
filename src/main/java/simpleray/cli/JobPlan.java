package simpleray.cli;

import java.util.List;
import simpleray.scene.SceneSettings.Resolution;

/**
 * A rendering on many machines: what it makes, and into which tasks it is cut. <em>Constant.</em>
 *
 * @param scene the scene file's name, without its folder
 * @param size the size of a picture
 * @param frames the frames to render; null for a scene that has none, of which one picture is made
 * @param bands the number of bands that each picture is cut into
 * @param chunk the number of frames in a task
 * @param film the name of the film that is made of the pictures; null for none
 * @param options the words of the command line that say which picture is made of the scene
 * @param estimate what a task needs
 */
record JobPlan(String scene, Resolution size, FrameRanges frames, int bands, int chunk, String film, List<String> options,
        JobEstimate estimate) {
    /** The longest array of tasks that Slurm takes unless it is configured otherwise. */
    static final int MAX_ARRAY = 1000;
    private static final int MAX_NAME = 64;
    private static final int MIN_DIGITS = 4;

    /** {@return the number of frames in a task, if nothing is asked for: one, unless the tasks were more than an array may have} */
    static int chunk(int frames, int bands) {
        return Math.max(1, (int) Math.min(frames, ((long) frames * bands + MAX_ARRAY - 1) / MAX_ARRAY));
    }

    /** {@return the number of pictures} */
    int pictures() {
        return frames == null ? 1 : frames.count();
    }

    /** {@return the number of tasks that render} */
    long tasks() {
        return (pictures() + chunk - 1L) / chunk * bands;
    }

    /** {@return the number of digits in the names of numbered pictures} */
    int digits() {
        return frames == null ? MIN_DIGITS : Math.max(MIN_DIGITS, Integer.toString(frames.last()).length());
    }

    /** {@return a name for the job: that of the scene, as far as all engines allow it} */
    String name() {
        String plain = scene.replaceFirst("(?<=.)\\.(scene|txt|png)$", "").replaceAll("[^A-Za-z0-9._-]", "_");
        return plain.substring(0, Math.min(plain.length(), MAX_NAME));
    }

    /** {@return what the job makes, such as {@code 24 frames of 640x480 in 3 bands each}} */
    String what() {
        String of = size.width() + "x" + size.height();
        String cut = bands == 1 ? "" : " in " + bands + " bands" + (frames == null ? "" : " each");
        return (frames == null ? "one picture of " : pictures() == 1 ? "1 frame of " : pictures() + " frames of ") + of + cut;
    }
}
