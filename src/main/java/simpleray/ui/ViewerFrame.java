package simpleray.ui;

import java.awt.BorderLayout;
import java.awt.Dimension;
import java.awt.Font;
import java.awt.event.WindowAdapter;
import java.awt.event.WindowEvent;
import java.io.File;
import javax.swing.JFrame;
import javax.swing.JScrollPane;
import javax.swing.JSplitPane;
import javax.swing.JTextArea;
import simpleray.render.RenderRequest;
import simpleray.render.Stage;

/** The window: menus, the picture, problems of the scene if there are any, and a status bar. For the event thread, but for await. */
final class ViewerFrame extends JFrame {
    private static final long serialVersionUID = 1L;
    private static final Dimension LEAST = new Dimension(760, 560);
    private static final int DIVIDER = 6;
    private static final int MOST_PROBLEM_LINES = 6;

    private final transient SimpleRay picture;
    private final JTextArea problems = new JTextArea();
    private final JSplitPane split;
    private final StatusBar status = new StatusBar();
    private final transient PictureDialogs dialogs = new PictureDialogs(this);
    private final transient ViewerMenus menus;
    private final transient Runnable closed;

    ViewerFrame(SceneSource source, RenderRequest request, Runnable closed) {
        this.closed = closed;
        picture = new SimpleRay(source, request);
        problems.setName("problems");
        problems.getAccessibleContext().setAccessibleName("Problems of the scene");
        problems.setEditable(false);
        problems.setFont(new Font(Font.MONOSPACED, Font.PLAIN, problems.getFont().getSize()));
        split = new JSplitPane(JSplitPane.VERTICAL_SPLIT, new JScrollPane(picture), null);
        split.setResizeWeight(1);
        split.setDividerSize(0);                              // until there are problems to show
        menus = new ViewerMenus(this, dialogs);
        setJMenuBar(menus.bar());
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
        pack();
        Dimension screen = getToolkit().getScreenSize();
        setMinimumSize(new Dimension(320, 240));
        setSize(Math.min(screen.width, Math.max(LEAST.width, getWidth())), Math.min(screen.height, Math.max(LEAST.height, getHeight())));
        validate();                                           // problems that are known at once find how high the window is
        setLocationByPlatform(true);
        open(source);
    }

    SimpleRay picture() {
        return picture;
    }

    /** Shows another scene. The picture of the one before stays until a first row is finished: the other may have errors. */
    void open(SceneSource source) {
        picture.setSource(source);
        setTitle(source.name().isEmpty() ? "SimpleRay" : new File(source.name()).getName() + " - SimpleRay");
        if (source == SceneSource.NONE) {
            status.say("Open a scene file: File > Open\u2026");
            refreshMenus();
        } else {
            picture.start();
        }
    }

    /** Makes another picture of the scene. */
    void setStage(Stage stage) {
        picture.setRequest(picture.request().with(stage));
        render();
    }

    /** Reads the scene again and renders it. */
    void render() {
        if (picture.source() != SceneSource.NONE) {
            picture.start();
        }
    }

    void say(String message) {
        status.say(message);
    }

    /** Closes the window and ends its threads. */
    void close() {
        picture.stop();
        dialogs.close();
        dispose();
        closed.run();
    }

    /** Waits until the threads of the window have ended. */
    void await() throws InterruptedException {
        Rendering rendering = picture.rendering();
        if (rendering != null) {
            rendering.await();
        }
        dialogs.await();
    }

    private void refresh() {
        Rendering rendering = picture.rendering();
        status.show(rendering, picture.size100());
        if (rendering.state() != Rendering.State.READING) {
            showProblems(rendering.problems());
        }
        refreshMenus();
    }

    private void refreshMenus() {
        menus.refresh(picture.isBusy(), picture.whole() != null && !picture.isBusy(), picture.source() != SceneSource.NONE);
    }

    private void showProblems(String text) {
        if (text.equals(problems.getText())) {
            return;
        }
        problems.setText(text);
        problems.setCaretPosition(0);
        problems.setRows(Math.min(MOST_PROBLEM_LINES, problems.getLineCount() + 1));   // one for a scroll bar
        JScrollPane pane = text.isEmpty() ? null : new JScrollPane(problems);
        split.setBottomComponent(pane);
        split.setDividerSize(pane == null ? 0 : DIVIDER);
        if (pane != null) {
            split.setDividerLocation(split.getHeight() - split.getDividerSize() - pane.getPreferredSize().height);
        }
    }
}
