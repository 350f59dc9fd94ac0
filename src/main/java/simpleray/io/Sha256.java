package simpleray.io;

import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.HexFormat;

/** The digest SHA-256 (NIST, FIPS 180-4, 2015) as the JDK computes it. */
public final class Sha256 {
    private Sha256() {
    }

    /** Has another thread load the JDK's digest, which takes 25 ms, while the one that calls does something else. */
    public static void preload() {
        Thread thread = new Thread("simpleray-sha256") {
            @Override
            public void run() {
                begin();
            }
        };
        thread.setDaemon(true);
        thread.start();
    }

    /** {@return the digest of no bytes yet} */
    public static MessageDigest begin() {
        try {
            return MessageDigest.getInstance("SHA-256");
        } catch (NoSuchAlgorithmException e) {
            throw new IllegalStateException("each Java has SHA-256", e);
        }
    }

    /**
     * Computes the digest of some bytes.
     *
     * @param bytes all of them
     * @return 64 hexadecimal digits, in lower case
     */
    public static String of(byte[] bytes) {
        return hex(begin().digest(bytes));
    }

    /**
     * Writes a digest in figures.
     *
     * @param digest its 32 bytes
     * @return 64 hexadecimal digits, in lower case
     */
    public static String hex(byte[] digest) {
        return HexFormat.of().formatHex(digest);
    }
}
