package simpleray.ui.desktop;

import java.awt.Dimension;
import java.awt.Toolkit;
import java.awt.datatransfer.StringSelection;
import java.awt.datatransfer.Transferable;
import java.awt.event.WindowAdapter;
import java.awt.event.WindowEvent;
import java.util.concurrent.Executor;
import javax.swing.Action;
import javax.swing.JComponent;
import javax.swing.JDialog;
import javax.swing.JMenu;
import javax.swing.JMenuItem;
import javax.swing.KeyStroke;
import javax.swing.SwingUtilities;
import simpleray.image.Picture;
import simpleray.render.RenderRequest;
import simpleray.ui.file.FileSource;
import simpleray.ui.file.SceneSource;
import simpleray.ui.picture.CommandWords;
import simpleray.ui.picture.RenderJob;
import simpleray.ui.picture.SimpleRay;
import simpleray.ui.picture.ViewerContext;
import simpleray.ui.widget.KeyBindings;
import simpleray.ui.widget.Look;

/** Actions that users of a desktop expect beside opening and saving: recent scenes, copies, a chosen look, help. */
public final class DesktopActions {
    private static final Dimension EXAMPLES = new Dimension(760, 620);

    private final ViewerContext window;
    private final Action copyPicture;
    private final Action copyCommand;
    private final RecentMenu recent;
    private final LookMenu look;
    private final HelpMenu help;
    private final Executor thumbnails;
    private final Preferences preferences;
    private WindowPlace place;
    private volatile Thread icon;                             // makes the window's icon; null before
    private volatile Thread copying;                          // a picture to the clipboard; null if none was
    private Made made;

    /** The picture shown, with its scene, its frame of a film, and its request; the picture is null if only a region of it was made. */
    private record Made(Picture picture, SceneSource source, int frame, RenderRequest request) {
    }

    /**
     * Creates the actions.
     *
     * @param window the window
     * @param preferences what it remembers
     * @param look how it looks
     * @param lookChanged called when it looks otherwise, for what Swing does not reach
     */
    public DesktopActions(ViewerContext window, Preferences preferences, Look look, Runnable lookChanged) {
        this.window = window;
        this.preferences = preferences;
        this.look = new LookMenu(window.frame(), preferences, look, lookChanged);
        copyPicture = KeyBindings.action("Copy Picture", "control C", this::copyPicture);
        copyCommand = KeyBindings.action("Copy Command Line", "control shift L", this::copyCommand);
        recent = new RecentMenu(window, preferences);
        help = new HelpMenu(window);
        thumbnails = window.workers().stopping("simpleray-examples");
        window.frame().setTransferHandler(new SceneDrop(window));
    }

    /** Puts the window, which has all its parts by now, where it was. */
    public void placeWindow() {
        place = new WindowPlace(window.frame(), preferences);
        window.frame().addWindowListener(new WindowAdapter() {
            @Override
            public void windowOpened(WindowEvent e) {
                icon = ProgramIcon.set(window.frame());
            }
        });
    }

    /**
     * Adds the items below File &gt; Open.
     *
     * @param file the File menu
     */
    public void addOpening(JMenu file) {
        file.add(KeyBindings.action("Examples\u2026", "control shift O", this::showExamples));
        file.add(recent);
    }

    /** {@return what a window without a scene shows: the examples and the recent scenes} */
    public JComponent welcome() {
        ExamplesPane pane = new ExamplesPane(thumbnails, window::open);
        pane.addRecent(preferences.recent(), recent::open);
        return pane;
    }

    private void showExamples() {
        JDialog dialog = new JDialog(window.frame(), "Examples", true);
        dialog.add(new ExamplesPane(thumbnails, chosen -> {
            dialog.dispose();
            window.open(chosen);
        }));
        dialog.getRootPane().registerKeyboardAction(e -> dialog.dispose(), KeyStroke.getKeyStroke("ESCAPE"),
            JComponent.WHEN_IN_FOCUSED_WINDOW);
        dialog.setDefaultCloseOperation(JDialog.DISPOSE_ON_CLOSE);
        dialog.setSize(EXAMPLES);
        dialog.setLocationRelativeTo(window.frame());
        dialog.setVisible(true);
    }

    /**
     * Adds the items below File &gt; Save.
     *
     * @param file the File menu
     */
    public void addCopying(JMenu file) {
        file.add(copyPicture);
        file.add(copyCommand);
    }

    /** {@return the menu of looks} */
    public JMenu lookMenu() {
        return look.menu();
    }

    /** {@return the Help menu} */
    public JMenu helpMenu() {
        return help.menu();
    }

    /**
     * Ticks an item if it was ticked last, and remembers it from now on.
     *
     * @param item the item, which has the state of a window that remembers nothing
     * @param name the name by which it is remembered
     */
    public void remember(JMenuItem item, String name) {
        if (preferences.isChosen(name, item.isSelected()) != item.isSelected()) {
            item.doClick(0);
        }
        item.addItemListener(e -> preferences.setChosen(name, item.isSelected()));
    }

    /**
     * Gives an action a second key.
     *
     * @param action the action
     * @param key the key
     */
    public void addKey(Action action, String key) {
        Shortcuts.addKey(window.frame(), action, key);
    }

    /**
     * Notes that a scene is opened.
     *
     * @param source the scene
     */
    public void opened(SceneSource source) {
        recent.opened(source);
    }

    /** Enables the items that can be used now. */
    public void refresh() {
        SimpleRay shown = window.picture();
        Picture whole = shown.whole();
        RenderJob job = shown.job();
        RenderJob.Snapshot now = job == null ? null : job.snapshot();
        if (whole != null) {
            if (made == null || made.picture != whole) {
                made = new Made(whole, shown.source(), now.frame(), now.request());
            }
        } else if (now != null && now.isAlone() && now.state() == RenderJob.State.FINISHED && !shown.isBusy()) {
            made = new Made(null, shown.source(), now.frame(), now.request().with(now.region()));
        } else {
            made = null;
        }
        copyPicture.setEnabled(made != null && made.picture != null);
        copyCommand.setEnabled(made != null);
    }

    /**
     * Takes notice that a text was saved after it was rendered.
     *
     * @param text the text
     * @param file the file that it is in now
     */
    public void saved(SceneSource text, SceneSource file) {
        if (made != null && made.source == text) {
            made = new Made(made.picture, file, made.frame, made.request);
            refresh();
        }
    }

    private void copyPicture() {
        Picture picture = made.picture;
        copying = new Thread(() -> {                          // a large one takes longer than a window may stand still
            try {
                CopiedPicture copied = new CopiedPicture(picture.toBufferedImage());
                SwingUtilities.invokeLater(() -> copy(copied, "Copied the picture"));
            } catch (OutOfMemoryError e) {
                SwingUtilities.invokeLater(() -> window.say("The memory is too short to copy the picture"));
            }
        }, "simpleray-copying");
        copying.setDaemon(true);
        copying.start();
    }

    private void copyCommand() {
        SceneSource scene = made.source;
        if (!(scene instanceof FileSource)) {
            window.say("A command line names the scene's file, and this text is not saved: save the scene first");
            return;
        }
        String line = CommandWords.line(scene.path(), scene.reach(), PictureDialogs.pictureName(scene), made.frame, made.request);
        copy(new StringSelection(line), "Copied the command line");
    }

    private void copy(Transferable copied, String done) {
        try {
            Toolkit.getDefaultToolkit().getSystemClipboard().setContents(copied, null);
            window.say(done);
        } catch (IllegalStateException e) {                   // another program holds it just now
            window.say("The clipboard is not free just now: try again");
        }
    }

    /** Notes the place of the window, and ends. */
    public void close() {
        look.close();
        place.remember();
        preferences.close();
    }

    /**
     * Waits until it is written, and until all threads have ended; not for the event thread.
     *
     * @throws InterruptedException if the thread is interrupted
     */
    public void await() throws InterruptedException {
        look.await();
        for (Thread own : new Thread[] {icon, copying}) {
            if (own != null) {
                own.join();
            }
        }
        preferences.await();
    }
}
