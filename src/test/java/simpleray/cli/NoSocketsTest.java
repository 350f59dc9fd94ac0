package simpleray.cli;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.File;
import java.io.IOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.URISyntaxException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import simpleray.Project;

/**
 * The program with networking refused, by all means that this machine has: Java's security manager (up to Java 23), which ends it at once; a
 * network namespace without interfaces; and a list of the system calls. Each of them is tried on a program that does use the network.
 */
class NoSocketsTest {
    private static final int LAST_WITH_MANAGER = 23;
    /** What is done with a socket that has an address: what only asks whether there are such sockets, as Java does, is not among it. */
    private static final Pattern USE = Pattern.compile("\\b(connect|bind|listen|accept4?)\\(|sa_family=AF_(?!UNIX)");
    /** The window's display, and whom the C library asks for the user's name. */
    private static final Pattern LOCAL = Pattern.compile("sa_family=AF_UNIX, sun_path=@?\"(/tmp/\\.X11-unix/X\\d+|/var/run/nscd/socket"
        + "|/run/systemd/[\\w./]+|/var/lib/sss/pipes/\\w+)\"");

    /** A question to a name server: where this machine's own name does not stand in /etc/hosts, Java's fonts have it asked for. */
    private static final Pattern NAME = Pattern.compile("sa_family=AF_INET6?, sin6?_port=htons\\(53\\)");
    private static final List<String> MANAGER = List.of("-Djava.security.manager=" + NoNetwork.class.getName());

    @TempDir
    Path folder;

    private static boolean hasManager() {
        return Runtime.version().feature() <= LAST_WITH_MANAGER;
    }

    private boolean works(String... command) throws InterruptedException {
        try {
            return Program.finish(new ProcessBuilder(command).directory(folder.toFile()).start(), new byte[0]).exitCode() == 0;
        } catch (IOException e) {                             // there is no such command
            return false;
        }
    }

    private boolean hasNamespaces() throws InterruptedException {
        return works("unshare", "-rn", "true");
    }

    private boolean hasTrace() throws InterruptedException {
        return works("strace", "-f", "-e", "trace=%network", "-o", "try", "true");
    }

    private static ProcessBuilder java(Path folder, List<String> before, List<String> options, String main, String... args) {
        ProcessBuilder builder = Program.java(Path.of(System.getProperty("java.home")), folder, options);
        List<String> line = new ArrayList<>(before);
        line.addAll(builder.command());
        line.addAll(List.of("-cp", Project.jar() + File.pathSeparator + tests(), main));
        line.addAll(List.of(args));
        return builder.command(line);
    }

    private static String tests() {
        try {
            return Path.of(NoNetwork.class.getProtectionDomain().getCodeSource().getLocation().toURI()).toString();
        } catch (URISyntaxException e) {
            throw new IllegalStateException(e);
        }
    }

    @BeforeEach
    void writeScene() throws IOException {
        Files.copy(Project.scene("thesis"), folder.resolve("a.scene"));
    }

    @Test
    void noCommandUsesTheNetwork() throws Exception {
        assertSilent(false, "render", "a.scene", "-o", "a.png", "--size", "20x20");
        assertSilent(false, "verify", "a.png");
        assertSilent(false, "compare", "a.png", "a.png");
        assertSilent(false, "check", "a.scene");
        assertSilent(false, "print", "a.scene");
        assertSilent(false, "explain", "a.scene", "--pixel", "3,4");
    }

    @Test
    void theWindowAsksItsDisplayAndNobodyElse() throws Exception {
        assumeTrue(System.getenv("DISPLAY") != null, "no display");
        assertSilent(true, "view", "a.scene", "--size", "20x20");
    }

    private void assertSilent(boolean window, String... args) throws Exception {
        boolean traced = hasTrace();
        boolean apart = hasNamespaces();
        assumeTrue(traced || apart || hasManager(), "no way to refuse networking here");
        Path trace = folder.resolve("trace");
        List<String> before = new ArrayList<>();
        if (traced) {
            before.addAll(List.of("strace", "-f", "-e", "trace=%network", "-o", trace.toString()));
        }
        if (apart) {
            before.addAll(List.of("unshare", "-rn"));
        }
        List<String> options = new ArrayList<>(hasManager() ? MANAGER : List.of());
        options.add("-Dsimpleray.rehearsal=true");            // a window closes when its picture is there
        ProcessBuilder program = java(folder, before, options, Main.class.getName(), args);
        if (window) {
            program.environment().put("DISPLAY", System.getenv("DISPLAY"));
            program.environment().put("GTK_THEME", "Adwaita");   // else the desktop's own program is asked for it
        }

        Program.Result result = Program.finish(program.start(), new byte[0]);

        assertThat(result.err()).as(args[0]).doesNotContain("refused");
        assertThat(result.exitCode()).as("%s: %s", args[0], result.err()).isZero();
        if (traced) {
            assertThat(foreign(trace)).as(args[0]).allMatch(call -> window && NAME.matcher(call).find());
        }
    }

    /** {@return the system calls that use a socket which is not one of this machine's own, that it may} */
    private static List<String> foreign(Path trace) throws IOException {
        try (Stream<String> calls = Files.lines(trace, StandardCharsets.ISO_8859_1)) {
            return calls.filter(call -> USE.matcher(call).find() && !LOCAL.matcher(call).find()).collect(Collectors.toList());
        }
    }

    @ParameterizedTest
    @ValueSource(strings = {"socket", "channel", "listen", "datagram", "name", "process"})
    void theManagerWouldEndAProgramThatUsesTheNetwork(String how) throws Exception {
        assumeTrue(hasManager(), "no security manager since Java 24");

        Program.Result result = probe(List.of(), MANAGER, how);

        assertThat(result.err()).contains("refused: ");
        assertThat(result.exitCode()).isEqualTo(NoNetwork.REFUSED);
    }

    @Test
    void theNamespaceWouldRefuseAConnection() throws Exception {
        assumeTrue(hasNamespaces(), "no network namespaces here");

        assertThat(probe(List.of(), List.of(), "socket").exitCode()).isZero();
        assertThat(probe(List.of("unshare", "-rn"), List.of(), "socket").exitCode()).isEqualTo(1);
    }

    @ParameterizedTest
    @ValueSource(strings = {"socket", "channel", "listen", "datagram"})
    void theListOfSystemCallsWouldShowAConnection(String how) throws Exception {
        assumeTrue(hasTrace(), "no strace here");
        Path trace = folder.resolve("trace");

        assertThat(probe(List.of("strace", "-f", "-e", "trace=%network", "-o", trace.toString()), List.of(), how).exitCode()).isZero();
        assertThat(foreign(trace)).isNotEmpty();
    }

    private Program.Result probe(List<String> before, List<String> options, String how) throws Exception {
        try (ServerSocket listening = new ServerSocket(0, 1, InetAddress.getLoopbackAddress())) {
            return Program.finish(java(folder, before, options, NetworkProbe.class.getName(), how, "" + listening.getLocalPort()).start(),
                new byte[0]);
        }
    }
}
