package simpleray.cli;

import java.util.Locale;
import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.ParentCommand;
import simpleray.rays.StoryText;
import simpleray.render.Accel;
import simpleray.render.Explainer;
import simpleray.render.PixelStory;
import simpleray.render.RenderRequest;
import simpleray.scene.Scene;
import simpleray.scene.SceneFile;

/** Tells why a pixel has its colour. */
@Command(mixinStandardHelpOptions = true, sortOptions = false,
    description = "Tells why a pixel has its colour: each ray's hit, the terms there, what each light adds and what is in its way, and the "
        + "mirror and refracted rays' own stories. The terms add up to the pixel's colour exactly.")
final class ExplainCommand implements Callable<Integer> {
    /** How a story is written. */
    enum Format {
        /** Indented lines, numbers of three digits. */
        TEXT,
        /** One JSON object, numbers to the last bit. */
        JSON;

        @Override
        public String toString() {
            return name().toLowerCase(Locale.ROOT);
        }
    }

    /** A pixel: 0,0 is the left one at the top. */
    record Pixel(int x, int y) {
    }

    @ParentCommand
    private Main main;

    @Parameters(paramLabel = "SCENE", description = SceneArgument.DESCRIPTION)
    private String scene;

    @Option(names = "--pixel", paramLabel = "X,Y", required = true,
        description = "The column from the left and the row from the top, both from 0.")
    private Pixel pixel;

    @Option(names = "--format", paramLabel = "FORMAT", defaultValue = "text",
        description = "${COMPLETION-CANDIDATES} (default: ${DEFAULT-VALUE}): indented lines with numbers of three digits, or one object "
            + "with numbers to the last bit.")
    private Format format = Format.TEXT;

    @Option(names = "--points", description = "Tell what each point of an area light adds, too, and not only their sum.")
    private boolean points;

    @Mixin
    private PictureOptions picture;

    @Mixin
    private StageOption stage;

    @Mixin
    private FrameOption frame;

    @Option(names = "--accel", paramLabel = "HOW", defaultValue = "auto",
        description = "How the nearest object is found: ${COMPLETION-CANDIDATES} (default: ${DEFAULT-VALUE}). The story is the same.")
    private Accel accel = Accel.AUTO;

    @Option(names = {"-q", "--quiet"}, description = "Say nothing but the story and errors.")
    private boolean quiet;

    @Mixin
    private DrawOptions drawing;

    @Mixin
    private OutsideOption outside;

    @Override
    public Integer call() throws CommandException {
        boolean drawn = drawing.isAsked();
        if (drawn) {
            drawing.checkName(scene);
        }
        RenderRequest request = picture.request(stage.stage(), Runtime.getRuntime().availableProcessors()).with(accel);
        SceneFile read = frame.of(SceneArgument.read(scene, main.in(), quiet ? null : main.err(), outside.reach()), scene);
        Explainer explainer = request.renderer(read.scene()).explainer();
        if (pixel.x >= explainer.width() || pixel.y >= explainer.height()) {
            throw CommandException.usage("the pixel " + pixel.x + ',' + pixel.y + " is outside the picture of " + explainer.width() + 'x'
                + explainer.height() + ", whose last one is " + (explainer.width() - 1) + ',' + (explainer.height() - 1));
        }
        PixelStory story = explainer.story(pixel.x, pixel.y, points);
        if (drawn) {
            drawing.draw(main, quiet, points ? story : explainer.story(pixel.x, pixel.y, true), request, scene, read);
        }
        Scene asked = request.applyTo(read.scene());
        TextOutput.say(main, format == Format.JSON ? StoryJson.of(story) : StoryText.of(story, asked, asked.settings.newCamera()));
        return ExitCode.DONE;
    }
}
