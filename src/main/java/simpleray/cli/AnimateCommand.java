package simpleray.cli;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Path;
import java.util.BitSet;
import java.util.List;
import java.util.concurrent.Callable;
import java.util.concurrent.CancellationException;
import java.util.concurrent.atomic.AtomicInteger;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.ParentCommand;
import simpleray.film.FfmpegFilm;
import simpleray.film.FrameList;
import simpleray.film.FrameRate;
import simpleray.film.GifFilm;
import simpleray.film.Turntable;
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
import simpleray.render.Renderer;
import simpleray.scene.Film;
import simpleray.scene.FrameTexts;
import simpleray.scene.Scene;
import simpleray.scene.SceneFile;
import simpleray.text.NumberParser;

/** Renders the frames of a film. */
@Command(mixinStandardHelpOptions = true, sortOptions = false,
    description = "Renders a film: the scene's frames, or a camera that goes once round what it looks at.")
final class AnimateCommand implements Callable<Integer> {
    /** The option with or without a number. */
    static final String TURNTABLE = "--turntable";
    private static final int MAX_DELAY = 65535;

    @ParentCommand
    private Main main;

    @Parameters(paramLabel = "SCENE", description = SceneArgument.DESCRIPTION)
    private String scene;

    @Option(names = {"-o", "--output"}, paramLabel = "FILM", required = true,
        description = "Numbered PNG files, such as film.%%04d.png for film.0000.png and so on; or one file: .gif, .apng (an animated PNG, which "
            + "loses nothing), or .mp4 or .webm, for which ffmpeg must be there.")
    private String out;

    @Mixin
    private final OptionGroup which = new OptionGroup();
    private final CommandOption<BitSet> listed = which.add(new CommandOption<>(null, "LIST",
        "Only these frames of the film, such as 0-99,120; the first is 0.", "--frames") {
        @Override
        BitSet parse(String text) {
            return FrameList.parse(text, "numbers of frames");
        }
    });

    @Option(names = TURNTABLE, paramLabel = "N", arity = "0..1",
        description = "The camera goes once round what it looks at, in N frames (default: as many as the scene has, or " + Turntable.USUAL_FRAMES
            + " if it has none).")
    private String turntable;                                 // "" without N

    @Mixin
    private final OptionGroup rates = new OptionGroup();
    private final CommandOption<FrameRate> rate = rates.add(new CommandOption<>(null, "R",
        "Frames a second, above 0 and at most 1000 (default: the scene's, or 25).", "--fps") {
        @Override
        FrameRate parse(String text) {
            return Values.rate(text);
        }
    });

    @Mixin
    private final PictureOptions picture = new PictureOptions();

    @Mixin
    private final StageOption stage = new StageOption();

    @Mixin
    private final WorkOptions work = new WorkOptions();

    @Mixin
    private final OptionGroup keep = new OptionGroup();
    private final CommandOption<Boolean> resume = keep.add(CommandOption.flag("Go on with the whole frames that an ended run has left; the film is the "
        + "same as if it had not been ended. Not for .mp4 and .webm.", "--resume"));
    private final CommandOption<Boolean> restart = keep.add(CommandOption.flag(
        "Discard the frames that an ended run has left, and begin anew.", "--restart"));

    @Mixin
    private final OutsideOption outside = new OutsideOption();

    private final long start = System.nanoTime();
    private RenderRequest request;
    private FilmOutput output;
    private SceneFile file;
    private Film film;
    private FrameTexts texts;
    private Turntable turned;                                 // null if the scene moves by itself
    private FrameRate fps;
    private BitSet frames;
    private final BitSet kept = new BitSet();                 // frames that an ended run has left
    private final AtomicInteger whole = new AtomicInteger();  // frames that are there
    private PreparedScene prepared;
    private int width;                                        // of each frame
    private int height;
    private FilmInterrupt interrupt;
    private ProgressPrinter printer;

    /** What a frame is rendered of. */
    private record Frame(Scene scene, RenderRequest request) {
    }

    /** Writes a frame while it is rendered. */
    private interface Writer {
        void write(int frame, Frame of, Renderer renderer) throws IOException, CommandException;
    }

    @Override
    public Integer call() throws CommandException {
        request = picture.request(stage.stage(), work.threads()).with(work.accel());
        output = FilmOutput.of(out);
        OutputName.refuseScene(out, scene);
        if (resume.value() && !output.keepsFrames()) {
            throw CommandException.usage("--resume needs frames that stay: " + (output.kind().isByFfmpeg()
                ? "those of " + out + " go to ffmpeg at once; film.%04d.png keeps them, and ffmpeg makes a film of these" : out + " is no file"));
        }
        file = SceneArgument.read(scene, main.in(), work.warnings(main.err()), outside.reach());
        OutputName.refuseNamed(out, scene, file);
        plan();
        RenderCheckpointer.Notes notes = new RenderCheckpointer.Notes(main.err(), work.quiet(), main.args(), main.lines());
        try (FilmInterrupt listening = new FilmInterrupt(notes, () -> kept(notes))) {
            interrupt = listening;
            render(notes);
            return ExitCode.DONE;
        } catch (CancellationException e) {                   // the program is told to stop; FilmInterrupt says so
            return ExitCode.INTERRUPTED;
        } catch (IOException | CommandException e) {
            if (interrupt.isStopped()) {
                return ExitCode.INTERRUPTED;
            }
            if (e instanceof CommandException known) {
                throw known;
            }
            throw new CommandException(ExitCode.WRITE_ERROR, "simpleray: " + out + ": cannot be written: " + OutputTarget.reason((IOException) e));
        }
    }

    /** Finds out which frames there are, and whether they can be rendered and written. */
    private void plan() throws CommandException {
        try {
            film = file.scene().film();
            film.check(request.settings());
            texts = new FrameTexts(file);
            int count = film.frames();
            if (turntable != null) {
                count = turntableFrames();
                turned = new Turntable(film.still(0).settings, request, count);
            }
            frames = new BitSet();
            frames.set(0, count);
            if (listed.value() != null) {
                BitSet beyond = (BitSet) listed.value().clone();
                beyond.andNot(frames);
                if (!beyond.isEmpty()) {
                    throw CommandException.usage("the film has the frames 0 to " + (count - 1) + ", and not " + beyond.nextSetBit(0));
                }
                frames = listed.value();
            }
            fps = rate.value() != null ? rate.value() : new FrameRate(film.rate());
            String note = checkRate();
            if (note != null && !work.quiet()) {
                main.err().println("simpleray: " + out + ": " + note);
            }
            Frame first = frame(frames.nextSetBit(0));
            prepared = new PreparedScene(first.scene);
            Renderer renderer = prepared.renderer(first.request);
            width = renderer.picture().width();
            height = renderer.picture().height();
            requireMemory(renderer);
        } catch (IllegalArgumentException e) {
            throw CommandException.usage(e.getMessage());
        }
        if (output.kind() == FilmOutput.Kind.PNG) {
            for (int f = frames.nextSetBit(0); f >= 0; f = frames.nextSetBit(f + 1)) {
                String name = output.frame(f);
                OutputName.refuseScene(name, scene);
                OutputName.refuseNamed(name, scene, file);
                OutputName.refuseSceneNames(name);
            }
        }
    }

    private int turntableFrames() throws CommandException {
        if (turntable.isEmpty()) {
            return file.scene().settings.frames == null ? Turntable.USUAL_FRAMES : film.frames();
        }
        Long count = NumberParser.parseInteger(turntable, 1, Film.MAX_FRAMES);
        if (count == null) {
            throw CommandException.usage("--turntable must be 1 to " + Film.MAX_FRAMES + ", and is '" + turntable + "'");
        }
        return count.intValue();
    }

    /** {@return what is to be said of the rate; null for nothing} */
    private String checkRate() {
        switch (output.kind()) {
            case GIF:
                return GifFilm.note(fps);
            case APNG:
                fps.fraction(MAX_DELAY);
                return null;
            default:
                return null;
        }
    }

    private void requireMemory(Renderer renderer) throws CommandException {
        long frame = 3L * width * height;
        long extra = output.kind().isByFfmpeg() ? frame : output.kind() == FilmOutput.Kind.GIF ? GifFilm.bytesNeeded(width, height) : 0;
        if (output.kind().isByFfmpeg() && frame > Integer.MAX_VALUE - Long.BYTES) {
            throw CommandException.usage("a film of frames of " + width + 'x' + height + " is too large for ffmpeg");
        }
        HeapCheck.require("a film of frames of " + width + 'x' + height,
            renderer.bytesNeeded() + Math.max(extra, PngWriter.bytesNeeded(renderer.picture(), renderer.rowsAhead())));
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

    /** {@return what a run that is told to stop has left} */
    private String kept(RenderCheckpointer.Notes notes) {
        return output.keepsFrames() && whole.get() > 0
            ? ": " + whole + " of " + frames.cardinality() + " frames are kept in " + output.place() + "; to go on: " + notes.command()
            : " after " + Progress.time(Progress.seconds(start, System.nanoTime())) + ", and nothing is kept"
                + (output.kind().isByFfmpeg() ? ": film.%04d.png keeps each frame" : "");
    }

    private void render(RenderCheckpointer.Notes notes) throws IOException, CommandException {
        if (!output.isSingle()) {
            findKept(notes);
            renderFrames(this::writePng);
            report();
            return;
        }
        try (AtomicFile target = TextOutput.begin(out, work.warnings(main.err()))) {
            if (output.kind().isByFfmpeg()) {
                pipe(target);
            } else {
                if (output.hasFolder() && !resume.value() && !restart.value()) {
                    throw new CommandException(ExitCode.NO_OUTPUT, "simpleray: " + output.place()
                        + " holds frames of an earlier run: --resume goes on with them, --restart discards them");
                }
                join(target, notes);
            }
        }
        report();
    }

    private void join(AtomicFile target, RenderCheckpointer.Notes notes) throws IOException, CommandException {
        try {
            if (restart.value()) {
                output.removeFolder();
            }
            findKept(notes);
            output.makeFolder();
            renderFrames(this::writePng);
            List<Path> files = frames.stream().mapToObj(f -> Path.of(output.frame(f))).toList();
            if (output.kind() == FilmOutput.Kind.GIF) {
                GifFilm.write(files, fps, target.out());
            } else {
                FrameRate.Fraction fraction = fps.fraction(MAX_DELAY);
                ApngWriter.write(files, /* numerator= */ fraction.denominator(), /* denominator= */ fraction.numerator(), target.out());
            }
            target.commit();
            interrupt.finished();
            output.removeFolder();
        } finally {
            if (!output.keepsFrames()) {
                output.removeFolder();
            }
        }
    }

    private void pipe(AtomicFile target) throws IOException, CommandException {
        try (FfmpegFilm coder = ffmpeg(target.file())) {
            byte[] levels = new byte[3 * width * height];
            renderFrames((f, frame, renderer) -> {
                Picture rendered = renderer.picture();
                render(renderer, y -> {
                    byte[] row = Picture.levels(rendered.over(y, 0));   // films have no alpha
                    System.arraycopy(row, 0, levels, row.length * y, row.length);
                    rendered.release(y);
                    printer.rowFinished(y);
                });
                coder.frame(levels);
            });
            coder.end();
            target.commit();
            interrupt.finished();
        }
    }

    private FfmpegFilm ffmpeg(Path target) throws CommandException {
        try {
            return new FfmpegFilm(FfmpegFilm.PROGRAM, FfmpegFilm.Format.valueOf(output.kind().name()), width, height, fps, target);
        } catch (IOException e) {
            throw new CommandException(ExitCode.UNAVAILABLE, "simpleray: " + out + ": ffmpeg makes it, and is not on the PATH: install it "
                + "(Debian: apt-get install ffmpeg), or make a .gif or .apng");
        }
    }

    private void findKept(RenderCheckpointer.Notes notes) throws IOException, CommandException {
        if (!resume.value() || restart.value()) {
            return;
        }
        for (int f = frames.nextSetBit(0); f >= 0; f = frames.nextSetBit(f + 1)) {
            Frame frame = frame(f);
            switch (KeptPicture.find(Path.of(output.frame(f)), texts(frame))) {
                case WHOLE -> kept.set(f);
                case OTHER -> throw new CommandException(ExitCode.BAD_SCENE, "simpleray: " + output.frame(f) + ": is not frame " + f
                    + " of this film, or was made with other options or by another version: "
                    + (output.isSingle() ? "--restart discards it" : "without --resume it is written over"));
                default -> { }                                // is rendered
            }
        }
        whole.set(kept.cardinality());
        notes.say(kept.isEmpty() ? "no frame is kept: beginning with the first"
            : "going on with " + kept.cardinality() + " of " + frames.cardinality() + " frames, kept in " + output.place());
    }

    private void renderFrames(Writer writer) throws IOException, CommandException {
        long known = (long) height * kept.cardinality();
        Progress progress = new Progress((long) height * frames.cardinality(), start, known);
        progress.rowsFinished(known);
        printer = work.printer(progress, main, new ProgressPrinter.Unit("frames", height));
        try {
            for (int f = frames.nextSetBit(0); f >= 0; f = frames.nextSetBit(f + 1)) {
                if (!kept.get(f)) {
                    Frame frame = frame(f);
                    Renderer renderer = prepared.renderer(frame.request, frame.scene);
                    interrupt.renders(renderer);
                    writer.write(f, frame, renderer);
                    whole.incrementAndGet();
                }
            }
        } finally {
            printer.end();
        }
    }

    private void writePng(int f, Frame frame, Renderer renderer) throws IOException, CommandException {
        String name = output.frame(f);
        try (AtomicFile target = TextOutput.begin(name, work.warnings(main.err()))) {
            Picture rendered = renderer.picture();
            rendered.tell(() -> texts(frame));
            PngWriter png = new PngWriter(rendered, target.out());
            render(renderer, y -> {
                try {
                    png.row(y);
                } catch (IOException e) {
                    throw new UncheckedIOException(e);
                }
                rendered.release(y);
                printer.rowFinished(y);
            });
            png.end();
            target.commit();
        } catch (IOException e) {
            throw new CommandException(ExitCode.WRITE_ERROR, "simpleray: " + name + ": cannot be written: " + e.getMessage());
        }
    }

    private static void render(Renderer renderer, RenderListener listener) throws IOException {
        try {
            renderer.render(listener);
        } catch (UncheckedIOException e) {
            throw e.getCause();
        }
    }

    private void report() {
        interrupt.finished();
        if (!work.quiet()) {
            int count = frames.cardinality();
            main.err().println(out + ": " + (count == 1 ? "1 frame" : count + " frames") + " of " + width + 'x' + height + ", "
                + Progress.time(Progress.seconds(start, System.nanoTime())));
        }
    }
}
