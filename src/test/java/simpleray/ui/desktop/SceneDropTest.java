package simpleray.ui.desktop;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Point;
import java.awt.Robot;
import java.awt.datatransfer.DataFlavor;
import java.awt.datatransfer.Transferable;
import java.awt.datatransfer.UnsupportedFlavorException;
import java.awt.dnd.DnDConstants;
import java.awt.dnd.DragSource;
import java.awt.dnd.DragSourceAdapter;
import java.awt.dnd.DragSourceDragEvent;
import java.awt.dnd.DragSourceDropEvent;
import java.awt.event.InputEvent;
import java.io.File;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.atomic.AtomicBoolean;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JWindow;
import javax.swing.TransferHandler;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.io.TempDir;
import simpleray.ui.OpenWindow;
import simpleray.ui.Screen;
import simpleray.ui.TestScenes;
import simpleray.ui.WindowTest;
import simpleray.ui.file.SceneSource;
import simpleray.ui.picture.RenderJob;

/** Files dropped on the window. */
class SceneDropTest {
    private static final int SIDE = 64;

    @TempDir
    private Path folder;
    private OpenWindow window;

    @BeforeEach
    void open() {
        window = new OpenWindow(SceneSource.file(TestScenes.THESIS), SIDE, SIDE);
        window.untilState(RenderJob.State.FINISHED);
    }

    @AfterEach
    void close() {
        window.close();
    }

    @WindowTest
    void aSceneDraggedFromAnotherWindowIsOpened() throws Exception {
        Path blue = TestScenes.plain(folder.resolve("blue.scene"), 0, 0, 1);
        drag(blue.toFile());

        window.untilShown("the dropped scene", TestScenes.rendered(blue, SIDE, SIDE));
        assertThat(OpenWindow.ask(window.frame::getTitle)).isEqualTo("blue.scene - SimpleRay");
    }

    @WindowTest
    void ofSeveralFilesTheFirstIsOpened() {
        Path blue = TestScenes.plain(folder.resolve("blue.scene"), 0, 0, 1);

        assertThat(drop(new Files(List.of(blue.toFile(), folder.toFile())))).isTrue();
        window.untilShown("the dropped scene", TestScenes.rendered(blue, SIDE, SIDE));
    }

    @WindowTest
    void aFolderIsNotOpened() {
        assertThat(drop(new Files(List.of(folder.toFile())))).isFalse();
        assertThat(window.status()).isEqualTo(folder.getFileName() + " is a folder: drop a scene file");
    }

    private boolean drop(Files files) {
        return OpenWindow.ask(() -> window.frame.getTransferHandler()
            .importData(new TransferHandler.TransferSupport((JComponent) window.frame.getContentPane(), files)));
    }

    /** Drags a file with the mouse from a window of another program's kind into the middle of the picture. */
    private void drag(File file) throws Exception {
        Robot robot = new Robot();
        AtomicBoolean over = new AtomicBoolean();
        AtomicBoolean dropped = new AtomicBoolean();
        DragSource source = DragSource.getDefaultDragSource();
        JLabel label = new JLabel("drag me");
        JWindow other = OpenWindow.ask(() -> {
            source.createDefaultDragGestureRecognizer(label, DnDConstants.ACTION_COPY,
                gesture -> source.startDrag(gesture, null, new Files(List.of(file)), new DragSourceAdapter() {
                    @Override
                    public void dragOver(DragSourceDragEvent e) {
                        over.set(e.getDropAction() == DnDConstants.ACTION_COPY);
                    }

                    @Override
                    public void dragDropEnd(DragSourceDropEvent e) {
                        dropped.set(true);
                    }
                }));
            JWindow made = new JWindow();
            made.add(label);
            made.setBounds(1000, 850, 120, 80);
            made.setAlwaysOnTop(true);
            made.setVisible(true);
            return made;
        });
        try {
            Screen.until("the other window is there", label::isShowing);
            Point from = OpenWindow.ask(label::getLocationOnScreen);
            Point to = OpenWindow.ask(window.picture()::getLocationOnScreen);
            robot.mouseMove(from.x + 20, from.y + 20);
            robot.mousePress(InputEvent.BUTTON1_DOWN_MASK);
            int[] step = {0};
            // a drag begins some pixels from where the button went down, and is told where it is whenever it moves
            Screen.until("the window would take it", () -> {
                step[0]++;
                if (step[0] < 10) {
                    robot.mouseMove(from.x + 20 + 2 * step[0], from.y + 20);
                } else {
                    robot.mouseMove(to.x + 30 + step[0] % 7, to.y + 30);
                }
                return over.get();
            });
            robot.mouseRelease(InputEvent.BUTTON1_DOWN_MASK);
            Screen.until("it is dropped", dropped::get);
        } finally {
            OpenWindow.run(other::dispose);
        }
    }

    /** Files as another program gives them. */
    private record Files(List<File> files) implements Transferable {
        @Override
        public DataFlavor[] getTransferDataFlavors() {
            return new DataFlavor[] {DataFlavor.javaFileListFlavor};
        }

        @Override
        public boolean isDataFlavorSupported(DataFlavor flavor) {
            return DataFlavor.javaFileListFlavor.equals(flavor);
        }

        @Override
        public List<File> getTransferData(DataFlavor flavor) throws UnsupportedFlavorException {
            return files;
        }
    }
}
