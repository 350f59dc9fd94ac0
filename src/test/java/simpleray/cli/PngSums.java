package simpleray.cli;

import java.nio.ByteBuffer;
import java.util.zip.CRC32;

/** The checksums of a PNG file's chunks, for files whose content was changed by hand. */
final class PngSums {
    private static final int SIGNATURE = 8;
    private static final int HEAD = 8;
    private static final int SUM = 4;

    private PngSums() {
    }

    /** {@return the file with right checksums, as far as its chunks are chunks} */
    static byte[] renewed(byte[] png) {
        byte[] file = png.clone();
        ByteBuffer bytes = ByteBuffer.wrap(file);
        int at = SIGNATURE;
        while (at + HEAD + SUM <= file.length) {
            long end = at + HEAD + Integer.toUnsignedLong(bytes.getInt(at));
            if (end + SUM > file.length) {
                break;
            }
            CRC32 crc = new CRC32();
            crc.update(file, at + HEAD - SUM, (int) end - at - HEAD + SUM);
            bytes.putInt((int) end, (int) crc.getValue());
            at = (int) end + SUM;
        }
        return file;
    }
}
