package simpleray.cli;

import java.io.File;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.Callable;
import java.util.function.Supplier;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.ParentCommand;
import simpleray.image.Picture;
import simpleray.image.Sheet;
import simpleray.image.png.PngWriter;
import simpleray.io.AtomicFile;
import simpleray.render.Progress;
import simpleray.render.Provenance;
import simpleray.render.RenderRequest;
import simpleray.render.Stage;
import simpleray.scene.Object;
import simpleray.scene.Scene;
import simpleray.scene.SceneFile;
import simpleray.text.NumberParser;

/** Makes the thesis's figures of a scene, each a sheet of labelled pictures. */
@Command(mixinStandardHelpOptions = true, sortOptions = false,
    description = "Makes the thesis's figures of a scene, each a sheet of labelled pictures: DIR/NAME-stages.png (figures 12 to 14), "
        + "DIR/NAME-terms.png (figure 10), with --rays DIR/NAME-rays.png (figures 1, 2, 6 and 9) and, with --sweep, DIR/NAME-shininess.png "
        + "(figure 8).")
final class FiguresCommand implements Callable<Integer> {
    @ParentCommand
    private Main main;

    @Parameters(paramLabel = "SCENE", description = SceneArgument.DESCRIPTION)
    private String scene;

    @Option(names = {"-d", "--directory"}, paramLabel = "DIR", required = true,
        description = "The folder of the sheets; made if it is not there. NAME is the scene file's name without its ending, or stdin.")
    private String folder;

    @Option(names = "--sweep", paramLabel = "shininess=N,N,...", converter = Sweep.Converter.class,
        description = "Also a strip of the lighting stage in which all materials have this shininess, and this one, and so on.")
    private Sweep sweep;

    @Option(names = "--rays", description = "Also the rays of a pixel: the basic method, all its rays with their vectors, and the vectors of "
        + "the diffuse and the specular term.")
    private boolean rays;

    @Mixin
    private PictureOptions picture;

    @Mixin
    private OutsideOption outside;

    @Mixin
    private FrameOption frame;

    @Mixin
    private WorkOptions work;

    private RenderRequest request;
    private SceneFile file;
    private Scene read;
    private ProgressPrinter printer;

    /** A sheet to be made: how its file's name ends, its labels, how many of its pictures are rendered, and what makes them all. */
    private record Figure(String name, List<String> labels, int rendered, Supplier<List<Picture>> pictures) {
    }

    @Override
    public Integer call() throws CommandException {
        request = picture.request(Stage.LIGHTING, work.threads()).with(work.accel());
        List<Figure> figures = figures();
        for (Figure figure : figures) {
            OutputName.refuseScene(output(figure), scene);
        }
        file = frame.of(SceneArgument.read(scene, main.in(), work.warnings(main.err()), outside.reach()), scene);
        read = file.scene();
        for (Figure figure : figures) {
            OutputName.refuseNamed(output(figure), scene, file);
        }
        Picture first = request.renderer(read).picture();     // its size is that of all
        List<Sheet> sheets = layouts(figures, first);
        int rows = first.height() * figures.stream().mapToInt(Figure::rendered).sum();
        printer = work.printer(new Progress(rows, System.nanoTime()), main);
        TextOutput.makeFolder(folder);
        List<AtomicFile> files = new ArrayList<>();
        try {
            for (Figure figure : figures) {
                files.add(TextOutput.begin(output(figure), work.warnings(main.err())));
            }
            for (int i = 0; i < files.size(); i++) {
                make(figures.get(i), sheets.get(i), files.get(i));
            }
        } finally {
            for (AtomicFile begun : files) {
                close(begun);
            }
        }
        return ExitCode.DONE;
    }

    private List<Figure> figures() {
        List<Figure> figures = new ArrayList<>();
        figures.add(new Figure("stages", List.of("original", "with lighting", "with shadows and reflections"), 3,
            () -> render(Stage.ORIGINAL, Stage.LIGHTING, Stage.FINAL)));
        figures.add(new Figure("terms", List.of("ambient", "diffuse", "specular", "their sum"), 3, this::terms));
        if (rays) {
            figures.add(new Figure("rays", List.of("the basic method", "its rays and vectors", "the diffuse term: N, L",
                "the specular term: N, L, H, ray"), 0, () -> RayFigures.of(request.applyTo(read), request)));
        }
        if (sweep != null) {                                  // the last one: it changes the scene
            List<String> labels = sweep.values().stream().map(value -> "shininess " + value).toList();
            figures.add(new Figure("shininess", labels, labels.size(), this::swept));
        }
        return figures;
    }

    private List<Picture> render(Stage... stages) {
        return Arrays.stream(stages).map(stage -> request.with(stage).renderer(read).render(printer)).toList();
    }

    private List<Picture> terms() {
        List<Picture> pictures = new ArrayList<>(render(Stage.AMBIENT, Stage.DIFFUSE, Stage.SPECULAR));
        pictures.add(Picture.sum(pictures));
        return pictures;
    }

    private List<Picture> swept() {
        List<Picture> pictures = new ArrayList<>();
        for (String value : sweep.values()) {
            for (int i = 0; i < read.getNumberObjects(); i++) {
                Object object = read.getObject(i);
                for (int part = 0; part < object.parts(); part++) {   // a mesh may have many materials
                    object.material(part).shininess = NumberParser.parseDouble(value);
                }
            }
            pictures.addAll(render(Stage.LIGHTING));
        }
        return pictures;
    }

    /** Lays out the sheets, and makes sure that there is memory for each. */
    private List<Sheet> layouts(List<Figure> figures, Picture first) throws CommandException {
        List<Sheet> sheets = new ArrayList<>();
        try {
            for (Figure figure : figures) {
                sheets.add(new Sheet(first.width(), first.height(), figure.labels));
            }
        } catch (IllegalArgumentException e) {
            throw CommandException.usage(e.getMessage());
        }
        for (int i = 0; i < sheets.size(); i++) {
            Sheet sheet = sheets.get(i);
            HeapCheck.require("a sheet of " + sheet.width() + 'x' + sheet.height(), Picture.bytesNeeded(sheet.width(), sheet.height(), Picture.RGB)
                + figures.get(i).labels.size() * Picture.bytesNeeded(first.width(), first.height(), first.channels()));
        }
        return sheets;
    }

    private String output(Figure figure) {
        String name = scene.equals(SceneArgument.STREAM) ? "stdin" : new File(scene).getName();
        int ending = name.lastIndexOf('.');
        return Path.of(folder).resolve((ending > 0 ? name.substring(0, ending) : name) + '-' + figure.name + ".png").toString();
    }

    private void make(Figure figure, Sheet sheet, AtomicFile target) throws CommandException {
        long start = System.nanoTime();
        Picture filled = sheet.with(figure.pictures.get());
        printer.end();
        try {
            filled.tell(Provenance.ofSheet(request, file, figure.name + ": " + String.join(", ", figure.labels)));
            PngWriter.write(filled, target.out());
            target.commit();
        } catch (IOException e) {
            throw new CommandException(ExitCode.WRITE_ERROR, "simpleray: " + output(figure) + ": cannot be written: " + e.getMessage());
        }
        work.report(main, output(figure), filled, Progress.seconds(start, System.nanoTime()));
    }

    private static void close(AtomicFile file) {
        try {
            file.close();
        } catch (IOException e) {
            return;                                           // it was not written whole, for a reason that is being reported
        }
    }
}
