package simpleray.cli;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Locale;
import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.ParentCommand;
import simpleray.image.PictureDiff;
import simpleray.image.png.HeatMap;
import simpleray.image.png.PictureFormatException;
import simpleray.image.png.PngReader;
import simpleray.io.AtomicFile;
import simpleray.io.InputFile;

/** Measures how two pictures differ. */
@Command(mixinStandardHelpOptions = true, sortOptions = false,
    description = "Measures how two PNG pictures differ, in levels from 0 to 255: the largest difference, RMSE, PSNR, SSIM (Wang et al. "
        + "2004, of the luma, Gaussian windows of 11 x 11), and how many pixels differ by more than 1 level. Transparency is not "
        + "looked at. The exit code is 0 if the pictures are the same, 1 if they differ, 2 if they cannot be compared.")
final class CompareCommand implements Callable<Integer> {
    @ParentCommand
    private Main main;

    @Parameters(index = "0", paramLabel = "A", description = "A PNG file; - is standard input.")
    private String one;

    @Parameters(index = "1", paramLabel = "B", description = "Another.")
    private String other;

    @Option(names = "--heatmap", paramLabel = "OUT.png",
        description = "Also write a picture of the differences: black where there is none, from blue for 1 level over red to yellow.")
    private String heatmap;

    @Option(names = "--format", paramLabel = "FORMAT", defaultValue = "text",
        description = "How the figures are printed: ${COMPLETION-CANDIDATES} (default: ${DEFAULT-VALUE}).")
    private Stats.Format format;

    @Override
    public Integer call() throws CommandException {
        if (heatmap != null) {
            OutputName.refuse(heatmap, one, "one of the pictures");
            OutputName.refuse(heatmap, other, "one of the pictures");
            OutputName.refuseSceneNames(heatmap);
        }
        try (PngReader a = open(one); PngReader b = open(other)) {
            if (a.width() != b.width() || a.height() != b.height()) {
                return trouble(one + " is " + a.width() + 'x' + a.height() + ", and " + other + " is " + b.width() + 'x' + b.height());
            }
            PictureDiff diff = heatmap == null ? compare(a, b, null) : compareAndDraw(a, b);
            TextOutput.say(main, format == Stats.Format.JSON ? json(diff, a) : text(diff, a));
            return diff.maximum() == 0 ? ExitCode.DONE : ExitCode.DIFFERENT;
        } catch (PictureFormatException e) {
            return trouble(e.getMessage());
        } catch (IOException e) {
            return trouble("the pictures cannot be read: " + e.getMessage());
        }
    }

    private int trouble(String what) {
        main.err().println("simpleray: " + what);
        return ExitCode.USAGE;
    }

    private PngReader open(String name) throws IOException {
        if (name.equals(SceneArgument.STREAM)) {
            return PngReader.open(main.in(), "<stdin>");
        }
        String refusal = InputFile.refusal(Path.of(name));
        if (refusal != null) {
            throw new PictureFormatException(name, refusal);
        }
        return PngReader.open(name);
    }

    private PictureDiff compareAndDraw(PngReader a, PngReader b) throws IOException, CommandException {
        try (AtomicFile file = TextOutput.begin(heatmap, main.err())) {
            HeatMap map = new HeatMap(a.width(), a.height(), file.out());
            PictureDiff diff = compare(a, b, map);
            try {
                map.end();
                file.commit();
            } catch (IOException e) {
                throw notWritten(e);
            }
            return diff;
        }
    }

    private PictureDiff compare(PngReader a, PngReader b, HeatMap map) throws IOException, CommandException {
        PictureDiff diff = new PictureDiff(a.width(), a.height());
        for (int y = 0; y < a.height(); y++) {
            int[] differences = diff.row(a.next(), b.next());
            if (map != null) {
                try {
                    map.row(y, differences);
                } catch (IOException e) {
                    throw notWritten(e);
                }
            }
        }
        return diff;
    }

    private CommandException notWritten(IOException e) {
        return new CommandException(ExitCode.WRITE_ERROR, "simpleray: " + heatmap + ": cannot be written: " + e.getMessage());
    }

    private String text(PictureDiff c, PngReader size) {
        return String.format(Locale.ROOT, "%s and %s are %s: %dx%d%n"
            + "largest difference     %d levels%n"
            + "RMSE                   %.6f levels%n"
            + "PSNR                   %s%n"
            + "SSIM                   %.6f%n"
            + "pixels beyond 1 level  %d of %d%n", one, other, c.maximum() == 0 ? "the same" : "different", size.width(), size.height(),
            c.maximum(), c.rmse(), c.maximum() == 0 ? "infinite" : String.format(Locale.ROOT, "%.4f dB", c.psnr()), c.ssim(),
            c.beyondOneLevel(), c.pixels()).replace(System.lineSeparator(), "\n");
    }

    private static String json(PictureDiff c, PngReader size) {
        return "{\"same\":" + (c.maximum() == 0) + ",\"width\":" + size.width() + ",\"height\":" + size.height() + ",\"maximum\":"
            + c.maximum() + ",\"rmse\":" + c.rmse() + ",\"psnr\":" + (c.maximum() == 0 ? "null" : String.valueOf(c.psnr())) + ",\"ssim\":"
            + c.ssim() + ",\"beyondOneLevel\":" + c.beyondOneLevel() + ",\"pixels\":" + c.pixels() + "}\n";
    }
}
