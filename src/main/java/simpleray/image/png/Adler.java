package simpleray.image.png;

/** The checksum of a zlib stream, Adler-32 (RFC 1950, section 8.2), computed from those of its pieces. <em>Mutable.</em> */
final class Adler {
    private static final int HALF = 16;
    private static final int MASK = 0xFFFF;
    private static final long MODULUS = 65521;

    private long low = 1;                                     // 1 and the sum of all bytes
    private long high;                                        // the sum of low after each byte

    /**
     * Appends a piece. Its low half began at 1 and ours does not: each of its bytes adds the difference to the high half.
     *
     * @param sum the piece's Adler-32
     * @param length its number of bytes
     */
    void append(int sum, long length) {
        long more = low + MODULUS - 1;                        // above 0
        high = (high + (sum >>> HALF) + length % MODULUS * more) % MODULUS;
        low = (more + (sum & MASK)) % MODULUS;
    }

    /** {@return the sum of all pieces} */
    int value() {
        return (int) (high << HALF | low);
    }
}
