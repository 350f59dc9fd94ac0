package simpleray.scene;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import simpleray.Project;
import simpleray.image.png.PictureFormatException;
import simpleray.text.Diagnostic;
import simpleray.text.SceneFormatException;

/**
 * Scenes and OBJ files that are wrong, or odd, each in the way that its name says. Beside each lies what a user is to read about it; of a
 * file that is accepted, what it holds.
 */
final class HostileFiles {
    private HostileFiles() {
    }

    /**
     * Writes what is said of each file now. Whoever runs it reads the differences before they are kept.
     *
     * @param args not used
     * @throws IOException if a file cannot be read or written
     */
    public static void main(String[] args) throws IOException {
        for (Path file : all()) {
            Files.writeString(expected(file), outcome(file).replace(Kinds.objects(), Kinds.OBJECTS).replace(Kinds.lights(), Kinds.LIGHTS));
        }
    }

    /** {@return the files, in order} */
    static List<Path> all() {
        List<Path> all = new ArrayList<>();
        Path folder = Project.root().resolve("src/test/resources/hostile");
        Project.names(folder.resolve("scenes"), ".scene").forEach(name -> all.add(folder.resolve("scenes").resolve(name + ".scene")));
        Project.names(folder.resolve("objs"), ".obj").forEach(name -> all.add(folder.resolve("objs").resolve(name + ".obj")));
        return all;
    }

    /** {@return where it is written what is to be said of a file} */
    static Path expected(Path file) {
        String name = file.getFileName().toString();
        return file.resolveSibling(name.substring(0, name.lastIndexOf('.')) + ".expected");
    }

    /** {@return what is said of a file, without the folder} */
    static String outcome(Path file) throws IOException {
        List<Diagnostic> warnings = new ArrayList<>();
        String result;
        try {
            result = file.toString().endsWith(".obj") ? "accepted: " + ObjReader.read(file, warnings::add).count() + " triangles"
                : scene(SceneFile.read(file), warnings);
        } catch (SceneFormatException | PictureFormatException e) {
            result = e.getMessage();
        }
        StringBuilder all = new StringBuilder(result).append('\n');
        warnings.forEach(warning -> all.append(warning).append('\n'));
        return all.toString().replace(file.getParent() + "/", "");
    }

    private static String scene(SceneFile file, List<Diagnostic> warnings) {
        warnings.addAll(file.warnings());
        return "accepted: " + ObjectKind.TABLE.counted(file.scene().getNumberObjects()) + ", "
            + LightKind.TABLE.counted(file.scene().getNumberLights());
    }

    /** {@return what is to be said of a file} */
    static String told(Path file) throws IOException {
        return Files.readString(expected(file), StandardCharsets.UTF_8).replace(Kinds.OBJECTS, Kinds.objects())
            .replace(Kinds.LIGHTS, Kinds.lights());
    }
}
