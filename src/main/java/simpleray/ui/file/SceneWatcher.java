package simpleray.ui.file;

import java.io.Closeable;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.Map;
import java.util.Set;
import java.util.function.Consumer;
import javax.swing.SwingUtilities;

/**
 * Watches a scene file and the meshes that it names, on a thread of its own, which looks at them ten times a second: that costs little, and
 * works on network disks, too. It reports a file when it has been left alone for a moment, since most editors write a file in more than one
 * piece, or have none for a moment.
 */
public final class SceneWatcher implements Closeable {
    private static final long LOOK = 100;                     // milliseconds between two looks
    private static final long QUIET = 30;                     // without a change before a change is reported
    private static final long GONE = 250;                     // without the file before its deletion is reported
    private static final long PATIENCE = 1000;                // for the thread at its end

    private final Path scene;
    private final Consumer<News> listener;
    private final Thread thread = new Thread(this::work, "simpleray-watcher");
    private final Map<Path, FileStamp> known = new HashMap<>();
    private boolean deleted;                                  // the deletion of the scene's file is reported
    private volatile FileStamp own;                           // of the file that this program wrote
    private volatile boolean watching;
    private volatile boolean closed;

    /** What happened to a scene. */
    public enum News {
        /** The scene's file or one of its meshes is another. */
        CHANGED,
        /** The scene's file is gone. */
        DELETED,
        /** The scene's file was deleted, and this program has written it again. */
        RESTORED
    }

    /**
     * Notes how the file is now; {@link #start} begins to watch.
     *
     * @param scene the scene's file
     * @param listener called on the event thread, not after {@link #close}; a deleted file that is back is a change
     */
    public SceneWatcher(Path scene, Consumer<News> listener) {
        this.scene = scene;
        this.listener = listener;
        known.put(scene, FileStamp.of(scene));
        thread.setDaemon(true);
    }

    /** Starts to watch. */
    public void start() {
        thread.start();
    }

    /** {@return whether the meshes are watched by now, too} */
    boolean isWatching() {
        return watching;
    }

    /** Takes the file as it is now for known: this program wrote it. Any thread may call. */
    public void wrote() {
        own = FileStamp.of(scene);
    }

    /** Ends the thread soon; does not wait for it. */
    @Override
    public void close() {
        closed = true;
        thread.interrupt();
    }

    /**
     * Waits until the thread has ended, though not for long: a network disk may not answer.
     *
     * @throws InterruptedException if the thread is interrupted
     */
    public void await() throws InterruptedException {
        thread.join(PATIENCE);
    }

    private void work() {
        try {
            watchMeshes();
            watching = true;
            while (!closed) {
                Thread.sleep(LOOK);
                if (!changed().isEmpty()) {
                    settle();
                }
            }
        } catch (InterruptedException e) {
            return;                                           // closed
        }
    }

    /** {@return the files that are not as they are known, and how they are} */
    private Map<Path, FileStamp> changed() {
        Map<Path, FileStamp> other = new HashMap<>();
        known.forEach((file, before) -> {
            FileStamp now = FileStamp.of(file);
            if (!now.isSame(before)) {
                other.put(file, now);
            }
        });
        return other;
    }

    /** Waits until the files stay as they are, and reports what has changed. */
    private void settle() throws InterruptedException {
        Map<Path, FileStamp> now = changed();
        long quiet = 0;
        while (!closed && quiet < (now.containsValue(FileStamp.NONE) ? GONE : QUIET)) {
            Map<Path, FileStamp> before = now;
            Thread.sleep(QUIET);
            now = changed();
            quiet = now.equals(before) ? quiet + QUIET : 0;
        }
        known.putAll(now);
        FileStamp ours = own;
        if (!now.isEmpty()) {
            watchMeshes();                                    // before anybody reads them: a scene names meshes, a mesh MTL files
        }
        if (FileStamp.NONE.equals(now.get(scene))) {
            deleted = true;
            tell(News.DELETED);
        } else if (!now.isEmpty() && known.get(scene).there()) {
            boolean onlyOurs = now.size() == 1 && now.containsKey(scene) && ours != null && now.get(scene).isSame(ours);
            if (deleted || !onlyOurs) {
                tell(onlyOurs ? News.RESTORED : News.CHANGED);
            }
            deleted = false;
        }
    }

    private void watchMeshes() {
        Set<Path> named = MeshNames.of(scene);
        if (known.get(scene).there()) {
            known.keySet().removeIf(file -> !file.equals(scene) && !named.contains(file));
        }
        named.forEach(file -> known.computeIfAbsent(file, FileStamp::of));
    }

    private void tell(News news) {
        SwingUtilities.invokeLater(() -> {
            if (!closed) {
                listener.accept(news);
            }
        });
    }
}
