package simpleray.cli;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.ParentCommand;
import simpleray.image.Picture;
import simpleray.image.png.PictureFormatException;
import simpleray.image.png.PngChunks;
import simpleray.image.png.PngReader;
import simpleray.image.png.RowsCheck.Pixel;
import simpleray.image.png.RowsCheck;
import simpleray.io.InputFile;
import simpleray.render.Band;
import simpleray.render.PicturePart;
import simpleray.render.Progress;
import simpleray.render.Provenance;
import simpleray.render.Region;
import simpleray.render.RenderRequest;
import simpleray.render.Renderer;
import simpleray.scene.PictureScene;
import simpleray.scene.SceneFile;

/** Renders a picture's scene again and compares. */
@Command(mixinStandardHelpOptions = true, sortOptions = false,
    description = "Renders the scene that a picture carries once more, with the options that it carries, and compares pixel for pixel. "
        + "The exit code is 0 if all are the same, 1 if one differs, and 65 if the picture does not carry what is needed.")
final class VerifyCommand implements Callable<Integer> {
    @ParentCommand
    private Main main;

    @Parameters(paramLabel = "PICTURE.png", description = "A picture that SimpleRay has rendered; - is standard input.")
    private String picture;

    @Option(names = "--scene", paramLabel = "FILE",
        description = "The scene file that the picture was made of, if it is too long for the picture to carry, or its meshes lie "
            + "elsewhere than the picture.")
    private String scene;

    @Mixin
    private FrameOption frame;

    @Mixin
    private WorkOptions work;

    @Mixin
    private OutsideOption outside;

    private byte[] piped;                                     // the picture, if it can be read only once; else null

    @Override
    public Integer call() throws CommandException {
        if (picture.equals(SceneArgument.STREAM) && picture.equals(scene)) {
            throw CommandException.usage("picture and scene cannot both be standard input");
        }
        try {
            PictureScene told = told();
            RenderRequest request = Provenance.request(told, work.accel(), work.threads());
            String name = scene != null ? scene : piped == null ? picture : SceneArgument.STREAM;
            InputStream in = scene == null && piped != null ? new ByteArrayInputStream(piped) : main.in();
            SceneFile file = frame.of(SceneArgument.read(name, in, null, outside.reach()), name);
            requireSame(told, file);
            Renderer renderer = renderer(request, file);
            if (request.band() != null) {
                requireWholePart(request);
            }
            return compare(renderer, told, request);
        } catch (PictureFormatException e) {
            throw new CommandException(ExitCode.BAD_SCENE, "simpleray: " + e.getMessage());
        } catch (IOException e) {
            throw new CommandException(ExitCode.NO_SCENE, "simpleray: " + picture + ": cannot be read: " + e.getMessage());
        }
    }

    private Renderer renderer(RenderRequest request, SceneFile file) throws PictureFormatException {
        try {
            return request.renderer(file.scene());
        } catch (IllegalArgumentException e) {
            throw new PictureFormatException(picture, "was made with options that do not fit: " + e.getMessage());
        }
    }

    private void requireWholePart(RenderRequest request) throws IOException {
        boolean file = piped == null;
        try (InputStream in = file ? Files.newInputStream(Path.of(picture)) : new ByteArrayInputStream(piped)) {
            PicturePart.requireWhole(request, in, file ? Files.size(Path.of(picture)) : piped.length, SceneArgument.told(picture));
        }
    }

    private PictureScene told() throws IOException, CommandException {
        if (picture.equals(SceneArgument.STREAM)) {
            piped = PngChunks.readFile(main.in());
            return PictureScene.read(new ByteArrayInputStream(piped), SceneArgument.told(picture));
        }
        Path path = Path.of(picture);
        String refusal = InputFile.refusal(path);
        if (refusal != null) {
            throw new CommandException(ExitCode.NO_SCENE, "simpleray: " + picture + ": " + refusal);
        }
        if (Files.isRegularFile(path)) {
            return PictureScene.read(path);
        }
        try (InputStream in = Files.newInputStream(path)) {
            piped = PngChunks.readFile(in);
        }
        return PictureScene.read(new ByteArrayInputStream(piped), picture);
    }

    /** Makes sure that scene and meshes are those of the picture, so that a difference is one of rendering. */
    private void requireSame(PictureScene told, SceneFile file) throws CommandException {
        if (!file.text().sha256().equals(told.text().sha256())) {
            throw new CommandException(ExitCode.BAD_SCENE, "simpleray: " + scene + ": is not the scene that " + picture
                + " was made of: its SHA-256 is " + file.text().sha256() + ", and was " + told.text().sha256());
        }
        List<String> changed = told.changed(file.text().meshes());
        if (!changed.isEmpty()) {
            throw new CommandException(ExitCode.BAD_SCENE, "simpleray: " + picture + ": was made of other meshes: " + String.join(", ", changed));
        }
    }

    private int compare(Renderer renderer, PictureScene told, RenderRequest request) throws IOException, CommandException {
        Picture rendered = renderer.picture();
        HeapCheck.require("a picture of " + rendered.width() + 'x' + rendered.height(),
            renderer.bytesNeeded() + (long) rendered.channels() * rendered.width() * renderer.rowsAhead()
                + PngReader.bytesNeeded(rendered.width(), rendered.height()));
        try (PngReader rows = piped == null ? PngReader.open(picture)
                : PngReader.open(new ByteArrayInputStream(piped), SceneArgument.told(picture))) {
            if (rows.width() != rendered.width() || rows.height() != rendered.height()) {
                throw new PictureFormatException(picture, "is " + rows.width() + 'x' + rows.height() + ", and its options say "
                    + rendered.width() + 'x' + rendered.height());
            }
            if (rows.channels() != rendered.channels()) {
                throw new PictureFormatException(picture, "has " + (rendered.hasAlpha() ? "no alpha, and its scene has no background"
                    : "alpha, and its scene has a background"));
            }
            RowsCheck check = new RowsCheck(rendered, rows);
            render(renderer, check);
            return report(check, rendered, told, request);
        }
    }

    private void render(Renderer renderer, RowsCheck check) throws IOException {
        Picture rendered = renderer.picture();
        ProgressPrinter printer = work.printer(new Progress(rendered.height(), System.nanoTime()), main);
        try {
            renderer.render(y -> {
                try {
                    check.row(y);
                } catch (IOException e) {
                    throw new UncheckedIOException(e);
                }
                rendered.release(y);
                printer.rowFinished(y);
            });
        } catch (UncheckedIOException e) {
            throw e.getCause();
        } finally {
            printer.end();
        }
    }

    private int report(RowsCheck check, Picture rendered, PictureScene told, RenderRequest request) throws CommandException {
        String named = picture;
        int above = 0;
        Band band = request.band();
        if (band != null) {
            Region whole = request.whole(request.settings());
            named += ": part " + band + ", " + band.rows(whole);
            above = band.of(whole).y() - whole.y();
        }
        Pixel first = check.first();
        long all = (long) rendered.width() * rendered.height();
        String other = told.software().equals(Provenance.SOFTWARE) ? "" : " (made by " + told.software() + ", rendered again by "
            + Provenance.SOFTWARE + ')';
        if (first == null) {
            TextOutput.say(main, named + ": good: all " + all + " pixels are the same" + other + '\n');
            return ExitCode.DONE;
        }
        TextOutput.say(main, named + ": different: " + check.different() + " of " + all + " pixels, the first in row " + (above + first.y() + 1)
            + ", column " + (first.x() + 1) + ": " + first.inFile() + " in the file, " + first.here() + " rendered" + other + '\n');
        return ExitCode.DIFFERENT;
    }
}
