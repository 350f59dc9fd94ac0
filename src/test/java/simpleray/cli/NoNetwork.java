package simpleray.cli;

import java.net.InetAddress;
import java.security.Permission;

/**
 * Lets a program do all but use the network, look up a name or start a process: then it ends at once, whatever the program would make of an
 * exception. For {@code -Djava.security.manager}, up to Java 23.
 */
@SuppressWarnings("removal")
public final class NoNetwork extends SecurityManager {
    /** The exit code of a program that was ended; none of the program's own. */
    static final int REFUSED = 99;

    /** In place of a port: a name is looked up. */
    private static final int NAME = -1;

    /** For the virtual machine. */
    public NoNetwork() {
    }

    /** {@return whether Java asks for this machine's own name, after which it calls a file in which it notes the system's fonts} */
    private static boolean isJavaLookingForFonts() {
        return StackWalker.getInstance().walk(frames -> frames.map(StackWalker.StackFrame::getClassName)
            .anyMatch("sun.font.FcFontConfiguration"::equals));
    }

    private static void refuse(String what) {
        new Throwable("refused: " + what).printStackTrace();       // who asked for it
        Runtime.getRuntime().halt(REFUSED);
    }

    @Override
    public void checkPermission(Permission permission) {
        // all else is allowed
    }

    @Override
    public void checkPermission(Permission permission, Object context) {
        // all else is allowed
    }

    @Override
    public void checkConnect(String host, int port) {
        if (port != NAME || !isJavaLookingForFonts()) {
            refuse("connect " + port);
        }
    }

    @Override
    public void checkConnect(String host, int port, Object context) {
        refuse("connect " + port);
    }

    @Override
    public void checkListen(int port) {
        refuse("listen");
    }

    @Override
    public void checkAccept(String host, int port) {
        refuse("accept");
    }

    @Override
    public void checkMulticast(InetAddress group) {
        refuse("multicast");
    }

    @Override
    public void checkExec(String command) {
        refuse("exec");
    }
}
