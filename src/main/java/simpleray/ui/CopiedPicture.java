package simpleray.ui;

import java.awt.datatransfer.DataFlavor;
import java.awt.datatransfer.Transferable;
import java.awt.datatransfer.UnsupportedFlavorException;
import java.awt.image.BufferedImage;
import simpleray.image.Picture;

/** A picture on its way to the clipboard. */
record CopiedPicture(BufferedImage image) implements Transferable {
    private static final int LEVEL = 0xFF;

    /** {@return the levels of a picture, all rows of which are set} */
    static CopiedPicture of(Picture picture) {
        BufferedImage image = new BufferedImage(picture.width(), picture.height(), BufferedImage.TYPE_INT_RGB);
        int[] rgb = new int[picture.width()];
        for (int y = 0; y < picture.height(); y++) {
            byte[] levels = picture.levels(y);
            for (int x = 0; x < rgb.length; x++) {
                rgb[x] = (levels[3 * x] & LEVEL) << 16 | (levels[3 * x + 1] & LEVEL) << 8 | levels[3 * x + 2] & LEVEL;
            }
            image.setRGB(0, y, rgb.length, 1, rgb, 0, rgb.length);
        }
        return new CopiedPicture(image);
    }

    @Override
    public DataFlavor[] getTransferDataFlavors() {
        return new DataFlavor[] {DataFlavor.imageFlavor};
    }

    @Override
    public boolean isDataFlavorSupported(DataFlavor flavor) {
        return DataFlavor.imageFlavor.equals(flavor);
    }

    @Override
    public BufferedImage getTransferData(DataFlavor flavor) throws UnsupportedFlavorException {
        if (!isDataFlavorSupported(flavor)) {
            throw new UnsupportedFlavorException(flavor);
        }
        return image;
    }
}
