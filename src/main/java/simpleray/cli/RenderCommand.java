package simpleray.cli;

import java.io.BufferedOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.util.Locale;
import java.util.Set;
import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.ParentCommand;
import picocli.CommandLine.Spec;
import simpleray.image.Picture;
import simpleray.image.PngWriter;
import simpleray.render.Progress;
import simpleray.render.RenderRequest;
import simpleray.render.Renderer;
import simpleray.text.WholeFile;

/** Renders a scene into a PNG file, without a window. */
@Command(name = "render", mixinStandardHelpOptions = true, sortOptions = false,
    description = "Renders a scene into a PNG file, without a window.")
final class RenderCommand implements Callable<Integer> {
    private static final Set<String> OTHER_FORMATS = Set.of("jpg", "jpeg", "gif", "bmp", "tif", "tiff", "webp", "ppm", "svg", "pdf");

    @ParentCommand
    private Main main;

    @Spec
    private CommandSpec spec;

    @Parameters(paramLabel = "SCENE", description = SceneArgument.DESCRIPTION)
    private String scene;

    @Option(names = {"-o", "--output"}, paramLabel = "OUT.png", required = true,
        description = "The PNG file to write; - is standard output.")
    private String output;

    @Mixin
    private PictureOptions picture;

    @Mixin
    private StageOption stage;

    @Mixin
    private WorkOptions work;

    private final long start = System.nanoTime();

    @Override
    public Integer call() throws Failure {
        RenderRequest request = picture.request(stage.stage(), work.threads());
        refuseOtherFormats();
        Renderer renderer = request.renderer(SceneArgument.read(scene, main.in(), work.warnings(main.err())).scene());
        Picture asked = renderer.picture();
        Memory.require("a picture of " + asked.width() + 'x' + asked.height(), Picture.bytesNeeded(asked.width(), asked.height()));
        if (output.equals(SceneArgument.STREAM)) {
            toStream(renderer);
        } else {
            toFile(renderer);
        }
        return ExitCode.DONE;
    }

    private void toStream(Renderer renderer) throws Failure {
        Picture rendered = render(renderer);
        try {
            OutputStream out = new BufferedOutputStream(main.out());
            PngWriter.write(rendered, out);
            report("<stdout>", rendered);
        } catch (IOException e) {
            throw new Failure(ExitCode.WRITE_ERROR, "simpleray: the picture cannot be written to standard output: " + e.getMessage());
        }
    }

    private void toFile(Renderer renderer) throws Failure {
        if (TextOutput.isSame(scene, output)) {
            throw new ParameterException(spec.commandLine(), "the output " + output + " is the scene itself");
        }
        try (WholeFile file = TextOutput.begin(output)) {
            Picture rendered = render(renderer);
            PngWriter.write(rendered, file.out());
            file.commit();
            report(output, rendered);
        } catch (IOException e) {
            throw new Failure(ExitCode.WRITE_ERROR, "simpleray: " + output + ": cannot be written: " + e.getMessage());
        }
    }

    private Picture render(Renderer renderer) {
        Progress counter = new Progress(renderer.picture().height(), start);
        ProgressPrinter printer = work.printer(counter, main.err());
        Picture rendered = renderer.render(printer);
        printer.end();
        return rendered;
    }

    private void report(String name, Picture rendered) {
        work.report(main.err(), name, rendered, Progress.seconds(start, System.nanoTime()));
    }

    private void refuseOtherFormats() {
        String extension = output.substring(output.lastIndexOf('.') + 1).toLowerCase(Locale.ROOT);
        if (OTHER_FORMATS.contains(extension) && output.contains(".")) {
            throw new ParameterException(spec.commandLine(), "pictures are written as PNG only: call the output " + output + ".png?");
        }
    }
}
