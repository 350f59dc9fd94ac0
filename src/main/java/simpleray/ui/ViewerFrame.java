package simpleray.ui;

import java.awt.BorderLayout;
import java.awt.Dimension;
import java.awt.Rectangle;
import java.awt.event.ComponentAdapter;
import java.awt.event.ComponentEvent;
import java.awt.event.WindowAdapter;
import java.awt.event.WindowEvent;
import java.io.File;
import javax.swing.BorderFactory;
import javax.swing.JComponent;
import javax.swing.JFrame;
import javax.swing.JLayeredPane;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.JSplitPane;
import javax.swing.SwingUtilities;
import javax.swing.Timer;
import simpleray.render.RenderRequest;
import simpleray.ui.compare.Comparison;
import simpleray.ui.desktop.DesktopActions;
import simpleray.ui.desktop.PictureDialogs;
import simpleray.ui.desktop.Preferences;
import simpleray.ui.editor.DiagnosticsPane;
import simpleray.ui.editor.EditorContext;
import simpleray.ui.editor.SceneDocument;
import simpleray.ui.editor.SceneMenu;
import simpleray.ui.file.SceneSource;
import simpleray.ui.file.SceneWatcher;
import simpleray.ui.film.TimeLine;
import simpleray.ui.inspect.Inspector;
import simpleray.ui.picture.CameraMenu;
import simpleray.ui.picture.PictureSettings;
import simpleray.ui.picture.RenderJob;
import simpleray.ui.picture.SceneReport;
import simpleray.ui.picture.SimpleRay;
import simpleray.ui.picture.ZoomTool;
import simpleray.ui.widget.Banner;
import simpleray.ui.widget.Look;
import simpleray.ui.widget.SidePanes;
import simpleray.ui.widget.Workers;

/** The window: menus, the picture, problems of the scene if there are any, and a status bar. For the event thread, but for await. */
final class ViewerFrame extends JFrame implements EditorContext {
    private static final long serialVersionUID = 1L;
    private static final int DIVIDER = 6;
    private static final int LINES = 46;                      // the least height of problems: two lines, or one and a scroll bar
    private static final int LOW = 360;                       // the least height: half of what small screens have at scale 2
    private static final int MARGIN = 16;                     // wider than the edges that desktops draw round a window
    private static final String GONE = "gone";
    /** Milliseconds that a changed file with errors has to become whole: another program may still be writing it. */
    private static final int PATIENCE = 400;

    private final transient SimpleRay picture;
    private final JScrollPane scroll;                         // shows it
    private final transient Workers workers = new Workers();
    private final transient SceneDocument document = new SceneDocument(this);
    private final DiagnosticsPane problems = new DiagnosticsPane(document::goTo);
    private final Banner banner;
    private final JSplitPane split;
    private int below;                                        // the height of what is below the picture, if there is room
    private final SidePanes sides = new SidePanes();
    private final JPanel pictured = new JPanel(new BorderLayout());   // the picture, the camera's line, and the time line of a film
    private final StatusBar status = new StatusBar();
    private final transient DesktopActions desktop;
    private final transient Inspector inspector;
    private final transient Comparison comparison;
    private final transient ViewerMenus menus;
    private final transient CameraMenu camera;
    private final transient TimeLine timeLine;
    private final transient Runnable closed;
    private final transient Timer patience = new Timer(PATIENCE, e -> believe());
    private transient SceneSource opened = SceneSource.NONE;
    private transient volatile SceneWatcher watcher;          // null if the scene is no file
    private transient RenderJob doubted;                      // one of a file that may be half-written
    private transient boolean doubting;                       // the next rendering is such a one
    private transient RenderJob told;                         // whose problems are shown
    private String toldText = "";
    private transient SceneReport faults;                     // of a text that is not rendered; null if it is

    /** A window that remembers nothing and leaves the look as it is. */
    ViewerFrame(SceneSource source, RenderRequest request, Runnable closed) {
        this(source, request, Preferences.none(), Look.LIGHT, closed);
    }

    ViewerFrame(SceneSource source, RenderRequest request, Preferences preferences, Look look, Runnable closed) {
        this.closed = closed;
        picture = new SimpleRay(source, request);
        scroll = new JScrollPane(picture);
        patience.setRepeats(false);
        timeLine = new TimeLine(this);
        split = new JSplitPane(JSplitPane.VERTICAL_SPLIT, sides, null);
        split.setBorder(BorderFactory.createEmptyBorder());
        split.setResizeWeight(1);
        split.setDividerSize(0);                              // until there are problems to show
        inspector = new Inspector(this, line -> status.showPixel(line.isBlank() ? document.valueLine() : line), document::goTo);
        inspector.setPointed(document::pointed);
        PictureDialogs dialogs = new PictureDialogs(this, preferences);
        desktop = new DesktopActions(this, preferences, look, this::lookChanged);
        comparison = new Comparison(this);
        camera = new CameraMenu(this, document::text, document::replace);
        comparison.setTeller(camera::tellGestures);
        pictured.add(timeLine.below(scroll), BorderLayout.CENTER);
        pictured.add(camera.line(), BorderLayout.SOUTH);
        pictured.setMinimumSize(new Dimension());
        sides.setLeftComponent(pictured);
        sides.setKeeper(change -> {
            if (picture.isPlaced()) {
                picture.keep(change, true);
            } else {
                change.run();
            }
        });
        PictureSettings settings = new PictureSettings(this, document::show, document::text, document::replace);
        menus = new ViewerMenus(picture, dialogs, desktop, new SceneMenu(document, problems), inspector, comparison, camera, timeLine,
            settings, this::close);
        setJMenuBar(menus.bar());
        desktop.remember(ToolBar.item(menus.bar(), "Wheel Zooms"), "wheel.zooms");
        desktop.remember(ToolBar.item(menus.bar(), "Render While Typing"), "typing.renders");
        PixelMenu.install(this, inspector, document, camera);
        ToolBar tools = new ToolBar(menus.bar());
        add(tools, BorderLayout.NORTH);
        banner = new Banner(tools);
        getLayeredPane().add(banner, JLayeredPane.PALETTE_LAYER);
        split.addComponentListener(new ComponentAdapter() {
            @Override
            public void componentResized(ComponentEvent e) {
                keepInSight();
            }
        });
        add(split, BorderLayout.CENTER);
        add(status, BorderLayout.SOUTH);
        setDefaultCloseOperation(DO_NOTHING_ON_CLOSE);
        addWindowListener(new WindowAdapter() {
            @Override
            public void windowClosing(WindowEvent e) {
                close();
            }
        });
        picture.setListener(this::refresh);
        status.addRight(ZoomTool.label(picture));
        setMinimumSize(new Dimension(Math.max(tools.getPreferredSize().width, menus.bar().getPreferredSize().width) + MARGIN, LOW));
        picture.setSpareBelow(DIVIDER + LINES);
        desktop.placeWindow();
        validate();                                           // problems that are known at once find how high the window is
        open(source);
    }

    @Override
    public JFrame frame() {
        return this;
    }

    @Override
    public SimpleRay picture() {
        return picture;
    }

    @Override
    public SidePanes sides() {
        return sides;
    }

    @Override
    public Workers workers() {
        return workers;
    }

    @Override
    public Banner banner() {
        return banner;
    }

    @Override
    public CameraMenu camera() {
        return camera;
    }

    Comparison comparison() {
        return comparison;
    }

    SceneDocument document() {
        return document;
    }

    @Override
    public void open(SceneSource source) {
        document.leave(() -> {
            camera.forget();
            timeLine.forget();
            showPicture(source != SceneSource.NONE);
            opened = source;
            picture.setSource(source);
            desktop.opened(source);
            banner.hide(GONE);
            watch(source);
            document.open(source);
            if (source == SceneSource.NONE) {
                status.say("Open a scene file: File > Open\u2026");
                refreshMenus();
            } else {
                picture.start();
            }
        });
    }

    /** Shows the picture; or, while there is no scene, what one could open. */
    private void showPicture(boolean scene) {
        if (!scene) {
            sides.setLeftComponent(desktop.welcome());
        } else if (sides.getLeftComponent() != pictured) {
            sides.setLeftComponent(pictured);
            validate();
            picture.requestFocusInWindow();
        }
    }

    private void watch(SceneSource source) {
        if (watcher != null) {
            watcher.close();
        }
        watcher = source.path() == null ? null : new SceneWatcher(source.path(), this::heard);
        if (watcher != null) {
            watcher.start();
        }
    }

    private void heard(SceneWatcher.News news) {
        if (news == SceneWatcher.News.DELETED) {
            patience.stop();                                  // its errors do not matter any more
            String name = new File(opened.name()).getName();
            banner.show(GONE, name + " was deleted; the picture is the last one read");
            document.fileGone();
            refresh();                                        // one that failed because of that is over
        } else {
            banner.hide(GONE);
            if (news == SceneWatcher.News.CHANGED) {
                document.fileChanged();
            }
        }
    }

    @Override
    public void wroteScene() {
        SceneWatcher current = watcher;
        if (current != null) {
            current.wrote();
        }
    }

    @Override
    public void refreshTitle() {
        String name = new File(opened.name()).getName();
        setTitle(name.isEmpty() ? "SimpleRay" : (document.isChanged() ? "*" : "") + name + " - SimpleRay");
        getRootPane().putClientProperty("Window.documentModified", document.isChanged());      // a Mac's own sign
    }

    @Override
    public void reload(SceneSource source) {
        patience.stop();
        picture.setSource(source);
        doubting = true;
        picture.start();                                      // which may have failed before this returns
    }

    /** Sets how many milliseconds a file has to become whole before its errors are shown. */
    void setPatience(int milliseconds) {
        patience.setInitialDelay(milliseconds);
    }

    @Override
    public void saved(SceneSource text, SceneSource file) {
        desktop.saved(text, file);
    }

    @Override
    public void showProgress() {
        if (picture.job() != null) {
            status.unsay();
            tell(picture.job(), picture.job().snapshot());
        }
    }

    @Override
    public void say(String message) {
        status.say(message);
    }

    /** Follows another look where Swing does not: in what is not shown now. */
    void lookChanged() {
        SwingUtilities.updateComponentTreeUI(problems);
        if (document.editor() != null) {
            SwingUtilities.updateComponentTreeUI(document.editor());
        }
    }

    /** Closes the window and ends its threads, once nothing is lost by that. */
    void close() {
        document.leave(this::end);
    }

    private void end() {
        patience.stop();
        picture.stop();
        if (watcher != null) {
            watcher.close();
        }
        workers.close();
        desktop.close();
        dispose();
        closed.run();
    }

    /** Waits until the threads of the window have ended. */
    void await() throws InterruptedException {
        RenderJob job = picture.job();
        if (job != null) {
            job.await();
        }
        if (watcher != null) {
            watcher.await();
        }
        workers.await();
        desktop.await();
    }

    private void refresh() {
        RenderJob job = picture.job();
        if (doubting) {
            doubted = job;
            doubting = false;
        }
        RenderJob.Snapshot now = job.snapshot();
        if (job == doubted && now.state() == RenderJob.State.FAILED) {
            if (banner.message(GONE) != null) {
                tell(job, now);   // it says itself what is wrong
            } else if (!patience.isRunning()) {
                patience.start();
            }
            return;
        }
        tell(job, now);
        inspector.update(job);
        timeLine.update(job);
        document.outline().update(job);
        SceneReport report = faults != null ? faults : new SceneReport(now.problems(), now.findings().places());
        String text = report.text();
        if ((faults != null || now.state() != RenderJob.State.READING) && (job != told || !text.equals(toldText))) {
            told = job;
            toldText = text;
            showProblems(report);
            document.markProblems(job);
        }
        refreshMenus();
    }

    private void tell(RenderJob job, RenderJob.Snapshot now) {
        status.show(job, now, picture.isBlank() ? null : picture.imageSize());
        camera.setBlank(picture.isBlank());
    }

    /** Shows the errors of a file that has not changed any more. */
    private void believe() {
        doubted = null;
        refresh();
    }

    private void refreshMenus() {
        menus.refresh(picture.isBusy(), picture.whole() != null && !picture.isBusy(), opened != SceneSource.NONE);
    }

    @Override
    public void showFaults(SceneReport other) {
        faults = other;
        told = null;
        if (picture.job() != null) {
            refresh();
        }
    }

    @Override
    public void tellValue(String line) {
        status.showPixel(line);
    }

    private void showProblems(SceneReport report) {
        String text = report.text();
        if (text.equals(problems.getText())) {
            return;                                           // the same as before: the selection stays
        }
        problems.show(text, report.places());
        JScrollPane pane = text.isEmpty() ? null : new JScrollPane(problems);
        validate();                                           // else the picture's place may be an older window's
        if (picture.isPlaced()) {
            picture.keep(() -> showProblems(pane), true);
        } else {
            showProblems(pane);
        }
    }

    /** {@return the room below a picture that is there, which problems may take without moving it; it leaves two lines} */
    private int free() {
        Rectangle place = picture.place();
        JComponent bottom = (JComponent) split.getBottomComponent();
        return Math.max(LINES, picture.getVisibleRect().y + scroll.getViewport().getHeight() - place.y - place.height
            + (bottom == null ? -DIVIDER : bottom.getHeight()));
    }

    private void showProblems(JScrollPane pane) {
        int free = picture.seen() == null ? Integer.MAX_VALUE : free();
        picture.setSpareBelow(pane == null ? DIVIDER + LINES : 0);
        split.setBottomComponent(pane);
        split.setDividerSize(pane == null ? 0 : DIVIDER);
        if (pane == null) {
            validate();
        } else {
            divide(Math.min(pane.getPreferredSize().height, free));
        }
    }

    /** Gives what is below the picture a height, or as much as the picture leaves. */
    private void divide(int height) {
        below = height;
        validate();                                           // else the height may be an older window's
        if (split.getHeight() > 0) {
            int whole = split.getHeight() - split.getDividerSize();
            split.setDividerLocation(whole - Math.min(below, room()));
            validate();                                       // only now it is known whether there is a scroll bar
            split.setDividerLocation(whole - problems.whole(Math.min(below, room())));
            validate();                                       // what the window gains or loses from now on is the picture's
        }
    }

    /** {@return the greatest height of what is below the picture, which has its share of the window; but at least two lines} */
    private int room() {
        int lines = scroll.getHeight() > 0 ? pictured.getHeight() - scroll.getHeight() : 0;   // of the camera and the film
        return Math.max(LINES, Math.min(split.getHeight() / 2, split.getHeight() - split.getDividerSize() - lines
            - SidePanes.leastOf(getContentPane().getHeight())));
    }

    /**
     * Shows what is below the picture, if the window has left no room for it: until it is painted, the divider stays where it is.
     * Leaves the picture its share.
     */
    private void keepInSight() {
        if (split.getBottomComponent() != null && (split.getBottomComponent().getHeight() < DIVIDER
            || split.getBottomComponent().getHeight() > room())) {
            divide(below);
        }
    }
}
