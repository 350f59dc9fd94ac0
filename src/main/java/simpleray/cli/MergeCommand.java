package simpleray.cli;

import java.io.BufferedOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.concurrent.Callable;
import java.util.stream.IntStream;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.ParentCommand;
import simpleray.image.Picture;
import simpleray.image.png.PictureFormatException;
import simpleray.image.png.PngRowReader;
import simpleray.image.png.PngWriter;
import simpleray.io.AtomicFile;
import simpleray.io.OutputTarget;
import simpleray.render.Band;
import simpleray.render.PictureIdentity;
import simpleray.render.PicturePart;
import simpleray.render.Progress;
import simpleray.render.Region;
import simpleray.text.SceneFormatException;

/** Makes a picture of its parts. */
@Command(mixinStandardHelpOptions = true, sortOptions = false,
    description = "Makes a picture of its parts, which render --band has made: the same file, byte for byte, that render makes without --band. "
        + "All parts are looked at before anything is written; if one is missing, damaged, there twice, or of another scene, other options or "
        + "another version, the exit code is 65.")
final class MergeCommand implements Callable<Integer> {
    @ParentCommand
    private Main main;

    @Parameters(arity = "1..*", paramLabel = "PART.png", description = "The parts, in any order.")
    private List<String> names;

    @Option(names = {"-o", "--output"}, required = true, paramLabel = "OUT.png",
        description = "The PNG file to write; - is standard output.")
    private String output;

    @Option(names = {"-q", "--quiet"}, description = "Say nothing but errors.")
    private boolean quiet;

    private final long start = System.nanoTime();
    private final List<Part> parts = new ArrayList<>();
    private final List<String> faults = new ArrayList<>();
    private int exitCode = ExitCode.NO_SCENE;
    private PicturePart first;                                // of those that can be used; null for none
    private String firstName;

    /** A file, and its rows of the whole picture. */
    private record Part(String name, Band band, Region rows) {
    }

    @Override
    public Integer call() throws CommandException {
        OutputName.refuseOtherFormats(output);
        OutputName.refuseSceneNames(output);
        for (String name : names) {
            OutputName.refuse(output, name, "one of the parts");
        }
        names.forEach(this::look);
        if (first != null) {
            requireAllRowsOnce();
        }
        if (!faults.isEmpty()) {
            throw new CommandException(exitCode, String.join("\n", faults));
        }
        Picture picture = new Picture(first.whole().width(), first.whole().height(), first.channels());
        picture.tell(first.texts());
        HeapCheck.require("a picture of " + picture.width() + 'x' + picture.height(),
            PngWriter.bytesNeeded(picture, 1) + 2 * Picture.bytesNeeded(picture.width(), 1, picture.channels()));
        if (output.equals(SceneArgument.STREAM)) {
            write(picture, new BufferedOutputStream(main.out()));
        } else {
            toFile(picture);
        }
        if (!quiet) {
            main.err().println((output.equals(SceneArgument.STREAM) ? "<stdout>" : output) + ": " + picture.width() + 'x' + picture.height()
                + ", " + Progress.time(Progress.seconds(start, System.nanoTime())));
        }
        return ExitCode.DONE;
    }

    private void toFile(Picture picture) throws CommandException {
        try (AtomicFile file = TextOutput.begin(output, quiet ? null : main.err())) {
            write(picture, file.out());
            file.commit();
        } catch (IOException e) {
            throw notWritten(e);
        }
    }

    /** Notes a file that is a part, or what is wrong with it. */
    private void look(String name) {
        Path path = Path.of(name);
        try {
            if (!Files.isRegularFile(path)) {
                faults.add("simpleray: " + name + ": " + (Files.isDirectory(path) ? "is a folder" : Files.exists(path) ? "is no file" : "no such file"));
                return;
            }
            PicturePart part = PicturePart.read(path);
            if (first == null) {
                first = part;
                firstName = name;
            }
            String difference = PictureIdentity.difference(part.identity(), first.identity(), "there");
            if (difference.isEmpty()) {
                parts.add(new Part(name, part.band(), part.band().of(part.whole())));
            } else {
                bad("simpleray: " + name + ": is of another picture than " + firstName + ": " + difference);
            }
        } catch (PictureFormatException e) {
            bad("simpleray: " + e.getMessage());
        } catch (SceneFormatException e) {
            bad(e.getMessage());
        } catch (IOException e) {
            faults.add("simpleray: " + name + ": cannot be read: " + OutputTarget.reason(e));
        }
    }

    private void bad(String fault) {
        faults.add(fault);
        exitCode = ExitCode.BAD_SCENE;
    }

    private void requireAllRowsOnce() {
        parts.sort(Comparator.comparingInt(part -> part.rows().y()));
        Region whole = first.whole();
        int next = whole.y();
        Part above = null;
        for (Part part : parts) {
            if (part.rows().y() > next) {
                missing(next, part.rows().y());
            } else if (part.rows().y() < next) {
                bad("simpleray: " + part.name() + (part.name().equals(above.name()) ? ": is there twice"
                    : ": has " + part.band().rows(whole) + ", and " + above.name() + " has " + above.band().rows(whole)));
            }
            if (part.rows().bottom() > next) {
                next = part.rows().bottom();
                above = part;
            }
        }
        if (next < whole.bottom()) {
            missing(next, whole.bottom());
        }
    }

    /** Tells of rows that no part has, and of the bands that they are if the parts are all of one number of bands. */
    private void missing(int from, int end) {
        Region whole = first.whole();
        int count = first.band().count();
        String bands = "";
        if (parts.stream().allMatch(part -> part.band().count() == count)) {
            List<Band> all = IntStream.rangeClosed(1, count).mapToObj(i -> new Band(i, count))
                .filter(band -> band.of(whole).y() >= from && band.of(whole).bottom() <= end).toList();
            bands = " (--band " + all.get(0) + (all.size() > 1 ? " to " + all.get(all.size() - 1) : "") + ')';
        }
        bad("simpleray: " + output + ": cannot be made: " + Band.rows(from - whole.y() + 1, end - whole.y(), whole.height())
            + (end - from == 1 ? " is" : " are") + " missing" + bands);
    }

    private void write(Picture picture, OutputStream out) throws CommandException {
        PngWriter png = new PngWriter(picture, out);
        int y = 0;
        for (Part part : parts) {
            try (PngRowReader rows = new PngRowReader(Path.of(part.name()))) {
                if (rows.width() != part.rows().width() || rows.height() != part.rows().height()) {
                    throw new PictureFormatException(part.name(), "is " + rows.width() + 'x' + rows.height() + ", and its options say "
                        + part.rows().width() + 'x' + part.rows().height());
                }
                for (int i = 0; i < rows.height(); i++) {
                    picture.setRow(y, Picture.light(rows.next()));
                    writeRow(png, y);
                    picture.release(y++);
                }
                rows.end();
            } catch (PictureFormatException e) {
                throw new CommandException(ExitCode.BAD_SCENE, "simpleray: " + e.getMessage());
            } catch (IOException e) {
                throw new CommandException(ExitCode.NO_SCENE, "simpleray: " + part.name() + ": cannot be read: " + OutputTarget.reason(e));
            }
        }
        try {
            png.end();
        } catch (IOException e) {
            throw notWritten(e);
        }
    }

    private void writeRow(PngWriter png, int y) throws CommandException {
        try {
            png.row(y);
        } catch (IOException e) {
            throw notWritten(e);
        }
    }

    private CommandException notWritten(IOException e) {
        return new CommandException(ExitCode.WRITE_ERROR, "simpleray: " + (output.equals(SceneArgument.STREAM)
            ? "the picture cannot be written to standard output: " : output + ": cannot be written: ") + e.getMessage());
    }
}
