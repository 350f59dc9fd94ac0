package simpleray.ui.desktop;

import java.awt.datatransfer.DataFlavor;
import java.awt.datatransfer.UnsupportedFlavorException;
import java.io.File;
import java.io.IOException;
import java.util.List;
import javax.swing.TransferHandler;
import simpleray.ui.file.SceneSource;
import simpleray.ui.picture.ViewerContext;

/** Opens a scene's file that is dropped on the window. */
final class SceneDrop extends TransferHandler {
    private static final long serialVersionUID = 1L;

    private final transient ViewerContext window;

    SceneDrop(ViewerContext window) {
        this.window = window;
    }

    @Override
    public boolean canImport(TransferSupport support) {
        if (!support.isDataFlavorSupported(DataFlavor.javaFileListFlavor)) {
            return false;
        }
        if (support.isDrop() && (support.getSourceDropActions() & COPY) != 0) {
            support.setDropAction(COPY);                      // else the other program might take its file away
        }
        return true;
    }

    @Override
    public boolean importData(TransferSupport support) {
        try {
            List<?> files = (List<?>) support.getTransferable().getTransferData(DataFlavor.javaFileListFlavor);
            if (files.isEmpty()) {
                return false;
            }
            File first = (File) files.get(0);
            if (first.isDirectory()) {
                window.say(first.getName() + " is a folder: drop a scene file");
                return false;
            }
            window.open(SceneSource.file(first.toPath()));
            if (files.size() > 1) {
                window.say("Opened the first of " + files.size() + " files: " + first.getName());
            }
            return true;
        } catch (UnsupportedFlavorException | IOException e) {
            window.say("What was dropped cannot be read: " + e.getMessage());
            return false;
        }
    }
}
