package simpleray.film;

import java.io.IOException;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Locale;
import java.util.regex.Pattern;
import simpleray.io.OutputTarget;

/**
 * What a film is written to: a numbered PNG file for each frame; or one file, of a kind that the end of its name tells. The frames of a GIF and of an APNG
 * are first written into a folder beside it, from which an ended run can go on. <em>Constant.</em>
 */
public final class FilmOutput {
    /** What the folder of the frames is called: this behind the film's name. */
    private static final String FRAMES = ".frames";
    private static final Pattern PLACE = Pattern.compile("%\\d*d");
    private static final Pattern FRAME = Pattern.compile("\\d+\\.png|\\.simpleray-.*");   // the latter of a killed run

    private final String name;
    private final Kind kind;
    private final FramePattern pattern;                       // of the PNG files; null if there are none
    private final Path folder;                                // of the frames of a single file; null if there are none

    /** Kinds of films. */
    public enum Kind {
        /** Numbered PNG files. */
        PNG,
        /** A GIF of one palette. */
        GIF,
        /** An animated PNG. */
        APNG,
        /** H.264 by ffmpeg. */
        MP4,
        /** VP9 by ffmpeg. */
        WEBM;

        /** {@return whether ffmpeg makes it} */
        public boolean isByFfmpeg() {
            return this == MP4 || this == WEBM;
        }
    }

    private FilmOutput(String name, Kind kind, FramePattern pattern, Path folder) {
        this.name = name;
        this.kind = kind;
        this.pattern = pattern;
        this.folder = folder;
    }

    /**
     * Finds out what a name stands for.
     *
     * @param name the name
     * @return what it stands for
     * @throws IllegalArgumentException if no film can be written under it; the message says why
     */
    public static FilmOutput of(String name) {
        Kind kind = kind(name);
        if (kind == null) {
            throw new IllegalArgumentException("a film is written as numbered PNG files such as film.%04d.png, or as .gif, .apng, .mp4 or "
                + ".webm, and not as " + name);
        }
        if (kind == Kind.PNG) {
            return new FilmOutput(name, kind, new FramePattern(name), null);
        }
        if (PLACE.matcher(name).find()) {
            throw new IllegalArgumentException("the output " + name + " has a place for numbers: numbered frames are PNG files "
                + "such as film.%04d.png");
        }
        boolean stream = OutputTarget.isStream(Path.of(name));
        if (stream && kind.isByFfmpeg()) {
            throw new IllegalArgumentException("the output " + name + " is no file, which ffmpeg needs");
        }
        if (kind.isByFfmpeg()) {
            return new FilmOutput(name, kind, null, null);
        }
        Path folder = stream ? temporaryFolder() : Path.of(name + FRAMES);
        return new FilmOutput(name, kind, new FramePattern(folder.toString().replace("%", "%%") + "/%06d.png"), folder);
    }

    private static Kind kind(String name) {
        String ending = name.substring(name.lastIndexOf('.') + 1).toUpperCase(Locale.ROOT);
        return name.contains(".") ? Arrays.stream(Kind.values()).filter(kind -> kind.name().equals(ending)).findFirst().orElse(null) : null;
    }

    private static Path temporaryFolder() {
        return Path.of(System.getProperty("java.io.tmpdir"), "simpleray-" + Long.toHexString(System.nanoTime()) + FRAMES);
    }

    /** {@return the name} */
    public String name() {
        return name;
    }

    /** {@return of what kind it is} */
    public Kind kind() {
        return kind;
    }

    /** {@return whether it is one file} */
    public boolean isSingle() {
        return kind != Kind.PNG;
    }

    /** {@return whether frames are in PNG files, with which a run that has been ended can go on} */
    public boolean keepsFrames() {
        return pattern != null && !isTemporary();
    }

    private boolean isTemporary() {
        return folder != null && !folder.toString().equals(name + FRAMES);
    }

    /**
     * Names a frame's picture.
     *
     * @param number the frame
     * @return the name of its PNG file
     */
    public String frame(int number) {
        return pattern.name(number);
    }

    /** {@return where the finished frames are, for messages} */
    public String place() {
        return folder == null ? name : folder.toString();
    }

    /** {@return whether there is a folder of frames, of an earlier run} */
    public boolean hasFolder() {
        return folder != null && Files.exists(folder);
    }

    /**
     * Makes the folder of the frames, if they have one of their own.
     *
     * @throws IOException if it cannot be created
     */
    void makeFolder() throws IOException {
        if (folder != null) {
            Files.createDirectories(folder);
        }
    }

    /**
     * Removes the folder of the frames, with all frames in it. A file of somebody else's stays, and so does the folder then.
     *
     * @throws IOException if something cannot be removed
     */
    void removeFolder() throws IOException {
        if (!hasFolder()) {
            return;
        }
        boolean empty = true;
        try (DirectoryStream<Path> files = Files.newDirectoryStream(folder)) {
            for (Path file : files) {
                boolean ours = FRAME.matcher(folder.relativize(file).toString()).matches();
                if (ours) {
                    Files.delete(file);
                }
                empty &= ours;
            }
        }
        if (empty) {
            Files.delete(folder);
        }
    }
}
