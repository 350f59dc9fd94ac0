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
    private static final int MOST_THREADS = 1024;

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

    @Option(names = "--threads", paramLabel = "N",
        description = "How many threads work, 1 to " + MOST_THREADS + " (default: one for each processor). The picture is the same.")
    private Integer threads;

    @Option(names = "--progress", paramLabel = "HOW", defaultValue = "auto",
        description = "${COMPLETION-CANDIDATES} (default: ${DEFAULT-VALUE}: a bar if standard error is a terminal, else "
            + "none); without a terminal, bar is plain.")
    private ProgressPrinter.Style progress;

    @Option(names = {"-q", "--quiet"}, description = "Say nothing but errors.")
    private boolean quiet;

    private final long start = System.nanoTime();

    @Override
    public Integer call() throws Failure {
        if (threads != null && (threads < 1 || threads > MOST_THREADS)) {
            throw new ParameterException(spec.commandLine(), "--threads must be 1 to " + MOST_THREADS + ", and is " + threads);
        }
        RenderRequest request = picture.request(threads == null ? Runtime.getRuntime().availableProcessors() : threads);
        refuseOtherFormats();
        Renderer renderer = request.renderer(SceneArgument.read(scene, main.in(), quiet ? null : main.err()).scene());
        Memory.require(renderer.picture().width(), renderer.picture().height(), 0);
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
        ProgressPrinter printer = new ProgressPrinter(counter, main.err(), quiet ? ProgressPrinter.Style.NONE : progress);
        Picture rendered = renderer.render(printer);
        printer.end();
        return rendered;
    }

    private void report(String name, Picture rendered) {
        if (!quiet) {
            main.err().println(name + ": " + rendered.width() + 'x' + rendered.height() + ", "
                + Progress.time(Progress.seconds(start, System.nanoTime())));
        }
    }

    private void refuseOtherFormats() {
        String extension = output.substring(output.lastIndexOf('.') + 1).toLowerCase(Locale.ROOT);
        if (OTHER_FORMATS.contains(extension) && output.contains(".")) {
            throw new ParameterException(spec.commandLine(), "pictures are written as PNG only: call the output " + output + ".png?");
        }
    }
}
