package simpleray.cli;

import java.util.BitSet;
import java.util.concurrent.Callable;
import java.util.concurrent.CancellationException;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.ParentCommand;
import simpleray.film.FilmException;
import simpleray.film.FilmOutput;
import simpleray.film.FilmRenderer;
import simpleray.film.FrameList;
import simpleray.film.FrameRate;
import simpleray.film.Turntable;
import simpleray.render.Progress;
import simpleray.render.Region;
import simpleray.render.RenderListener;
import simpleray.render.RenderRequest;
import simpleray.scene.Film;
import simpleray.scene.SceneFile;
import simpleray.text.NumberParser;

/** Renders the frames of a film. */
@Command(mixinStandardHelpOptions = true, sortOptions = false,
    description = "Renders a film: the scene's frames, or a camera that goes once round what it looks at.")
final class AnimateCommand implements Callable<Integer> {
    /** The option with or without a number. */
    static final String TURNTABLE = "--turntable";

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
    private final OptionGroup others = new OptionGroup();
    private final CommandOption<Stats.Format> stats = others.add(RenderCommand.statsOption());
    private final CommandOption<Region> region = others.add(RenderCommand.regionOption());

    @Mixin
    private final OutsideOption outside = new OutsideOption();

    private final long start = System.nanoTime();
    private FilmOutput output;
    private FilmRenderer film;
    private ProgressPrinter printer;                          // null before there is progress

    @Override
    public Integer call() throws CommandException {
        RenderRequest request = picture.request(stage.stage(), work.threads()).with(work.accel()).with(region.value());
        output = output();
        OutputName.refuseScene(out, scene);
        if (resume.value() && !output.keepsFrames()) {
            throw CommandException.usage("--resume needs frames that stay: " + (output.kind().isByFfmpeg()
                ? "those of " + out + " go to ffmpeg at once; film.%04d.png keeps them, and ffmpeg makes a film of these" : out + " is no file"));
        }
        SceneFile file = SceneArgument.read(scene, main.in(), work.warnings(main.err()), outside.reach());
        double readSeconds = Progress.seconds(start, System.nanoTime());
        OutputName.refuseNamed(out, scene, file);
        film = film(file, request);
        refuseInputs(file);
        RenderCheckpointer.Notes notes = new RenderCheckpointer.Notes(main.err(), work.quiet(), main.args(), main.lines());
        FilmInterrupt listening = new FilmInterrupt(film, notes, () -> kept(notes));
        try (listening) {
            write(notes);
            report(readSeconds);
            return ExitCode.DONE;
        } catch (CancellationException e) {                   // the program is told to stop; FilmInterrupt says so
            return ExitCode.INTERRUPTED;
        } catch (FilmException e) {
            if (film.isCancelled()) {
                return ExitCode.INTERRUPTED;
            }
            throw new CommandException(exitCode(e.kind()), "simpleray: " + e.getMessage() + hint(e.kind()));
        }
    }

    private FilmOutput output() throws CommandException {
        try {
            return FilmOutput.of(out);
        } catch (IllegalArgumentException e) {
            throw CommandException.usage(e.getMessage());
        }
    }

    private FilmRenderer film(SceneFile file, RenderRequest request) throws CommandException {
        FilmRenderer made;
        try {
            made = new FilmRenderer(file, request, output, new FilmRenderer.Plan(listed.value(), turns(file), rate.value()));
        } catch (IllegalArgumentException e) {
            throw CommandException.usage(e.getMessage());
        }
        if (made.rateNote() != null && !work.quiet()) {
            main.err().println("simpleray: " + out + ": " + made.rateNote());
        }
        HeapCheck.require("a film of frames of " + made.size(), made.bytesNeeded());
        return made;
    }

    /** {@return the frames of the turntable; 0 for none} */
    private int turns(SceneFile file) throws CommandException {
        if (turntable == null) {
            return 0;
        }
        if (turntable.isEmpty()) {
            return file.scene().settings.frames == null ? Turntable.USUAL_FRAMES : file.scene().film().frames();
        }
        Long count = NumberParser.parseInteger(turntable, 1, Film.MAX_FRAMES);
        if (count == null) {
            throw CommandException.usage("--turntable must be 1 to " + Film.MAX_FRAMES + ", and is '" + turntable + "'");
        }
        return count.intValue();
    }

    /** Makes sure that no frame is written over what is read. */
    private void refuseInputs(SceneFile file) throws CommandException {
        BitSet frames = film.frames();
        for (int f = output.isSingle() ? -1 : frames.nextSetBit(0); f >= 0; f = frames.nextSetBit(f + 1)) {
            String name = output.frame(f);
            OutputName.refuseScene(name, scene);
            OutputName.refuseNamed(name, scene, file);
            OutputName.refuseSceneNames(name);
        }
    }

    /** {@return what a run that is told to stop has left} */
    private String kept(RenderCheckpointer.Notes notes) {
        return output.keepsFrames() && film.whole() > 0
            ? ": " + film.whole() + " of " + film.frames().cardinality() + " frames are kept in " + output.place() + "; to go on: "
                + notes.command()
            : " after " + Progress.time(Progress.seconds(start, System.nanoTime())) + ", and nothing is kept"
                + (output.kind().isByFfmpeg() ? ": film.%04d.png keeps each frame" : "");
    }

    private void write(RenderCheckpointer.Notes notes) throws FilmException {
        int count = film.frames().cardinality();
        try {
            film.write(restart.value() ? FilmRenderer.Kept.DISCARDED : resume.value() ? FilmRenderer.Kept.RESUMED
                : FilmRenderer.Kept.REFUSED, new FilmRenderer.Listener() {
                    @Override
                    public void found(int frames) {
                        notes.say(frames == 0 ? "no frame is kept: beginning with the first"
                            : "going on with " + frames + " of " + count + " frames, kept in " + output.place());
                    }

                    @Override
                    public RenderListener begins(Progress progress) {
                        printer = work.printer(progress, main, new ProgressPrinter.Unit("frames", (int) (progress.rows() / count)));
                        return printer;
                    }

                    @Override
                    public void note(String text) {
                        notes.say(text);
                    }
                });
        } finally {
            if (printer != null) {
                printer.end();
            }
        }
    }

    private String hint(FilmException.Kind kind) {
        return switch (kind) {
            case LEFT -> ": --resume goes on with them, --restart discards them";
            case FOREIGN -> output.isSingle() ? ": --restart discards it" : ": without --resume it is written over";
            default -> "";
        };
    }

    private static int exitCode(FilmException.Kind kind) {
        return switch (kind) {
            case NOT_CREATED, LEFT -> ExitCode.NO_OUTPUT;
            case BUSY -> ExitCode.BUSY;
            case FOREIGN -> ExitCode.BAD_SCENE;
            case NO_FFMPEG -> ExitCode.UNAVAILABLE;
            default -> ExitCode.WRITE_ERROR;
        };
    }

    private void report(double readSeconds) throws CommandException {
        int count = film.frames().cardinality();
        if (!work.quiet()) {
            main.err().println(out + ": " + (count == 1 ? "1 frame" : count + " frames") + " of " + film.size() + ", "
                + Progress.time(Progress.seconds(start, System.nanoTime())));
        }
        if (stats.value() != null) {
            String text = new Stats(readSeconds, film.stats()).text(stats.value());
            if (OutputName.isStandardOutput(out)) {
                main.err().print(text);
            } else {
                TextOutput.say(main, text);
            }
        }
    }
}
