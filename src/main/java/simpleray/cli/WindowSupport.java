package simpleray.cli;

import java.nio.file.Files;
import java.nio.file.Path;
import simpleray.ui.Viewer;

/** Whether this Java, on this machine, can open windows. */
final class WindowSupport {
    /** What to do about a Java without some part of java.desktop. */
    static final String INSTALL = "install openjdk-" + Runtime.version().feature() + "-jre";

    private WindowSupport() {
    }

    /** {@return whether there are any of Java's classes for windows and pictures} */
    static boolean hasModule() {
        return ModuleLayer.boot().findModule("java.desktop").isPresent();
    }

    /** {@return why no window can be opened; null if one can} */
    static String fault() {
        if (!hasModule() || lacksX11()) {
            return "this Java can open no windows: " + INSTALL;
        }
        try {
            return Viewer.hasDisplay() ? null : "there is no display for a window";
        } catch (LinkageError e) {                            // the system lacks a library that X11's part needs
            return "this Java can open no windows: " + e.getMessage();
        }
    }

    /** {@return whether this is a headless Java, as in Debian's package openjdk-17-jre-headless} */
    private static boolean lacksX11() {
        return System.getProperty("os.name").equals("Linux")
            && !Files.exists(Path.of(System.getProperty("java.home"), "lib", "libawt_xawt.so"));
    }
}
