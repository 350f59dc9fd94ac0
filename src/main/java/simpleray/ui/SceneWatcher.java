package simpleray.ui;

import java.io.Closeable;
import java.io.IOException;
import java.nio.file.ClosedWatchServiceException;
import java.nio.file.FileSystems;
import java.nio.file.Path;
import java.nio.file.StandardWatchEventKinds;
import java.nio.file.WatchKey;
import java.nio.file.WatchService;
import java.util.HashMap;
import java.util.HashSet;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import javax.swing.SwingUtilities;

/**
 * Watches a scene file and the meshes that it names, on a thread of its own. The system tells of changes at once where it can; where
 * it cannot, as on network disks, files are looked at again and again. A file is reported when it has been left alone for a moment:
 * most editors write it in more than one piece, or for a moment have none.
 */
final class SceneWatcher implements Closeable {
    private static final long QUIET = 30;                     // milliseconds in which nothing may change before a change is told
    private static final long GONE = 250;                     // and in which no file may come back before its end is told
    private static final long SLOW = 1000;                    // between two looks where the system tells of changes
    private static final long FAST = 100;                     // and where it does not

    private final boolean asking;                             // the system, and not only looking
    private final Path scene;
    private final Consumer<News> listener;
    private final Thread thread = new Thread(this::work, "simpleray-watcher");
    private final Map<Path, FileStamp> known = new HashMap<>();
    private final Map<Path, WatchKey> folders = new HashMap<>();
    private WatchService service;                             // null if the system tells nothing
    private boolean told;                                     // that the scene file is gone
    private volatile FileStamp own;                           // of the file that this program wrote
    private volatile boolean watching;
    private volatile boolean closed;

    /** What happened to a scene. */
    enum News {
        /** The scene's file or one of its meshes is another. */
        CHANGED,
        /** The scene's file is gone. */
        DELETED
    }

    /**
     * Notes how the file is now; {@link #start} begins to watch.
     *
     * @param scene the scene's file
     * @param listener told on the event thread, not after {@link #close}; that a deleted file is back it is told as a change
     */
    SceneWatcher(Path scene, Consumer<News> listener) {
        this(scene, listener, true);
    }

    /** Creates a watcher that asks the system to tell it of changes, or one that only looks, as where the system cannot tell. */
    SceneWatcher(Path scene, Consumer<News> listener, boolean asking) {
        this.asking = asking;
        this.scene = scene;
        this.listener = listener;
        known.put(scene, FileStamp.of(scene));
        thread.setDaemon(true);
    }

    void start() {
        thread.start();
    }

    /** {@return whether the meshes are watched by now, too} */
    boolean isWatching() {
        return watching;
    }

    /** Takes the file as it is now for known: this program wrote it. Any thread may call. */
    void wrote() {
        own = FileStamp.of(scene);
    }

    /** Ends the thread soon; does not wait for it. */
    @Override
    public void close() {
        closed = true;
        thread.interrupt();
    }

    /** Waits until the thread has ended, though not for long: a network disk may not answer. */
    void await() throws InterruptedException {
        thread.join(SLOW);
    }

    private void work() {
        try (WatchService opened = asking ? open() : null) {
            service = opened;
            lookForMeshes();
            watching = true;
            while (!closed) {
                boolean hinted = look(service == null ? FAST : SLOW);
                if (hinted || !changed().isEmpty()) {
                    settle(hinted);
                }
            }
        } catch (InterruptedException | ClosedWatchServiceException e) {
            return;                                           // closed
        } catch (IOException e) {
            throw new IllegalStateException("a watch service cannot be closed", e);
        }
    }

    /** {@return the system's service; null if it has none, or one that itself only looks again and again} */
    private static WatchService open() throws IOException {
        try {
            WatchService made = FileSystems.getDefault().newWatchService();
            if (!made.getClass().getSimpleName().startsWith("Polling")) {
                return made;
            }
            made.close();
        } catch (IOException | UnsupportedOperationException e) {
            return null;                                      // as many are open as a user may have
        }
        return null;
    }

    /** Waits until the system tells something or the time is over. {@return whether it was told of a file whose stamp may not tell} */
    private boolean look(long milliseconds) throws InterruptedException {
        if (service == null) {
            Thread.sleep(milliseconds);
            return false;
        }
        watchFolders();
        boolean hinted = false;
        WatchKey key = service.poll(milliseconds, TimeUnit.MILLISECONDS);
        while (key != null) {
            Path folder = (Path) key.watchable();
            hinted |= key.pollEvents().stream().anyMatch(event -> event.context() instanceof Path name && isVague(folder.resolve(name)));
            key.reset();
            key = service.poll();
        }
        return hinted;
    }

    private boolean isVague(Path file) {
        return known.entrySet().stream().anyMatch(e -> e.getKey().toAbsolutePath().equals(file) && e.getValue().isVague());
    }

    /** Has the system watch the folders of all files, and of those that they are links to. */
    private void watchFolders() {
        Set<Path> wanted = new HashSet<>();
        for (Path file : known.keySet()) {
            wanted.add(file.toAbsolutePath().getParent());
            try {
                wanted.add(file.toRealPath().getParent());
            } catch (IOException e) {
                continue;                                     // there is no file just now
            }
        }
        folders.values().removeIf(key -> !key.isValid());
        folders.entrySet().removeIf(entry -> {
            boolean over = !wanted.contains(entry.getKey());
            if (over) {
                entry.getValue().cancel();
            }
            return over;
        });
        for (Path folder : wanted) {
            try {
                if (folder != null && !folders.containsKey(folder)) {
                    folders.put(folder, folder.register(service, StandardWatchEventKinds.ENTRY_CREATE,
                        StandardWatchEventKinds.ENTRY_MODIFY, StandardWatchEventKinds.ENTRY_DELETE));
                }
            } catch (IOException e) {
                continue;                                     // no such folder now: asked again at the next look
            }
        }
    }

    /** {@return the files that are not as they are known, and how they are} */
    private Map<Path, FileStamp> changed() {
        Map<Path, FileStamp> other = new HashMap<>();
        for (Map.Entry<Path, FileStamp> entry : known.entrySet()) {
            FileStamp now = FileStamp.of(entry.getKey());
            if (!now.equals(entry.getValue())) {
                other.put(entry.getKey(), now);
            }
        }
        return other;
    }

    /** Waits until the files stay as they are, and tells what has changed. */
    private void settle(boolean hinted) throws InterruptedException {
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
        if (now.containsKey(scene) || hinted) {
            lookForMeshes();                                  // before anybody reads them
        }
        boolean only = now.size() == 1 && ours != null && ours.equals(now.get(scene));
        if (FileStamp.NONE.equals(now.get(scene))) {
            told = true;
            tell(News.DELETED);
        } else if ((hinted || !now.isEmpty()) && (told || !only) && known.get(scene).there()) {
            told = false;
            tell(News.CHANGED);
        }
    }

    private void lookForMeshes() {
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
