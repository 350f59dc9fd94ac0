package simpleray.render;

import java.io.IOException;
import java.util.Arrays;
import java.util.List;
import simpleray.image.PictureText;
import simpleray.image.png.PictureFormatException;
import simpleray.scene.PictureScene;
import simpleray.scene.SceneFile;
import simpleray.scene.SceneSettings;
import simpleray.scene.Setting;
import simpleray.text.Diagnostic;

/**
 * What a picture tells of how it was made: all that decides about its pixels, and nothing else. So two renderings of one scene with the
 * same options are the same file.
 */
public final class Provenance {
    /** The program's version. */
    public static final String VERSION = "0.1.0";
    /** The program and its version. */
    public static final String SOFTWARE = "SimpleRay " + VERSION;

    private static final String STAGE = "stage ";
    private static final String SHEET = "sheet ";
    private static final String ADAPTIVE = "samples adaptive";
    private static final String REGION = "region ";
    /** Begins the line of a band. */
    static final String BAND = "band ";

    private Provenance() {
    }

    /**
     * Puts together what a picture is to tell.
     *
     * @param request what was asked for
     * @param file the scene, with its own settings
     * @return the texts; none if the scene was not read from a text
     */
    public static List<PictureText> of(RenderRequest request, SceneFile file) {
        return of(STAGE + request.stage(), request, file);
    }

    /**
     * Puts together what a sheet of several pictures is to tell: what they have in common, and what there is on it.
     *
     * @param request what was asked for
     * @param file the scene, with its own settings
     * @param what what there is on it, in one line
     * @return the texts; none if the scene was not read from a text
     */
    public static List<PictureText> ofSheet(RenderRequest request, SceneFile file, String what) {
        return of(SHEET + what, request, file);
    }

    private static List<PictureText> of(String what, RenderRequest request, SceneFile file) {
        if (file.text() == null) {
            return List.of();
        }
        SceneSettings all = file.scene().settings.under(request.settings());
        for (Setting<?> setting : Setting.ALL) {
            if (setting.isAlwaysTold() && !setting.isSet(all)) {
                setting.reset(all);
            }
        }
        if (request.adaptive()) {
            all.samples = null;
        }
        String options = what + '\n' + (request.adaptive() ? ADAPTIVE + '\n' : "")
            + (request.region() == null ? "" : REGION + request.region() + '\n')
            + (request.band() == null ? "" : BAND + request.band() + '\n') + all.lines();
        return PictureScene.texts(SOFTWARE, options, file.text());
    }

    /**
     * Finds what was asked for when a picture was made.
     *
     * @param told what the picture tells
     * @param accel how the nearest object is found
     * @param threads how many threads work, 1 or more
     * @return a request for the same picture
     * @throws PictureFormatException if that cannot be asked for
     */
    public static RenderRequest request(PictureScene told, Accel accel, int threads) throws IOException {
        Stage stage = null;
        boolean adaptive = false;
        Region region = null;
        Band band = null;
        for (String line : told.others()) {
            if (line.startsWith(SHEET)) {
                int end = line.indexOf(':');
                throw new PictureFormatException(told.file(), "is a sheet of several pictures, "
                    + Diagnostic.quoted(line.substring(SHEET.length(), end < 0 ? line.length() : end))
                    + ": only single pictures can be verified");
            }
            if (line.equals(ADAPTIVE)) {
                adaptive = true;
            } else if (region == null && line.startsWith(REGION)) {
                region = region(told, line.substring(REGION.length()));
            } else if (band == null && line.startsWith(BAND)) {
                band = band(told, line.substring(BAND.length()));
            } else {
                stage = stage == null && line.startsWith(STAGE) ? stage(line.substring(STAGE.length())) : null;
                if (stage == null) {
                    throw new PictureFormatException(told.file(), "was made with an option that this version does not know: "
                        + Diagnostic.quoted(line));
                }
            }
        }
        if (stage == null) {
            throw new PictureFormatException(told.file(), "does not tell the stage that it shows");
        }
        return new RenderRequest(told.settings(), stage, adaptive, accel, threads, region, band);
    }

    private static Region region(PictureScene told, String text) throws PictureFormatException {
        try {
            int[] n = Arrays.stream(text.split(",", -1)).mapToInt(Integer::parseInt).toArray();
            if (n.length == 4) {
                return new Region(n[0], n[1], n[2], n[3]);
            }
        } catch (IllegalArgumentException e) {
            // as below
        }
        throw new PictureFormatException(told.file(), "was made of a region that is none: " + Diagnostic.quoted(text));
    }

    private static Band band(PictureScene told, String text) throws PictureFormatException {
        try {
            return Band.parse(text);
        } catch (IllegalArgumentException e) {
            throw (PictureFormatException) new PictureFormatException(told.file(), "was made of a band that is none: " + Diagnostic.quoted(text))
                .initCause(e);
        }
    }

    private static Stage stage(String name) {
        return Arrays.stream(Stage.values()).filter(stage -> stage.toString().equals(name)).findFirst().orElse(null);
    }
}
