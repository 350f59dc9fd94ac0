package simpleray.cli;

import java.io.IOException;
import java.math.BigDecimal;
import java.nio.file.Path;
import java.util.Locale;
import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.ParentCommand;
import simpleray.image.Picture;
import simpleray.image.PictureDiff;
import simpleray.image.png.HeatMap;
import simpleray.image.png.PictureFormatException;
import simpleray.image.png.PngReader;
import simpleray.io.AtomicFile;
import simpleray.io.InputFile;
import simpleray.text.NumberParser;

/** Measures how two pictures differ. */
@Command(mixinStandardHelpOptions = true, sortOptions = false,
    description = "Measures how two PNG pictures differ, in levels from 0 to 255: the largest difference, RMSE, PSNR, SSIM (Wang et al. "
        + "2004, of the luma, Gaussian windows of 11 x 11), and how many pixels differ by more than 1 level. Alpha is compared "
        + "as a fourth level if a picture has any; one that has none is opaque. The exit code is 0 if the pictures are the same, or differ "
        + "by no more than --tolerance and --pixels allow, 1 if they differ, 2 if they cannot be compared.")
final class CompareCommand implements Callable<Integer> {
    private static final int MAX_LEVELS = 255;

    @ParentCommand
    private Main main;

    @Parameters(index = "0", paramLabel = "A", description = "A PNG file; - is standard input.")
    private String one;

    @Parameters(index = "1", paramLabel = "B", description = "Another.")
    private String other;

    @Option(names = "--heatmap", paramLabel = "OUT.png",
        description = "Also write a picture of the differences: black where there is none, from blue for 1 level over red to yellow.")
    private String heatmap;

    @Option(names = "--tolerance", paramLabel = "LEVELS",
        description = "The pixels that count as different differ by more than so many levels, 0 to 255 (default: 0).")
    private String tolerance;

    @Option(names = "--pixels", paramLabel = "SHARE",
        description = "So large a share of all pixels may be different, as a number from 0 to 1 or in percent: 0.002 or 0.2%% (default: 0).")
    private String share;

    @Option(names = "--format", paramLabel = "FORMAT", defaultValue = "text",
        description = "How the figures are printed: ${COMPLETION-CANDIDATES} (default: ${DEFAULT-VALUE}).")
    private Stats.Format format;

    private int levels;                                       // the tolerance
    private BigDecimal part = BigDecimal.ZERO;                // the share, from 0 to 1, exactly as it is written

    @Override
    public Integer call() throws CommandException {
        readLimits();
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
            TextOutput.say(main, format == Stats.Format.JSON ? json(diff, a, b) : text(diff, a, b));
            return isWithin(diff) ? ExitCode.DONE : ExitCode.DIFFERENT;
        } catch (PictureFormatException e) {
            return trouble(e.getMessage());
        } catch (IOException e) {
            return trouble("the pictures cannot be read: " + e.getMessage());
        }
    }

    private void readLimits() throws CommandException {
        if (tolerance != null) {
            Long read = NumberParser.parseInteger(tolerance, 0, MAX_LEVELS);
            if (read == null) {
                throw CommandException.usage("--tolerance must be 0 to " + MAX_LEVELS + ", and is '" + tolerance + "'");
            }
            levels = read.intValue();
        }
        if (share != null) {
            boolean percent = share.endsWith("%");
            String number = percent ? share.substring(0, share.length() - 1) : share;
            double read = NumberParser.parseDouble(number);
            if (!(read >= 0 && read <= (percent ? 100 : 1))) {
                throw CommandException.usage("--pixels must be 0 to 1, or 0% to 100%, and is '" + share + "'");
            }
            part = percent ? new BigDecimal(number).movePointLeft(2) : new BigDecimal(number);
        }
    }

    /** {@return whether no more pixels differ than may} */
    private boolean isWithin(PictureDiff diff) {
        return BigDecimal.valueOf(diff.beyond(levels)).compareTo(part.multiply(BigDecimal.valueOf(diff.pixels()))) <= 0;
    }

    private boolean hasLimits() {
        return tolerance != null || share != null;
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
        PictureDiff diff = new PictureDiff(a.width(), a.height(), Math.max(a.channels(), b.channels()));
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

    private String text(PictureDiff c, PngReader a, PngReader b) {
        String sameness = c.maximum() == 0 ? "the same" : hasLimits() && isWithin(c) ? "alike enough" : "different";
        String alpha = a.channels() < b.channels() ? ", with alpha (" + one + " has none: opaque)"
            : a.channels() > b.channels() ? ", with alpha (" + other + " has none: opaque)" : a.channels() == Picture.RGBA ? ", with alpha" : "";
        String text = String.format(Locale.ROOT, "%s and %s are %s: %dx%d%s%n"
            + "largest difference     %d levels%n"
            + "RMSE                   %.6f levels%n"
            + "PSNR                   %s%n"
            + "SSIM                   %.6f%n"
            + "pixels beyond 1 level  %d of %d%n", one, other, sameness, a.width(), a.height(), alpha,
            c.maximum(), c.rmse(), c.maximum() == 0 ? "infinite" : String.format(Locale.ROOT, "%.4f dB", c.psnr()), c.ssim(),
            c.beyond(1), c.pixels());
        if (hasLimits()) {
            text += String.format(Locale.ROOT, "allowed                %s of the pixels beyond %d levels; these are %d%n",
                share == null ? "none" : share, levels, c.beyond(levels));
        }
        return text.replace(System.lineSeparator(), "\n");
    }

    private String json(PictureDiff c, PngReader a, PngReader b) {
        return "{\"same\":" + (c.maximum() == 0) + ",\"width\":" + a.width() + ",\"height\":" + a.height()
            + (Math.max(a.channels(), b.channels()) == Picture.RGBA ? ",\"alpha\":true" : "") + ",\"maximum\":" + c.maximum()
            + ",\"rmse\":" + c.rmse() + ",\"psnr\":" + (c.maximum() == 0 ? "null" : String.valueOf(c.psnr())) + ",\"ssim\":" + c.ssim()
            + ",\"beyondOneLevel\":" + c.beyond(1) + ",\"pixels\":" + c.pixels()
            + (hasLimits() ? ",\"tolerance\":" + levels + ",\"share\":" + part + ",\"beyondTolerance\":" + c.beyond(levels)
                + ",\"within\":" + isWithin(c) : "") + "}\n";
    }
}
