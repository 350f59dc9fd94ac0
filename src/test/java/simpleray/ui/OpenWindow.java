package simpleray.ui;

import com.formdev.flatlaf.FlatLightLaf;
import java.awt.Component;
import java.awt.Container;
import java.awt.Rectangle;
import java.awt.Window;
import java.awt.image.BufferedImage;
import java.util.Arrays;
import java.util.List;
import java.util.Queue;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.FutureTask;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.Consumer;
import java.util.function.Predicate;
import java.util.function.Supplier;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import javax.swing.JLabel;
import javax.swing.JMenuItem;
import javax.swing.JScrollPane;
import javax.swing.SwingUtilities;
import javax.swing.text.JTextComponent;
import simpleray.render.RenderRequest;
import simpleray.render.Stage;
import simpleray.scene.SceneSettings;

/** A window for a test. All methods are for the test's thread unless they say otherwise. */
final class OpenWindow implements AutoCloseable {
    final Screen screen = new Screen();
    final ViewerFrame frame;
    final AtomicBoolean closed = new AtomicBoolean();
    private final Queue<Throwable> uncaught = new ConcurrentLinkedQueue<>();

    /** Shows a window, and waits until it has the keys. */
    OpenWindow(SceneSource source, int width, int height) {
        this(source, width, height, made -> { });
    }

    /** Does something with the window, shows it, and waits until it has the keys. */
    OpenWindow(SceneSource source, int width, int height, Consumer<ViewerFrame> first) {
        Thread.setDefaultUncaughtExceptionHandler((thread, thrown) -> {      // of one window at a time
            thrown.printStackTrace();
            if (Arrays.stream(thrown.getStackTrace()).map(StackTraceElement::getClassName)
                .takeWhile(name -> !name.equals("java.awt.EventDispatchThread")).anyMatch(name -> name.startsWith("simpleray."))) {
                uncaught.add(thrown);
            }
        });
        frame = ask(() -> {
            FlatLightLaf.setup();
            ViewerFrame made = new ViewerFrame(source, request(width, height), () -> closed.set(true));
            first.accept(made);
            made.setVisible(true);
            made.toFront();
            return made;
        });
        Screen.until("the window has the keys", () -> frame.isFocused() && frame.getFocusOwner() != null);
    }

    /** {@return a request for a picture of that size, with nothing else asked for} */
    static RenderRequest request(int width, int height) {
        SceneSettings settings = new SceneSettings();
        settings.resolution = new SceneSettings.Resolution(width, height);
        return new RenderRequest(settings, Stage.FINAL, false, Runtime.getRuntime().availableProcessors());
    }

    /** {@return what the event thread answers} */
    static <T> T ask(Supplier<T> question) {
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
    static void run(Runnable task) {
        ask(() -> {
            task.run();
            return null;
        });
    }

    /** Has the event thread do something that may take as long as a dialog is open. */
    static void later(Runnable task) {
        SwingUtilities.invokeLater(task);
    }

    /** {@return the component and all that it contains} For the event thread. */
    static Stream<Component> all(Component top) {
        Stream<Component> parts = top instanceof Container c ? Arrays.stream(c.getComponents()).flatMap(OpenWindow::all) : Stream.empty();
        return Stream.concat(Stream.of(top), parts);
    }

    /** {@return the first component of a type that can be seen and is as wanted, in any window; null for none} For the event thread. */
    static <T extends Component> T seen(Class<T> type, Predicate<T> wanted) {
        return Arrays.stream(Window.getWindows()).filter(Component::isShowing).flatMap(OpenWindow::all)
            .filter(c -> type.isInstance(c) && c.isShowing()).map(type::cast).filter(wanted).findFirst().orElse(null);
    }

    /** {@return a component that is to appear} */
    static <T extends Component> T appears(String what, Class<T> type, Predicate<T> wanted) {
        AtomicReference<T> found = new AtomicReference<>();
        Screen.until(what + " appears", () -> {
            found.set(seen(type, wanted));
            return found.get() != null;
        });
        return found.get();
    }

    /** {@return the threads of all windows that have not ended} */
    static List<String> threads() {
        return Thread.getAllStackTraces().keySet().stream().map(Thread::getName).filter(name -> name.startsWith("simpleray-"))
            .sorted().collect(Collectors.toList());
    }

    SimpleRay picture() {
        return frame.picture();
    }

    RenderJob job() {
        return ask(() -> picture().job());
    }

    void untilState(RenderJob.State state) {
        Screen.until("the rendering is " + state, () -> picture().job().state() == state && !picture().isBusy());
    }

    /** {@return the text of a label of the status bar} */
    String label(String name) {
        return ask(() -> all(frame).filter(c -> name.equals(c.getName())).map(c -> ((JLabel) c).getText()).findFirst()
            .orElseThrow());
    }

    String status() {
        return label("status");
    }

    /** {@return the problems that are shown; null if there is no such pane} */
    JTextComponent problems() {
        return ask(() -> seen(JTextComponent.class, c -> "problems".equals(c.getName())));
    }

    /** Waits until problems are shown that have a text among them: a file may be read while only a part of it is written. */
    void untilProblems(String text) {
        Screen.until("the problems are shown", () -> problems() != null && problems().getText().contains(text));
    }

    JScrollPane scroll() {
        return ask(() -> (JScrollPane) SwingUtilities.getAncestorOfClass(JScrollPane.class, picture()));
    }

    /** {@return an item of a menu, whether its menu is open or not} */
    JMenuItem item(String text) {
        return ask(() -> Arrays.stream(frame.getJMenuBar().getSubElements()).flatMap(menu -> Arrays.stream(menu.getSubElements()))
            .flatMap(popup -> Arrays.stream(popup.getSubElements())).map(e -> (JMenuItem) e.getComponent())
            .filter(item -> item.getText().equals(text)).findFirst().orElseThrow());
    }

    boolean canDo(String item) {
        JMenuItem found = item(item);
        return ask(found::isEnabled);
    }

    /** Waits until the screen shows the whole picture at 100 %. */
    void untilShown(String what, BufferedImage expected) {
        untilShown(what, expected, 0, expected.getHeight());
    }

    /** Waits until the screen shows rows of a picture at 100 %. */
    void untilShown(String what, BufferedImage expected, int from, int to) {
        Screen.until(what + " is on the screen", () -> {
            Rectangle place = picture().place();
            return place.width == expected.getWidth() && place.height == expected.getHeight()
                && Screen.shows(screen.capture(picture(), place), 0, 0, expected, from, to);
        });
    }

    @Override
    public void close() {
        run(frame::close);
        Screen.until("all threads end", () -> threads().isEmpty());
        Thread.setDefaultUncaughtExceptionHandler(null);
        if (!uncaught.isEmpty()) {
            throw new AssertionError("an event or a thread of the window threw", uncaught.peek());
        }
    }
}
