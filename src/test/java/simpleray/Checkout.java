package simpleray;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import simpleray.cli.Program;

/** A checkout whose jar is there and up to date, as far as the script {@code simpleray} needs it. */
final class Checkout {
    private static final String JAVA_HOME = System.getProperty("java.home");

    final Path root;
    final Path jar;

    /** Makes a checkout in a folder that is not there yet. */
    Checkout(Path root) throws IOException {
        this.root = root;
        Files.createDirectories(root.resolve("src/main"));
        for (String file : List.of("simpleray", "gradle/setup.sh", "scenes/thesis-as-printed.scene", "build.gradle", "settings.gradle")) {
            Files.createDirectories(root.resolve(file).getParent());
            Files.copy(Project.root().resolve(file), root.resolve(file));
        }
        jar = root.resolve("build/libs/simpleray.jar");
        Files.createDirectories(jar.getParent());
        Files.copy(Project.jar(), jar);                       // the last one, so that it is up to date
    }

    /** {@return the result of the script with options for the virtual machine} */
    Program.Result run(String options, String... args) throws IOException, InterruptedException {
        return run(root.resolve("simpleray"), options, args);
    }

    /** {@return the result of the script by another name} */
    Program.Result run(Path script, String options, String... args) throws IOException, InterruptedException {
        return Program.finish(script(script, options, args).start(), new byte[0]);
    }

    /** {@return the script, ready to start beside the checkout, with some variables} */
    ProcessBuilder with(Map<String, String> environment, String... args) {
        ProcessBuilder builder = script(root.resolve("simpleray"), "", args);
        builder.environment().putAll(environment);
        return builder;
    }

    private ProcessBuilder script(Path script, String options, String... args) {
        List<String> line = new ArrayList<>(List.of("/bin/sh", script.toString()));
        line.addAll(List.of(args));
        ProcessBuilder builder = new ProcessBuilder(line).directory(root.getParent().toFile());
        builder.environment().keySet().removeAll(
            List.of("DISPLAY", "WAYLAND_DISPLAY", "JAVA_TOOL_OPTIONS", "_JAVA_OPTIONS", "JDK_JAVA_OPTIONS", "SIMPLERAY_INSTALL"));
        builder.environment().put("JAVA_HOME", JAVA_HOME);
        builder.environment().put("SIMPLERAY_OPTS", options);
        return builder;
    }
}
