package simpleray.cli;

import java.io.BufferedOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.io.UncheckedIOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CancellationException;
import java.util.function.Supplier;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.ParentCommand;
import simpleray.image.Picture;
import simpleray.image.PictureText;
import simpleray.image.png.PngWriter;
import simpleray.io.AtomicFile;
import simpleray.io.OutputTarget;
import simpleray.render.Band;
import simpleray.render.PictureIdentity;
import simpleray.render.Progress;
import simpleray.render.Provenance;
import simpleray.render.Region;
import simpleray.render.RenderListener;
import simpleray.render.RenderRequest;
import simpleray.render.Renderer;
import simpleray.scene.Scene;
import simpleray.scene.SceneFile;

/** Renders a scene into a PNG file, without a window. */
@Command(mixinStandardHelpOptions = true, sortOptions = false,
    description = "Renders a scene into a PNG file, without a window.")
final class RenderCommand implements PlainCommand {
    @ParentCommand
    private Main main;

    @Parameters(paramLabel = "SCENE", description = SceneArgument.DESCRIPTION)
    private String scene;

    @Mixin
    private final OptionGroup target = new OptionGroup();
    private final CommandOption<String> out = target.add(
        CommandOption.text("OUT.png", "The PNG file to write; - is standard output.", "-o", "--output").required());

    @Mixin
    private final PictureOptions picture = new PictureOptions();

    @Mixin
    private final StageOption stage = new StageOption();

    @Mixin
    private final FrameOption frame = new FrameOption();

    @Mixin
    private final WorkOptions work = new WorkOptions();

    @Mixin
    private final CheckpointOptions keep = new CheckpointOptions();

    @Mixin
    private final OutsideOption outside = new OutsideOption();

    @Mixin
    private final OptionGroup others = new OptionGroup();
    private final CommandOption<Stats.Format> stats = others.add(statsOption());
    private final CommandOption<Region> region = others.add(regionOption());
    private final CommandOption<Band> band = others.add(new CommandOption<>(null, "I/N",
        "Only band I, from 1 on, of the N bands of rows into which the picture, or the region, is cut; simpleray merge makes the "
            + "picture of all its bands.", "--band") {
        @Override
        Band parse(String text) {
            return Band.parse(text);
        }
    });
    private final CommandOption<Boolean> skipDone = others.add(CommandOption.flag(
        "Do nothing if OUT.png is there, whole, of the same scene and options and by this version; whatever else is there is "
            + "written over, as always.", "--skip-done"));

    private String output;                                    // - for standard output
    private String rows;                                      // the band's; null for all
    private final long start = System.nanoTime();
    private double readSeconds;

    /** As picocli makes it, which then fills in the fields. */
    RenderCommand() {
    }

    /** A command whose line is read without picocli. */
    RenderCommand(Main main) {
        this.main = main;
    }

    /** {@return the option that asks for statistics, of a picture or a film} */
    static CommandOption<Stats.Format> statsOption() {
        return CommandOption.choice(Stats.Format.values(), null, "FORMAT",
            "Also print what was done, on standard output (on standard error if the picture goes there): rays by kind and "
                + "depth, tests a ray, time of each phase. FORMAT: ${COMPLETION-CANDIDATES}.", "--stats");
    }

    /** {@return the option that asks for a piece of a picture, or of each frame of a film} */
    static CommandOption<Region> regionOption() {
        return new CommandOption<>(null, "X,Y,W,H",
            "Only this piece of the picture: the column of its left edge, the row of its upper one, its width and height in "
                + "pixels. They are the pixels of the whole picture.", "--region") {
            @Override
            Region parse(String text) {
                return Values.region(text);
            }
        };
    }

    @Override
    public List<OptionGroup> options() {
        return List.of(target, picture, stage, frame, work, keep, outside, others);
    }

    @Override
    public void setScene(String name) {
        scene = name;
    }

    @Override
    public boolean needsScene() {
        return true;
    }

    @Override
    public String name() {
        return "render";
    }

    @Override
    public Integer call() throws CommandException {
        RenderRequest request = picture.request(stage.stage(), work.threads()).with(work.accel()).with(region.value()).with(band.value());
        output = out.value();
        work.requireFreeOutput(output);
        boolean stream = output.equals(SceneArgument.STREAM);
        if (skipDone.value() && (stream || OutputTarget.isStream(Path.of(output)))) {
            throw CommandException.usage("--skip-done looks for a file, and " + (stream ? "standard output" : output) + " is none");
        }
        OutputName.refuseOtherFormats(output);
        OutputName.refuseScene(output, scene);
        OutputName.refuseSceneNames(output);
        Path kept = keep.file(output);
        long begin = System.nanoTime();
        SceneFile read = frame.of(SceneArgument.read(scene, main.in(), work.warnings(main.err()), outside.reach()), scene);
        readSeconds = Progress.seconds(begin, System.nanoTime());
        OutputName.refuseNamed(output, scene, read);
        Renderer renderer = renderer(request, read.scene());
        rows = band.value() == null ? null : band.value().rows(request.whole(request.applyTo(read.scene()).settings));
        Picture asked = renderer.picture();
        asked.tell(new Supplier<List<PictureText>>() {            // later: the digest of the scene takes a while to load
            @Override
            public List<PictureText> get() {
                return Provenance.of(request, read);
            }
        });
        if (skipDone.value() && DonePicture.isThere(Path.of(output), asked.texts(), asked, rows)) {
            work.skipped(main, output);
            return ExitCode.DONE;
        }
        HeapCheck.require("a picture of " + asked.width() + 'x' + asked.height(),
            renderer.bytesNeeded() + PngWriter.bytesNeeded(asked, renderer.rowsAhead()));
        Supplier<Map<String, String>> identity = new Supplier<>() {
            @Override
            public Map<String, String> get() {
                return PictureIdentity.of(Main.version(), request, read.scene());
            }
        };
        RenderCheckpointer.Notes notes = new RenderCheckpointer.Notes(main.err(), work.quiet(), main.args(), main.lines());
        try (RenderCheckpointer checkpointer = new RenderCheckpointer(kept, renderer, identity, notes)) {
            if (output.equals(SceneArgument.STREAM)) {
                toStream(renderer, checkpointer);
            } else {
                toFile(renderer, checkpointer);
            }
            return ExitCode.DONE;
        } catch (CancellationException e) {                   // the program is told to stop; RenderCheckpointer says so
            return ExitCode.INTERRUPTED;
        }
    }

    /** Makes the renderer, if the picture, whose size is known only now, has the region that is asked for. */
    private static Renderer renderer(RenderRequest request, Scene read) throws CommandException {
        try {
            return request.renderer(read);
        } catch (IllegalArgumentException e) {
            throw CommandException.usage(e.getMessage());
        }
    }

    private void toStream(Renderer renderer, RenderCheckpointer checkpointer) throws CommandException {
        try {
            checkpointer.begin(keep, null, RenderCheckpointer.LATE);
            render(renderer, new BufferedOutputStream(main.out()), checkpointer);
            checkpointer.finished();
            report("<stdout>", renderer);
        } catch (IOException e) {
            throw new CommandException(ExitCode.WRITE_ERROR, "simpleray: the picture cannot be written to standard output: " + e.getMessage());
        }
    }

    private void toFile(Renderer renderer, RenderCheckpointer checkpointer) throws CommandException {
        try (AtomicFile file = TextOutput.begin(output, work.warnings(main.err()))) {
            checkpointer.begin(keep, file, RenderCheckpointer.LATE);
            render(renderer, file.out(), checkpointer);
            file.commit();
            checkpointer.finished();
            report(output, renderer);
        } catch (IOException e) {
            throw new CommandException(ExitCode.WRITE_ERROR, "simpleray: " + output + ": cannot be written: " + e.getMessage());
        }
    }

    /** Writes each row as soon as it can be, and lets go of it. What cannot be written ends the rendering. */
    private void render(Renderer renderer, OutputStream out, RenderCheckpointer checkpointer) throws IOException {
        Picture rendered = renderer.picture();
        PngWriter png = new PngWriter(rendered, out, checkpointer, rows);
        ProgressPrinter printer = work.printer(new Progress(rendered.height(), start, checkpointer.known()), main);
        try {
            renderer.render(new RenderListener() {
                @Override
                public void rowFinished(int y) {
                    write(png, y);
                    rendered.release(y);
                    printer.rowFinished(y);
                }
            });
        } catch (UncheckedIOException e) {
            throw e.getCause();
        } finally {
            printer.end();
        }
        png.end();
    }

    private static void write(PngWriter png, int y) {
        try {
            png.row(y);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    private void report(String name, Renderer renderer) throws CommandException {
        work.report(main, name, renderer.picture(), Progress.seconds(start, System.nanoTime()));
        if (stats.value() == null) {
            return;
        }
        String text = new Stats(readSeconds, renderer.stats()).text(stats.value());
        if (OutputName.isStandardOutput(output)) {
            main.err().print(text);
        } else {
            TextOutput.say(main, text);
        }
    }
}
