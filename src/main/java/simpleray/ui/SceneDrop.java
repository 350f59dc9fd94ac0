package simpleray.ui;

import java.awt.datatransfer.DataFlavor;
import java.awt.datatransfer.UnsupportedFlavorException;
import java.io.File;
import java.io.IOException;
import java.util.List;
import javax.swing.TransferHandler;

/** Opens a scene's file that is dropped on the window. */
final class SceneDrop extends TransferHandler {
    private static final long serialVersionUID = 1L;

    private final transient ViewerFrame frame;

    SceneDrop(ViewerFrame frame) {
        this.frame = frame;
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
                frame.say(first.getName() + " is a folder: drop a scene file");
                return false;
            }
            frame.open(SceneSource.file(first.toPath()));
            if (files.size() > 1) {
                frame.say("Opened the first of " + files.size() + " files: " + first.getName());
            }
            return true;
        } catch (UnsupportedFlavorException | IOException e) {
            frame.say("What was dropped cannot be read: " + e.getMessage());
            return false;
        }
    }
}
