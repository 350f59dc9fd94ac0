package simpleray.ui;

import com.formdev.flatlaf.FlatLightLaf;
import java.awt.Component;
import java.awt.Container;
import java.awt.Dialog;
import java.awt.Dimension;
import java.awt.Point;
import java.awt.Rectangle;
import java.awt.Window;
import java.awt.image.BufferedImage;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Queue;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.FutureTask;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.Consumer;
import java.util.function.Predicate;
import java.util.function.Supplier;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import javax.swing.JFrame;
import javax.swing.JLabel;
import javax.swing.JMenuItem;
import javax.swing.JScrollPane;
import javax.swing.MenuSelectionManager;
import javax.swing.SwingUtilities;
import javax.swing.text.JTextComponent;
import simpleray.render.RenderRequest;
import simpleray.render.Stage;
import simpleray.scene.SceneSettings;
import simpleray.ui.compare.Comparison;
import simpleray.ui.desktop.Preferences;
import simpleray.ui.editor.SceneDocument;
import simpleray.ui.file.SceneSource;
import simpleray.ui.picture.RenderJob;
import simpleray.ui.picture.SimpleRay;
import simpleray.ui.picture.ViewerContext;
import simpleray.ui.picture.Zoom;
import simpleray.ui.widget.Banner;
import simpleray.ui.widget.Look;

/** A window for a test. All methods are for the test's thread unless they say otherwise. */
public final class OpenWindow implements AutoCloseable {
    private static final int MIN_WIDTH = 760;
    private static final int MIN_HEIGHT = 560;
    private static final int MAX_LEFT = 6;
    private static final AtomicInteger LEFT = new AtomicInteger();   // windows that were opened since one was closed

    public final Screen screen = new Screen();
    public final JFrame frame;
    public final AtomicBoolean closed = new AtomicBoolean();
    private final ViewerFrame viewer;
    private final Queue<Throwable> uncaught = new ConcurrentLinkedQueue<>();

    /** Shows a window, and waits until it has the keys. */
    public OpenWindow(SceneSource source, int width, int height) {
        this(source, width, height, made -> { });
    }

    /** Does something with the window, shows it, and waits until it has the keys. */
    public OpenWindow(SceneSource source, int width, int height, Consumer<ViewerContext> first) {
        if (LEFT.getAndIncrement() >= MAX_LEFT) {             // each one more would take minutes
            throw new AssertionError("none of " + MAX_LEFT + " windows before this one was closed: their tests tell why");
        }
        Thread.setDefaultUncaughtExceptionHandler((thread, thrown) -> {      // of one window at a time
            thrown.printStackTrace();
            if (Arrays.stream(thrown.getStackTrace()).map(StackTraceElement::getClassName)
                .takeWhile(name -> !name.equals("java.awt.EventDispatchThread")).anyMatch(name -> name.startsWith("simpleray."))) {
                uncaught.add(thrown);
            }
        });
        Dimension size = new Dimension();
        viewer = ask(() -> {
            FlatLightLaf.setup();
            ViewerFrame made = new ViewerFrame(source, request(width, height), () -> closed.set(true));
            made.picture().setZoom(new Zoom(false, 1), null);  // so that tests find its pixels on the screen
            made.setMinimumSize(null);                        // tests of large pictures have small windows
            Dimension needed = made.getPreferredSize();
            made.setBounds(0, 0, Math.max(MIN_WIDTH, needed.width), Math.max(MIN_HEIGHT, needed.height));   // however large the screen is
            made.validate();
            first.accept(made);
            size.setSize(made.getSize());
            made.setVisible(true);
            made.toFront();
            return made;
        });
        frame = viewer;
        Screen.until("the window has the keys", () -> frame.isFocused() && frame.getFocusOwner() != null);
        run(() -> {
            frame.setSize(size);                              // an X server's late word of a size before this one may have changed it
            frame.validate();
        });
    }

    /** {@return a request for a picture of that size, with nothing else asked for} */
    public static RenderRequest request(int width, int height) {
        SceneSettings settings = new SceneSettings();
        settings.resolution = new SceneSettings.Resolution(width, height);
        return new RenderRequest(settings, Stage.FINAL, false, Runtime.getRuntime().availableProcessors());
    }

    /** {@return what the event thread answers} */
    public static <T> T ask(Supplier<T> question) {
        if (SwingUtilities.isEventDispatchThread()) {
            return question.get();
        }
        FutureTask<T> answer = new FutureTask<>(question::get);
        SwingUtilities.invokeLater(answer);
        try {
            return answer.get(Screen.SECONDS, TimeUnit.SECONDS);
        } catch (InterruptedException | ExecutionException | TimeoutException e) {
            throw new AssertionError("the event thread did not answer", e);
        }
    }

    /** Does something on the event thread. */
    public static void run(Runnable task) {
        ask(() -> {
            task.run();
            return null;
        });
    }

    /** Has the event thread do something that may take as long as a dialog is open. */
    public static void later(Runnable task) {
        SwingUtilities.invokeLater(task);
    }

    /** {@return the component and all that it contains} For the event thread. */
    public static Stream<Component> all(Component top) {
        Stream<Component> parts = top instanceof Container c ? Arrays.stream(c.getComponents()).flatMap(OpenWindow::all) : Stream.empty();
        return Stream.concat(Stream.of(top), parts);
    }

    /** {@return the first component of a type that can be seen and is as wanted, in any window; null for none} For the event thread. */
    public static <T extends Component> T seen(Class<T> type, Predicate<T> wanted) {
        return Arrays.stream(Window.getWindows()).filter(Component::isShowing).flatMap(OpenWindow::all)
            .filter(c -> type.isInstance(c) && c.isShowing()).map(type::cast).filter(wanted).findFirst().orElse(null);
    }

    /** {@return a component that is to appear} */
    public static <T extends Component> T appears(String what, Class<T> type, Predicate<T> wanted) {
        AtomicReference<T> found = new AtomicReference<>();
        Screen.until(what + " appears", () -> {
            found.set(seen(type, wanted));
            return found.get() != null;
        });
        return found.get();
    }

    /** {@return the threads of all windows that have not ended} */
    public static List<String> threads() {
        return stacks().keySet().stream().map(Thread::getName).sorted().collect(Collectors.toList());
    }

    private static Map<Thread, StackTraceElement[]> stacks() {
        Map<Thread, StackTraceElement[]> stacks = new HashMap<>(Thread.getAllStackTraces());
        stacks.keySet().removeIf(thread -> !thread.getName().startsWith("simpleray-"));
        return stacks;
    }

    ViewerFrame viewer() {
        return viewer;
    }

    /** {@return the place on the screen of a pixel of the picture, at 100 %} */
    public Point onScreen(Point pixel) {
        return ask(() -> {
            Point corner = picture().getLocationOnScreen();
            Rectangle all = picture().place();
            return new Point(corner.x + all.x + pixel.x, corner.y + all.y + pixel.y);
        });
    }

    public SimpleRay picture() {
        return viewer.picture();
    }

    public SceneDocument document() {
        return viewer.document();
    }

    public Banner banner() {
        return viewer.banner();
    }

    public Comparison comparison() {
        return viewer.comparison();
    }

    /** Opens another scene; for the event thread. */
    public void open(SceneSource source) {
        viewer.open(source);
    }

    /** {@return a window with these preferences, not shown; {@link #end} ends it} For the event thread. */
    public static JFrame hidden(Preferences preferences) {
        return new ViewerFrame(SceneSource.NONE, request(64, 64), preferences, Look.LIGHT, () -> { });
    }

    /** Closes a window and waits for its threads. */
    public static void end(JFrame frame) throws InterruptedException {
        run(((ViewerFrame) frame)::close);
        ((ViewerFrame) frame).await();
    }

    public RenderJob job() {
        return ask(() -> picture().job());
    }

    public void untilState(RenderJob.State state) {
        Screen.until("the rendering is " + state, () -> picture().job().state() == state && !picture().isBusy());
    }

    /** {@return the text of a label of the status bar} */
    public String label(String name) {
        return ask(() -> all(frame).filter(c -> name.equals(c.getName())).map(c -> ((JLabel) c).getText()).findFirst()
            .orElseThrow());
    }

    public String status() {
        return label("status");
    }

    /** {@return the problems that are shown; null if there is no such pane} */
    public JTextComponent problems() {
        return ask(() -> seen(JTextComponent.class, c -> "problems".equals(c.getName())));
    }

    /** Waits until problems are shown that have a text among them: a file may be read while only a part of it is written. */
    public void untilProblems(String text) {
        Screen.until("the problems are shown", () -> problems() != null && problems().getText().contains(text));
    }

    public JScrollPane scroll() {
        return ask(() -> (JScrollPane) SwingUtilities.getAncestorOfClass(JScrollPane.class, picture()));
    }

    /** {@return an item of a menu, whether its menu is open or not} */
    public JMenuItem item(String text) {
        return ask(() -> item(frame, text));
    }

    /** {@return an item of a menu of a window} For the event thread. */
    public static JMenuItem item(JFrame window, String text) {
        return ToolBar.item(window.getJMenuBar(), text);
    }

    public boolean canDo(String item) {
        JMenuItem found = item(item);
        return ask(found::isEnabled);
    }

    /** Waits until the screen shows the whole picture at 100 %. */
    public void untilShown(String what, BufferedImage expected) {
        untilShown(what, expected, 0, expected.getHeight());
    }

    /** Waits until the screen shows rows of a picture at 100 %. */
    public void untilShown(String what, BufferedImage expected, int from, int to) {
        Screen.until(what + " is on the screen", () -> {
            Rectangle place = picture().place();
            return place.width == expected.getWidth() && place.height == expected.getHeight()
                && Screen.shows(screen.capture(picture(), place), 0, 0, expected, from, to);
        });
    }

    /** Closes the window, and what the test has left open or pressed, if it failed; changes of the text are given up. */
    @Override
    public void close() {
        screen.release();
        run(() -> {
            MenuSelectionManager.defaultManager().clearSelectedPath();
            Arrays.stream(Window.getWindows()).filter(window -> window instanceof Dialog && window.isShowing()).forEach(Window::dispose);
            document().forget();
            viewer.close();
        });
        try {
            Screen.until("all threads end", () -> threads().isEmpty());
        } catch (AssertionError e) {
            StringBuilder left = new StringBuilder("threads did not end:");
            stacks().forEach((thread, stack) -> left.append(' ').append(thread.getName()).append(" at ").append(Arrays.toString(stack)));
            throw new AssertionError(left.toString(), e);
        }
        LEFT.set(0);
        Thread.setDefaultUncaughtExceptionHandler(null);
        if (!uncaught.isEmpty()) {
            throw new AssertionError("an event or a thread of the window threw", uncaught.peek());
        }
    }
}
