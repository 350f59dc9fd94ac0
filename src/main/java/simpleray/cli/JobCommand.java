package simpleray.cli;

import java.io.File;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.ParentCommand;
import simpleray.render.Progress;
import simpleray.render.RenderRequest;
import simpleray.scene.Reach;
import simpleray.scene.Scene;
import simpleray.scene.SceneFile;
import simpleray.scene.SceneSettings.Resolution;
import simpleray.scene.Setting;
import simpleray.scene.SourceText;
import simpleray.ui.picture.CommandWords;

/** Writes a job that renders a scene on many machines. */
@Command(mixinStandardHelpOptions = true, sortOptions = false,
    description = "Writes a job that renders a scene on many machines: a folder with all that it needs, for an engine that runs it.")
final class JobCommand implements Callable<Integer> {
    private static final String FRAMES = "--frames";
    private static final String BANDS = "--bands";
    private static final String CHUNK = "--chunk";
    private static final String FILM = "--film";
    private static final String NO_FILM = "none";

    @ParentCommand
    private Main main;

    @Parameters(paramLabel = "SCENE", description = "The scene file.")
    private String scene;

    @Mixin
    private final OptionGroup job = new OptionGroup();
    private final CommandOption<JobEngine> engine = job.add(CommandOption.choice(JobEngine.values(), null, "ENGINE",
        "What runs the job: ${COMPLETION-CANDIDATES}.", "--for").required());
    private final CommandOption<String> output = job.add(
        CommandOption.text("DIR", "The folder to write, which is not there or empty.", "-o", "--output").required());
    private final CommandOption<FrameRanges> frames = job.add(new CommandOption<>(null, "FRAMES",
        "Only these frames of the film, such as 0-99,120 (default: all).", FRAMES) {
        @Override
        FrameRanges parse(String text) {
            return FrameRanges.parse(text);
        }
    });
    private final CommandOption<Integer> bands = job.add(CommandOption.integer("N",
        "Cut each picture into N bands of rows, which tasks of their own render (default: 1).", BANDS));
    private final CommandOption<Integer> chunk = job.add(CommandOption.integer("N",
        "Render N frames in each task (default: 1, or as many as it takes to have at most " + JobPlan.MAX_ARRAY + " tasks).", CHUNK));
    private final CommandOption<String> film = job.add(new CommandOption<>("film.apng", "FILM",
        "The film that is made of the pictures in the end, .apng or .gif (default: ${DEFAULT-VALUE}), or none.", FILM) {
        @Override
        String parse(String text) {
            if (!text.matches(NO_FILM + "|[A-Za-z0-9_][A-Za-z0-9._-]*\\.(apng|gif)")) {
                throw new IllegalArgumentException("expected a name of letters and digits that ends with .apng or .gif, or none, found '" + text + "'");
            }
            return text;
        }
    });

    @Mixin
    private final PictureOptions picture = new PictureOptions();

    @Mixin
    private final StageOption stage = new StageOption();

    @Override
    public Integer call() throws CommandException {
        RenderRequest request = picture.request(stage.stage(), 1);
        requireFrom1(BANDS, bands.value());
        requireFrom1(CHUNK, chunk.value());
        if (scene.equals(SceneArgument.STREAM)) {
            throw CommandException.usage("a job needs a scene's file, and standard input is none: its meshes are copied with it");
        }
        SceneFile read = SceneArgument.read(scene, main.in(), main.err(), Reach.FOLDER);
        Resolution size = Setting.RESOLUTION.in(request.applyTo(read.scene()).settings);
        if (bands() > size.height()) {
            throw CommandException.usage(BANDS + " must be at most the picture's " + size.height() + " rows, and is " + bands());
        }
        FrameRanges asked = asked(read.scene());
        SourceText text = read.text();
        read = null;                                          // its memory is needed for the copy
        try (JobFolder folder = new JobFolder(output.value())) {
            JobPlan plan = plan(request, size, asked, copy(folder, text));
            if (asked != null) {
                folder.makeFolder("frames");
            }
            if (plan.bands() > 1) {
                folder.makeFolder("parts");
            }
            folder.write("job.sh", JobScript.of(plan));
            engine.value().write(plan, folder);
            folder.keep();
            tell(plan);
            return ExitCode.DONE;
        }
    }

    private static void requireFrom1(String option, Integer value) throws CommandException {
        if (value != null && value < 1) {
            throw CommandException.usage(option + " must be 1 or more, and is " + value);
        }
    }

    private int bands() {
        return bands.value() == null ? 1 : bands.value();
    }

    /** {@return the frames to render; null for a scene without frames} */
    private FrameRanges asked(Scene read) throws CommandException {
        int count = read.film().frames();
        FrameRanges wanted = frames.value();
        if (wanted != null && wanted.last() >= count) {
            throw CommandException.usage(FRAMES + " must be from 0 to " + (count - 1) + ", and there is " + wanted.last());
        }
        return read.settings.frames == null ? null : wanted == null ? FrameRanges.all(count) : wanted;
    }

    /** Copies the scene with the files that it names. {@return the copy, and how long it took to read it} */
    private Copy copy(JobFolder folder, SourceText text) throws CommandException {
        Path source = Path.of(scene);
        String name = JobScript.SCENE_FOLDER + source.getFileName();
        folder.copy(source, name);
        for (SourceText.MeshFile mesh : text.meshes()) {
            folder.copy(source.resolveSibling("").resolve(mesh.name()), JobScript.SCENE_FOLDER + mesh.name());
        }
        long begin = System.nanoTime();
        try {
            SceneFile copied = SceneFile.read(folder.path(name));
            if (copied.text().sha256().equals(text.sha256()) && copied.text().meshes().equals(text.meshes())) {
                return new Copy(copied, Progress.seconds(begin, System.nanoTime()));
            }
        } catch (IOException e) {
            // as below: the scene was read before
        }
        throw new CommandException(ExitCode.BUSY, "simpleray: " + scene + ": was changed while it was copied: try again");
    }

    private record Copy(SceneFile file, double readSeconds) {
    }

    private JobPlan plan(RenderRequest request, Resolution size, FrameRanges asked, Copy copy) {
        JobEstimate estimate = JobEstimate.of(request, copy.file.scene(), asked, copy.readSeconds);
        int pictures = asked == null ? 1 : asked.count();
        int each = chunk.value() == null ? JobPlan.chunk(pictures, bands()) : Math.min(chunk.value(), pictures);
        List<String> words = new ArrayList<>(CommandWords.options(request));
        return new JobPlan(new File(scene).getName(), size, asked, bands(), each,
            pictures == 1 || film.value().equals(NO_FILM) ? null : film.value(), words, estimate);
    }

    private void tell(JobPlan plan) {
        String tasks = plan.tasks() == 1 ? "1 task" : plan.tasks() + " tasks";
        main.err().println(output.value() + ": " + plan.what() + ", " + tasks + ": README.txt there says how to run them");
        if (engine.value() == JobEngine.SLURM && plan.tasks() > JobPlan.MAX_ARRAY) {
            main.err().println("simpleray: Slurm takes an array of " + plan.tasks() + " tasks only if its MaxArraySize is above "
                + (plan.tasks() - 1) + ", and it is usually " + (JobPlan.MAX_ARRAY + 1) + ": a larger --chunk makes fewer tasks");
        }
    }
}
