package simpleray.ui.desktop;

import java.awt.Rectangle;
import java.io.IOException;
import java.io.InputStream;
import java.io.StringReader;
import java.io.StringWriter;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Properties;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import java.util.stream.Collectors;
import simpleray.io.AtomicFile;
import simpleray.ui.widget.Look;

/**
 * What windows remember from one run to the next, in a file of properties. Remembering is a comfort: whatever is wrong with the file, or
 * with a value in it, is as if it were not there, and what cannot be written is forgotten. For the event thread, but for {@link #await}.
 */
public final class Preferences {
    /** The most scenes that are remembered. */
    static final int MAX_RECENT = 10;

    private static final int LARGEST = 1 << 18;               // bytes of a file that is read
    private static final int FARTHEST = 1_000_000;            // pixels, lest a sum overflow
    private static final long PATIENCE = 2;                   // seconds for a slow disk at the end
    private static final String RECENT = "recent.";
    private static final String FOLDER = "folder";
    private static final String LOOK = "look";
    private static final List<String> PLACE = List.of("window.x", "window.y", "window.width", "window.height");
    private static final String MAXIMISED = "window.maximised";

    private final Path file;                                  // null: nothing is kept
    private final Properties values;
    private final ExecutorService writer;                     // null if there is no file

    private Preferences(Path file) {
        this.file = file;
        values = file == null ? new Properties() : read(file);
        writer = file == null ? null : Executors.newSingleThreadExecutor(task -> {
            Thread thread = new Thread(task, "simpleray-preferences");
            thread.setDaemon(true);
            return thread;
        });
    }

    /**
     * Reads what was remembered.
     *
     * @param file where; null to remember nothing after this run
     * @return the preferences
     */
    public static Preferences load(Path file) {
        return new Preferences(file);
    }

    /** {@return preferences that are forgotten at the end} */
    public static Preferences none() {
        return new Preferences(null);
    }

    /** {@return where the window was; null if that is not known} */
    Rectangle place() {
        int[] numbers = new int[PLACE.size()];
        for (int i = 0; i < numbers.length; i++) {
            Integer number = number(values.getProperty(PLACE.get(i), ""));
            if (number == null) {
                return null;
            }
            numbers[i] = number;
        }
        return numbers[2] > 0 && numbers[3] > 0 ? new Rectangle(numbers[0], numbers[1], numbers[2], numbers[3]) : null;
    }

    private static Integer number(String word) {
        try {
            int number = Integer.parseInt(word.strip());
            return Math.abs((long) number) <= FARTHEST ? number : null;
        } catch (NumberFormatException e) {
            return null;
        }
    }

    /** {@return whether the window filled the screen} */
    boolean isMaximised() {
        return values.getProperty(MAXIMISED, "").equals("true");
    }

    void setPlace(Rectangle place, boolean maximised) {
        int[] numbers = {place.x, place.y, place.width, place.height};
        change(all -> {
            for (int i = 0; i < numbers.length; i++) {
                all.setProperty(PLACE.get(i), Integer.toString(numbers[i]));
            }
            all.setProperty(MAXIMISED, Boolean.toString(maximised));
        });
    }

    /** {@return the scenes that were opened, the latest first} */
    List<Path> recent() {
        return recent(values);
    }

    private static List<Path> recent(Properties all) {
        List<Path> files = new ArrayList<>();
        for (int i = 1; i <= MAX_RECENT; i++) {
            Path one = path(all.getProperty(RECENT + i, ""));
            if (one != null && !files.contains(one)) {
                files.add(one);
            }
        }
        return files;
    }

    private static Path path(String word) {
        try {
            return !word.isBlank() && Path.of(word).isAbsolute() ? Path.of(word) : null;
        } catch (InvalidPathException e) {
            return null;
        }
    }

    /** Puts a scene at the head of the recent ones. */
    void opened(Path scene) {
        Path whole = scene.toAbsolutePath().normalize();
        changeRecent(files -> {
            files.remove(whole);
            files.add(0, whole);
        });
    }

    /** Takes a scene off the recent ones. */
    void forget(Path scene) {
        changeRecent(files -> files.remove(scene));
    }

    void clearRecent() {
        changeRecent(List::clear);
    }

    private void changeRecent(Consumer<List<Path>> task) {
        change(all -> {
            List<Path> files = recent(all);
            task.accept(files);
            for (int i = 1; i <= MAX_RECENT; i++) {
                if (i <= files.size()) {
                    all.setProperty(RECENT + i, files.get(i - 1).toString());
                } else {
                    all.remove(RECENT + i);
                }
            }
        });
    }

    /** {@return the folder of the last file dialog; null if that is not known} */
    Path folder() {
        return path(values.getProperty(FOLDER, ""));
    }

    void setFolder(Path folder) {
        change(all -> all.setProperty(FOLDER, folder.toAbsolutePath().toString()));
    }

    /** {@return the look that was chosen; the desktop's if none was} */
    public Look look() {
        String word = values.getProperty(LOOK, "").strip().toLowerCase(Locale.ROOT);
        for (Look look : Look.values()) {
            if (look.toString().equals(word)) {
                return look;
            }
        }
        return Look.SYSTEM;
    }

    void setLook(Look look) {
        change(all -> all.setProperty(LOOK, look.toString()));
    }

    /** {@return what was chosen of a yes and a no; the other if that is not known} */
    boolean isChosen(String name, boolean otherwise) {
        String word = values.getProperty(name, "").strip().toLowerCase(Locale.ROOT);
        return word.equals("true") || otherwise && !word.equals("false");
    }

    void setChosen(String name, boolean chosen) {
        change(all -> all.setProperty(name, Boolean.toString(chosen)));
    }

    /** Changes what is known here and, on a thread of its own, what the file says by now: another window may have written it, too. */
    private void change(Consumer<Properties> task) {
        task.accept(values);
        if (writer != null && !writer.isShutdown()) {
            writer.execute(() -> write(task));
        }
    }

    /** Takes no more changes; those that were made are still written. */
    void close() {
        if (writer != null) {
            writer.shutdown();
        }
    }

    /** Waits until all is written, but not for long; not for the event thread. */
    void await() throws InterruptedException {
        if (writer != null) {
            writer.awaitTermination(PATIENCE, TimeUnit.SECONDS);
        }
    }

    private static Properties read(Path file) {
        Properties read = new Properties();
        if (Files.isRegularFile(file)) {                      // a pipe might never end
            try (InputStream in = Files.newInputStream(file)) {
                read.load(new StringReader(new String(in.readNBytes(LARGEST), StandardCharsets.UTF_8)));
            } catch (IOException | RuntimeException e) {
                return read;                                  // what was read until there
            }
        }
        return read;
    }

    private void write(Consumer<Properties> task) {
        try {
            if (Files.exists(file) && !Files.isRegularFile(file)) {
                return;
            }
            Files.createDirectories(file.toAbsolutePath().getParent());
            Properties all = read(file);
            task.accept(all);
            StringWriter text = new StringWriter();
            all.store(text, null);
            String lines = text.toString().lines().filter(line -> !line.startsWith("#")).sorted()   // # is the time of writing
                .collect(Collectors.joining("\n", "# What SimpleRay's window remembers\n", "\n"));
            try (AtomicFile whole = new AtomicFile(file)) {
                whole.out().write(lines.getBytes(StandardCharsets.UTF_8));
                whole.commit();
            }
        } catch (IOException | RuntimeException e) {
            return;                                           // forgotten at the end of this run
        }
    }
}
