package simpleray.cli;

import java.io.Closeable;
import java.io.IOException;
import java.io.PrintStream;
import java.lang.ref.SoftReference;
import java.nio.file.FileSystemException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.function.Supplier;
import simpleray.image.Checkpoint;
import simpleray.image.png.RowSink;
import simpleray.io.AtomicFile;
import simpleray.io.FileInUseException;
import simpleray.io.OutputTarget;
import simpleray.render.Progress;
import simpleray.render.Renderer;
import simpleray.ui.picture.ShellWords;

/**
 * Keeps the finished rows of a rendering in a {@link Checkpoint}, so that it can go on if it is ended. Until the time comes to begin
 * a checkpoint, or SIGTERM, rows are kept in memory, and no class is loaded that only a checkpoint needs. Any thread may call.
 */
final class RenderCheckpointer implements RowSink, Closeable {
    /** After so many milliseconds a checkpoint is begun, if none was asked for. */
    static final long LATE = 10_000;
    /** How long the end of the program waits for the rendering to end, in milliseconds. */
    private static final long PATIENCE = 1_200;
    private static final long SHORT_PATIENCE = 400;
    /** Rows of so many bytes are kept in memory at most; those above are rendered again if need be. */
    private static final long MAX_EARLY = 32L << 20;

    private final Path path;                                  // null if there is nowhere to keep rows
    private final Renderer renderer;
    private final Supplier<Map<String, String>> identity;
    private final Notes notes;
    private final long start = System.nanoTime();
    private long late;
    private boolean named;                                    // whether the checkpoint was asked for
    private final Thread hook = new Thread("simpleray-interrupted") {
        @Override
        public void run() {
            RenderCheckpointer.this.interrupted();
        }
    };
    private final CountDownLatch closed = new CountDownLatch(1);
    private AtomicFile target;                                // null if the picture goes to a stream
    private Thread timer;
    private List<Early> early;                                // null if rows are not kept in memory
    private long earlyBytes;
    private Checkpoint checkpoint;                            // null before it is begun, and once it is ended
    private int rows;                                         // in the checkpoint when it was ended
    private int known;
    private boolean done;
    private boolean full;                                     // no more rows can be written to the checkpoint

    /** A row that waits for a checkpoint to be begun; gone if memory gets scarce. */
    private record Early(int y, SoftReference<byte[]> levels) {
    }

    /**
     * Where messages go.
     *
     * @param err standard error
     * @param quiet whether only errors are said
     * @param args the command line
     * @param lines a scheduler's lines; null for none
     */
    record Notes(PrintStream err, boolean quiet, String[] args, OpenJobLines lines) {
        void say(String text) {
            if (!quiet) {
                err.println("simpleray: " + text);
            }
        }

        /** Says, whether or not only errors are said, why the picture is not made. */
        void fail(String text) {
            err.println("simpleray: " + text);
            if (lines != null) {
                lines.fail("simpleray: " + text);
            }
        }

        /** {@return the command that goes on} */
        String command() {
            List<String> words = new ArrayList<>(List.of("simpleray"));
            words.addAll(Arrays.asList(args));
            words.removeIf("--restart"::equals);
            if (!words.contains("--resume")) {
                int end = words.indexOf("--");                // what follows is no option
                words.add(end < 0 ? words.size() : end, "--resume");
            }
            return ShellWords.posix(words);
        }
    }

    /**
     * Prepares to keep rows.
     *
     * @param path where to; null for nowhere
     * @param renderer the rendering, not begun yet
     * @param identity finds what decides the picture's pixels; asked only if need be
     * @param notes where messages go
     */
    RenderCheckpointer(Path path, Renderer renderer, Supplier<Map<String, String>> identity, Notes notes) {
        this.path = path;
        this.renderer = renderer;
        this.identity = identity;
        this.notes = notes;
    }

    /**
     * Begins: with the rows that are kept if that is asked for, and at once or later.
     *
     * @param options what is asked for
     * @param picture the file of the picture; null for none
     * @param late after how many milliseconds a checkpoint is begun that was not asked for
     * @throws CommandException if the checkpoint is of another picture, or cannot be used
     */
    void begin(CheckpointOptions options, AtomicFile picture, long late) throws CommandException {
        target = picture;
        this.late = late;
        named = options.isNamed();
        if (path != null) {
            try {
                begin(options);
            } catch (FileInUseException e) {
                throw new CommandException(ExitCode.BUSY, "simpleray: " + path + ": " + e.getReason());
            } catch (FileSystemException e) {
                throw new CommandException(ExitCode.NO_OUTPUT, "simpleray: " + path + ": " + OutputTarget.reason(e));
            } catch (IOException e) {
                throw new CommandException(ExitCode.NO_OUTPUT, "simpleray: " + path + ": the checkpoint cannot be used: " + e.getMessage());
            }
        }
        try {
            Runtime.getRuntime().addShutdownHook(hook);
        } catch (IllegalStateException e) {
            return;                                           // the program is being stopped already
        }
    }

    private void begin(CheckpointOptions options) throws IOException, CommandException {
        KeptRows kept = new KeptRows(path, options, renderer, notes);
        checkpoint = kept.resume(identity);
        known = checkpoint == null ? 0 : checkpoint.count();
        if (!kept.isFree()) {
            return;
        }
        if (options.isNamed()) {
            checkpoint = create(identity.get());
            if (checkpoint.lockRefusal() != null) {
                notes.say(path + ": " + checkpoint.lockRefusal());
            }
        } else {
            early = new ArrayList<>();
            timer = new Thread("simpleray-checkpoint") {
                @Override
                public void run() {
                    beginLate();
                }
            };
            timer.setDaemon(true);
            timer.start();
        }
    }

    private Checkpoint create(Map<String, String> picture) throws IOException {
        return Checkpoint.create(path, picture, rowBytes(), renderer.picture().height());
    }

    /** {@return how many rows are known from before} */
    int known() {
        return known;
    }

    private void beginLate() {
        try {
            Thread.sleep(late);
        } catch (InterruptedException e) {                    // the rendering has ended
            return;
        }
        try {
            beginCheckpoint(identity.get());                  // which takes its time, while others go on
        } catch (OutOfMemoryError e) {
            giveUp("there is no memory left for it");
        }
    }

    private synchronized void beginCheckpoint(Map<String, String> picture) {
        if (early == null) {                                  // the rendering has ended meanwhile
            return;
        }
        try {
            checkpoint = create(picture);
            for (Early row : early) {
                byte[] levels = row.levels.get();
                if (levels != null) {
                    checkpoint.put(row.y, levels, 0);
                }
            }
            early = null;
        } catch (IOException e) {
            giveUp(e);
        }
    }

    private int rowBytes() {
        return renderer.picture().channels() * renderer.picture().width();
    }

    @Override
    public synchronized void row(int y, byte[] levels, int from) {
        int length = rowBytes();
        if (checkpoint != null && !full) {
            try {
                checkpoint.put(y, levels, from);
            } catch (IOException e) {
                giveUp(e);
            }
        } else if (early != null && earlyBytes + length <= MAX_EARLY) {
            earlyBytes += length;
            early.add(new Early(y, new SoftReference<>(Arrays.copyOfRange(levels, from, from + length))));
        }
    }

    /** The picture is worth more than what would be needed to go on with it: the rendering does not end for this. */
    private synchronized void giveUp(String reason) {
        if (early != null || checkpoint != null) {            // else the rendering has ended meanwhile
            early = null;
            full = true;                                      // its rows are of use until the picture is whole
            if (checkpoint != null && checkpoint.count() == 0) {
                end();
            }
            notes.say(path + ": rows are not kept any more: " + reason);
        }
    }

    private void giveUp(IOException e) {
        giveUp(OutputTarget.reason(e));
    }

    /** Notes that the picture is whole: what was kept of it is not needed any more. */
    synchronized void finished() {
        done = true;
        end();
    }

    /** Ends the writing; what was written stays if it can be of use. */
    private synchronized void end() {
        early = null;
        if (checkpoint == null) {
            return;
        }
        rows = checkpoint.count();
        try {
            if (done || rows == 0) {
                checkpoint.remove();
            } else {
                checkpoint.close();
            }
        } catch (IOException e) {
            notes.say(path + (done ? ": cannot be removed: " : ": ") + OutputTarget.reason(e));
        }
        checkpoint = null;
    }

    /** Ends the keeping, when all that the rendering has begun is removed or moved to its place. */
    @Override
    public void close() {
        boolean stopped = false;
        try {
            Runtime.getRuntime().removeShutdownHook(hook);
        } catch (IllegalStateException e) {                   // the program is told to stop, and the hook runs
            stopped = true;
        }
        if (!stopped) {
            end();
            if (timer != null) {
                timer.interrupt();
            }
        }
        closed.countDown();
    }

    /** Ends the rendering because the program is told to stop, and says what is kept. */
    private void interrupted() {
        renderer.cancel();
        Map<String, String> picture = null;
        if (hasEarlyRows() && isTerminated()) {
            try {
                picture = identity.get();                     // while the rendering ends
            } catch (OutOfMemoryError e) {
                giveUp("there is no memory left for it");
            }
        }
        try {
            closed.await(PATIENCE, TimeUnit.MILLISECONDS);
            if (timer != null && Progress.seconds(start, System.nanoTime()) * 1000 > late) {
                timer.join(SHORT_PATIENCE);                   // it may be about to write the rows
            }
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
        boolean whole = target != null && target.isWhole();
        synchronized (this) {
            done |= whole;
            if (picture != null && !done) {
                beginCheckpoint(picture);
            }
            end();
            if (!done) {
                notes.fail("interrupted" + (rows == 0
                    ? " after " + Progress.time(Progress.seconds(start, System.nanoTime()))
                        + (named ? ", before a row was finished" : ", and nothing is kept: --checkpoint FILE keeps rows from the start")
                    : ": " + rows + " of " + renderer.picture().height() + " rows are kept in " + path + "; to go on: "
                        + notes.command()));
            }
        }
    }

    private synchronized boolean hasEarlyRows() {
        return early != null && !early.isEmpty();
    }

    /**
     * {@return whether the program is told to stop by SIGTERM} So schedulers do, which begin it again; who types Ctrl+C within seconds does not
     * want to. The JVM handles a signal on a thread that it names after it.
     */
    private static boolean isTerminated() {
        for (Thread thread : Thread.getAllStackTraces().keySet()) {
            if (thread.getName().equals("SIGTERM handler")) {
                return true;
            }
        }
        return false;
    }
}
