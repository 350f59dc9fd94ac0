package simpleray.film;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.BitSet;
import java.util.Deque;
import java.util.List;
import java.util.Set;
import java.util.concurrent.CancellationException;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.atomic.AtomicInteger;
import simpleray.image.Picture;
import simpleray.image.PictureText;
import simpleray.image.png.ApngWriter;
import simpleray.image.png.KeptPicture;
import simpleray.image.png.PngWriter;
import simpleray.io.AtomicFile;
import simpleray.io.OutputTarget;
import simpleray.render.PreparedScene;
import simpleray.render.Progress;
import simpleray.render.Provenance;
import simpleray.render.RenderListener;
import simpleray.render.RenderRequest;
import simpleray.render.RenderStats;
import simpleray.render.RenderThreads;
import simpleray.render.Renderer;
import simpleray.scene.Film;
import simpleray.scene.FrameTexts;
import simpleray.scene.RayStats;
import simpleray.scene.Scene;
import simpleray.scene.SceneFile;

/**
 * Renders the frames of a film in order, and writes them. While a frame's last rows are rendered and its file is ended, the next one is begun.
 * Frames in which nothing has changed since the one before are not rendered again.
 * <em>Mutable</em>: one makes one film, once.
 */
public final class FilmRenderer {
    private static final int MAX_DELAY = 65535;
    /** The most parts of objects that move of which two frames are compiled at a time. */
    private static final long MAX_MOVED = 100_000;

    private final RenderRequest request;
    private final FilmOutput output;
    private final Film film;
    private final FrameTexts texts;
    private final Turntable turned;                           // null if the scene moves by itself
    private final FrameRate fps;
    private final String rateNote;
    private final BitSet frames;
    private final BitSet kept = new BitSet();                 // frames that an ended run has left
    private final AtomicInteger whole = new AtomicInteger();  // frames that are there
    private final PreparedScene prepared;
    private final long bytesNeeded;
    private final int width;                                  // of each frame
    private final int height;
    private final int threads;
    private final RayStats rays = new RayStats();
    private boolean counted = true;                           // the rays of all frames so far
    private double readySeconds;
    private double renderSeconds;
    private final Set<String> notes = ConcurrentHashMap.newKeySet();   // said of one file, and true of all
    private Listener listener;
    private RenderListener rows;
    private FfmpegFilm ffmpeg;                                // null for none
    private final Deque<OpenFrame> open = new ArrayDeque<>();  // the next to be finished first
    private boolean cancelled;
    private boolean done;

    /**
     * What is made of a scene. <em>Constant.</em>
     *
     * @param frames the numbers of the frames; null for all
     * @param turns the frames in which the camera goes once round; 0 if the scene moves by itself
     * @param rate the frames a second; null for the scene's
     */
    public record Plan(BitSet frames, int turns, FrameRate rate) {
        /** All frames of a film at its own rate. */
        public static final Plan ALL = new Plan(null, 0, null);
    }

    /** What is done with the frames of an ended run. */
    public enum Kept {
        /** A folder of them beside the film is an error; others are written over. */
        REFUSED,
        /** The whole ones stay. */
        RESUMED,
        /** They are discarded. */
        DISCARDED
    }

    /** Is told how far the film is, by the thread that writes it and those that render. */
    public interface Listener {
        /**
         * Takes notice of the frames of an ended run.
         *
         * @param count how many of them stay
         */
        void found(int count);

        /**
         * Begins to count.
         *
         * @param progress counts the rows of all frames
         * @return is told of each row, and counts it
         */
        RenderListener begins(Progress progress);

        /**
         * Takes notice of a file that was not written as files usually are: the first of those of which the same is true.
         *
         * @param text says in what way, with the file's name
         */
        void note(String text);
    }

    /** What a frame is rendered of. */
    private record Frame(Scene scene, RenderRequest request) {
    }

    /** A frame that is being rendered and written. */
    private abstract class OpenFrame implements RenderListener {
        final int number;
        final Renderer renderer;
        final List<Integer> same = new ArrayList<>();         // the frames behind it that look like it

        OpenFrame(int number, Renderer renderer) {
            this.number = number;
            this.renderer = renderer;
        }

        @Override
        public void rowFinished(int y) {
            try {
                take(y);
            } catch (IOException e) {
                throw new UncheckedIOException(e);
            }
            renderer.picture().release(y);
            rows.rowFinished(y);
        }

        abstract void take(int y) throws IOException;

        /** Writes what comes behind the rows. */
        abstract void end() throws IOException;

        /** Writes it once more, as another frame. */
        abstract void repeat(int other) throws IOException;

        /** Discards the file, unless it was ended. */
        void close() throws IOException {
            // there may be none
        }
    }

    /** A frame in a PNG of its own. */
    private final class PngFrame extends OpenFrame {
        private final String name;
        private final AtomicFile target;
        private final PngWriter png;

        PngFrame(int number, Frame of, Renderer renderer) throws FilmException {
            super(number, renderer);
            name = output.frame(number);
            target = begin(name);
            renderer.picture().tell(() -> texts(of));
            png = new PngWriter(renderer.picture(), target.out());
        }

        @Override
        void take(int y) throws IOException {
            try {
                png.row(y);
            } catch (IOException e) {
                throw notWritten(name, e.getMessage());
            }
        }

        @Override
        void end() throws IOException {
            try {
                png.end();
                target.commit();
            } catch (IOException e) {
                throw notWritten(name, e.getMessage());
            }
        }

        @Override
        void repeat(int other) throws IOException {
            String copy = output.frame(other);
            try (AtomicFile again = begin(copy)) {
                Files.copy(Path.of(name), again.out());
                again.commit();
            } catch (FilmException e) {
                throw e;
            } catch (IOException e) {
                throw notWritten(copy, e.getMessage());
            }
        }

        @Override
        void close() throws IOException {
            try {
                target.close();
            } catch (IOException e) {
                throw notWritten(name, e.getMessage());
            }
        }
    }

    /** A frame that goes to ffmpeg. */
    private final class CodedFrame extends OpenFrame {
        private final FfmpegFilm coder;
        private final byte[] levels = new byte[3 * width * height];

        CodedFrame(int number, Renderer renderer, FfmpegFilm coder) {
            super(number, renderer);
            this.coder = coder;
        }

        @Override
        void take(int y) {
            byte[] row = Picture.levels(renderer.picture().over(y, 0));   // films have no alpha
            System.arraycopy(row, 0, levels, row.length * y, row.length);
        }

        @Override
        void end() throws IOException {
            coder.frame(levels);
        }

        @Override
        void repeat(int other) throws IOException {
            end();
        }
    }

    /** Opens what a frame is written to. */
    private interface Opener {
        OpenFrame open(int number, Frame of, Renderer renderer) throws IOException;
    }

    /**
     * Finds out which frames there are, and whether they can be rendered and written.
     *
     * @param file the scene
     * @param request with which each frame is rendered
     * @param output what the film is written to
     * @param plan what is made of the scene
     * @throws IllegalArgumentException if it makes no sense; the message says why
     */
    public FilmRenderer(SceneFile file, RenderRequest request, FilmOutput output, Plan plan) {
        this.request = request;
        this.output = output;
        film = file.scene().film();
        film.check(request.settings());
        texts = new FrameTexts(file);
        int count = plan.turns > 0 ? plan.turns : film.frames();
        turned = plan.turns > 0 ? new Turntable(film.still(0).settings, request, count) : null;
        frames = new BitSet();
        frames.set(0, count);
        if (plan.frames != null) {
            BitSet beyond = (BitSet) plan.frames.clone();
            beyond.andNot(frames);
            if (!beyond.isEmpty()) {
                throw new IllegalArgumentException("the film has the frames 0 to " + (count - 1) + ", and not " + beyond.nextSetBit(0));
            }
            frames.and(plan.frames);
        }
        fps = plan.rate != null ? plan.rate : new FrameRate(film.rate());
        rateNote = output.kind() == FilmOutput.Kind.GIF ? GifFilm.note(fps) : null;
        if (output.kind() == FilmOutput.Kind.APNG) {
            fps.fraction(MAX_DELAY);
        }
        Frame first = frame(frames.nextSetBit(0));
        prepared = new PreparedScene(first.scene);
        Renderer renderer = prepared.renderer(first.request);
        width = renderer.picture().width();
        height = renderer.picture().height();
        threads = renderer.threads();
        long frame = 3L * width * height;
        if (output.kind().isByFfmpeg() && frame > Integer.MAX_VALUE - Long.BYTES) {
            throw new IllegalArgumentException("a film of frames of " + size() + " is too large for ffmpeg");
        }
        long extra = output.kind().isByFfmpeg() ? frame : output.kind() == FilmOutput.Kind.GIF ? GifFilm.bytesNeeded(width, height) : 0;
        bytesNeeded = renderer.bytesNeeded() + Math.max(extra, PngWriter.bytesNeeded(renderer.picture(), renderer.rowsAhead()));
    }

    /** {@return the bytes that rendering and writing a frame takes} */
    public long bytesNeeded() {
        return bytesNeeded;
    }

    /** {@return a frame's width and height, for messages} */
    public String size() {
        return width + "x" + height;
    }

    /** {@return the numbers of the frames, not to be changed} */
    public BitSet frames() {
        return frames;
    }

    /** {@return how many frames are there, whole} */
    public int whole() {
        return whole.get();
    }

    /** {@return what is to be said of the rate; null for nothing} */
    public String rateNote() {
        return rateNote;
    }

    /** {@return the work that the frames were which are rendered; the rays are null if they were not counted} */
    public RenderStats stats() {
        return new RenderStats(counted ? rays : null, readySeconds, renderSeconds);
    }

    /** Ends the rendering, now or as soon as it begins. Any thread may call. */
    public synchronized void cancel() {
        cancelled = true;
        open.forEach(frame -> frame.renderer.cancel());
        if (ffmpeg != null) {
            ffmpeg.close();                                   // it may be slow to take a frame
        }
    }

    /** {@return whether it was told to end} Faults from then on come from that. */
    public synchronized boolean isCancelled() {
        return cancelled;
    }

    /** {@return whether the film is there, whole} */
    public synchronized boolean isDone() {
        return done;
    }

    private synchronized void begins(OpenFrame frame) {
        open.add(frame);
        goOn();
    }

    private synchronized void begins(FfmpegFilm coder) {
        ffmpeg = coder;
        goOn();
    }

    private synchronized void goOn() {
        if (cancelled) {
            throw new CancellationException("told to stop");
        }
    }

    private synchronized void finished() {
        done = true;
    }

    /**
     * Renders the frames that are missing, and writes the film.
     *
     * @param before what is done with the frames of an ended run
     * @param told is told how far it is
     * @throws FilmException if the film cannot be written, or not over what is there
     * @throws CancellationException if it was {@linkplain #cancel cancelled}
     */
    public void write(Kept before, Listener told) throws FilmException {
        listener = told;
        try {
            if (!output.isSingle()) {
                findKept(before);
                renderFrames(PngFrame::new);
            } else {
                try (AtomicFile target = begin(output.name())) {
                    if (output.kind().isByFfmpeg()) {
                        pipe(target);
                    } else {
                        join(target, before);
                    }
                }
            }
            finished();
        } catch (FilmException e) {
            throw e;
        } catch (IOException e) {
            throw new FilmException(FilmException.Kind.NOT_WRITTEN, output.name() + ": cannot be written: " + OutputTarget.reason(e));
        }
    }

    private AtomicFile begin(String name) throws FilmException {
        try {
            return new AtomicFile(Path.of(name), note -> {
                if (notes.add(note)) {
                    listener.note((output.isSingle() ? output.name() : name) + ": " + note);
                }
            });
        } catch (IOException e) {
            throw FilmException.notCreated(name, e);
        }
    }

    /** {@return what a frame is rendered of} On a turntable things stand still once the scene's own film has ended. */
    private Frame frame(int number) {
        Scene still = film.still(Math.min(number, film.frames() - 1));
        return new Frame(still, turned == null ? request : request.with(turned.settings(number)));
    }

    /** {@return what a frame's picture is to carry} */
    private List<PictureText> texts(Frame frame) {
        return Provenance.of(frame.request, texts.of(frame.scene));
    }

    private void join(AtomicFile target, Kept before) throws IOException {
        if (output.hasFolder() && before == Kept.REFUSED) {
            throw new FilmException(FilmException.Kind.LEFT, output.place() + " holds frames of an earlier run");
        }
        try {
            if (before == Kept.DISCARDED) {
                output.removeFolder();
            }
            findKept(before);
            makeFolder();
            renderFrames(PngFrame::new);
            List<Path> files = frames.stream().mapToObj(f -> Path.of(output.frame(f))).toList();
            if (output.kind() == FilmOutput.Kind.GIF) {
                GifFilm.write(files, fps, target.out());
            } else {
                FrameRate.Fraction fraction = fps.fraction(MAX_DELAY);
                ApngWriter.write(files, /* numerator= */ fraction.denominator(), /* denominator= */ fraction.numerator(), target.out());
            }
            target.commit();
            finished();
            output.removeFolder();
        } finally {
            if (!output.keepsFrames()) {
                output.removeFolder();
            }
        }
    }

    private void makeFolder() throws FilmException {
        try {
            output.makeFolder();
        } catch (FileAlreadyExistsException e) {
            throw new FilmException(FilmException.Kind.NOT_CREATED, output.place() + ": cannot be created: " + e.getFile() + " is no folder");
        } catch (IOException e) {
            throw FilmException.notCreated(output.place(), e);
        }
    }

    private void pipe(AtomicFile target) throws IOException {
        try (FfmpegFilm coder = ffmpeg(target.file())) {
            begins(coder);
            renderFrames((f, frame, renderer) -> new CodedFrame(f, renderer, coder));
            coder.end();
            target.commit();
        }
    }

    private FfmpegFilm ffmpeg(Path target) throws FilmException {
        try {
            return new FfmpegFilm(FfmpegFilm.PROGRAM, FfmpegFilm.Format.valueOf(output.kind().name()), width, height, fps, target);
        } catch (IOException e) {
            throw new FilmException(FilmException.Kind.NO_FFMPEG, output.name() + ": ffmpeg makes it, and is not on the PATH: install it "
                + "(Debian: apt-get install ffmpeg), or make a .gif or .apng");
        }
    }

    private void findKept(Kept before) throws IOException {
        if (before != Kept.RESUMED) {
            return;
        }
        for (int f = frames.nextSetBit(0); f >= 0; f = frames.nextSetBit(f + 1)) {
            switch (KeptPicture.find(Path.of(output.frame(f)), texts(frame(f)))) {
                case WHOLE -> kept.set(f);
                case OTHER -> throw new FilmException(FilmException.Kind.FOREIGN, output.frame(f) + ": is not frame " + f
                    + " of this film, or was made with other options or by another version");
                default -> { }                                // is rendered
            }
        }
        whole.set(kept.cardinality());
        listener.found(whole());
    }

    private void renderFrames(Opener opener) throws IOException {
        long known = (long) height * kept.cardinality();
        Progress progress = new Progress((long) height * frames.cardinality(), System.nanoTime(), known);
        progress.rowsFinished(known);
        rows = listener.begins(progress);
        boolean fit = 2 * bytesNeeded <= Runtime.getRuntime().maxMemory() / 2
            && (!film.movesObjects() || parts(film.still(0)) <= MAX_MOVED);
        int ahead = fit ? 1 : 0;                              // frames that are rendered beside the one that is being finished
        long start = System.nanoTime();
        try (RenderThreads workers = new RenderThreads(threads)) {
            try {
                for (int f = frames.nextSetBit(0); f >= 0; f = frames.nextSetBit(f + 1)) {
                    OpenFrame before = open.peekLast();
                    if (!kept.get(f) && before != null && turned == null && film.areSame(before.number, f)) {
                        before.same.add(f);
                    } else if (!kept.get(f)) {
                        finish(ahead);
                        begin(f, opener, workers);
                    }
                }
                finish(0);
            } finally {
                abandon();
            }
        }
        renderSeconds = Math.max(0, Progress.seconds(start, System.nanoTime()) - readySeconds);
    }

    private static long parts(Scene scene) {
        long sum = 0;
        for (int i = 0; i < scene.getNumberObjects(); i++) {
            sum += scene.getObject(i).parts();
        }
        return sum;
    }

    private void begin(int f, Opener opener, RenderThreads workers) throws IOException {
        Frame of = frame(f);
        OpenFrame frame = opener.open(f, of, prepared.renderer(of.request, of.scene));
        begins(frame);
        frame.renderer.begin(workers, frame);
    }

    /** Finishes frames, all but so many. */
    private void finish(int left) throws IOException {
        while (open.size() > left) {
            OpenFrame frame = open.peek();
            try {
                frame.renderer.end();
            } catch (UncheckedIOException e) {
                throw e.getCause();
            }
            frame.end();
            frame.close();
            whole.incrementAndGet();
            for (int other : frame.same) {
                goOn();
                frame.repeat(other);
                whole.incrementAndGet();
                for (int y = 0; y < height; y++) {
                    rows.rowFinished(y);
                }
            }
            count(frame.renderer.stats());
            ended();
        }
    }

    private synchronized void ended() {
        open.remove();
    }

    /** Ends what is still open, after a fault. */
    private void abandon() throws IOException {
        synchronized (this) {
            open.forEach(frame -> frame.renderer.cancel());
        }
        while (!open.isEmpty()) {
            OpenFrame frame = open.peek();
            frame.renderer.await();
            frame.close();
            ended();
        }
    }

    private void count(RenderStats frame) {
        counted = counted && frame.rays() != null;
        if (counted) {
            rays.add(frame.rays());
        }
        readySeconds += frame.readySeconds();
    }

    private static FilmException notWritten(String name, String reason) {
        return new FilmException(FilmException.Kind.NOT_WRITTEN, name + ": cannot be written: " + reason);
    }
}
