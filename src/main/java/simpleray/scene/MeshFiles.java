package simpleray.scene;

import java.io.IOException;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Function;
import simpleray.text.Diagnostic;
import simpleray.text.SceneFormatException;
import simpleray.text.SceneReader;

/** The OBJ files that one scene names, each read once, if it is within reach. <em>Mutable,</em> for one thread. */
final class MeshFiles {
    /** Names that Windows takes for a drive or for the root. Not compiled: that takes 5 ms, and most scenes name no file. */
    private static final String ROOTED = "(?s)/.*|[A-Za-z]:.*";

    /** Each that was read, once, under the name that the scene had for it first. */
    final List<SourceText.MeshFile> read = new ArrayList<>();

    private final Reach reach;
    private final Map<Path, TriangleMesh> meshes = new HashMap<>();     // by absolute path

    MeshFiles(Reach reach) {
        this.reach = reach;
    }

    /** {@return the files of the scene being read, only in its folder unless a reach was set before} */
    static MeshFiles of(SceneReader is) {
        return of(is, Reach.FOLDER);
    }

    /** {@return the files of a scene that is about to be read, within some reach} */
    static MeshFiles of(SceneReader is, Reach reach) {
        return is.kept(MeshFiles.class, new Function<>() {
            @Override
            public MeshFiles apply(Class<?> type) {
                return new MeshFiles(reach);
            }
        });
    }

    /**
     * Returns the triangles of the file whose name was read last; none if there is an error, which is noted.
     *
     * @param is the reader of the name
     * @param name the name
     * @throws IOException if that was one error too many, or the file breaks off
     */
    TriangleMesh load(SceneReader is, String name) throws IOException {
        TriangleMesh mesh = new TriangleMesh(Triangles.NONE);
        try {
            if (reach == Reach.FOLDER && leavesByName(name)) {
                throw new OutOfReachException();
            }
            Path path = is.resolve(name);
            if (reach == Reach.FOLDER && leaves(is.resolve(""), path)) {
                throw new OutOfReachException();
            }
            Path key = path.toAbsolutePath().normalize();
            TriangleMesh known = meshes.get(key);
            if (known != null) {
                return known;
            }
            List<Diagnostic> problems = new ArrayList<>();
            try {
                mesh = new TriangleMesh(ObjReader.read(path, problems::add,
                    digest -> read.add(new SourceText.MeshFile(name, digest))));
            } catch (SceneFormatException e) {
                problems.addAll(e.problems());
            }
            meshes.put(key, mesh);                          // with errors too: they are reported once
            for (Diagnostic problem : problems) {
                is.report(problem);
            }
        } catch (OutOfReachException e) {
            is.reject("OBJ file within the scene's folder (--allow-outside allows any)");
        } catch (FileSystemException e) {
            String reason = e.getReason() == null ? e.toString() : e.getReason();
            is.reject("OBJ file that can be read (" + Diagnostic.printable(e.getFile() + ": " + reason) + ')');
        } catch (InvalidPathException e) {
            is.reject("OBJ file that can be read (" + e.getReason() + ')');
        }
        return mesh;
    }

    /** {@return whether a name leads out of its folder on any system, so that a scene is the same everywhere} */
    private static boolean leavesByName(String name) {
        String path = name.replace('\\', '/');
        if (path.matches(ROOTED)) {
            return true;
        }
        int depth = 0;
        for (String step : path.split("/", -1)) {
            depth += step.equals("..") ? -1 : step.isEmpty() || step.equals(".") ? 0 : 1;
            if (depth < 0) {
                return true;
            }
        }
        return false;
    }

    /** {@return whether a path leads out of the folder through symbolic links} For a missing file, its folder counts. */
    private static boolean leaves(Path folder, Path path) throws IOException {
        Path home = folder.toAbsolutePath().toRealPath();
        Path there = path.toAbsolutePath();
        Path parent = there.getParent();
        while (parent != null && !Files.exists(there, LinkOption.NOFOLLOW_LINKS)) {
            there = parent;
            parent = there.getParent();
        }
        boolean dangling = parent != null && Files.isSymbolicLink(there) && !Files.exists(there);
        Path real = dangling ? parent.toRealPath().resolve(Files.readSymbolicLink(there)).normalize() : there.toRealPath();
        return !real.startsWith(home);
    }

    /** The file may not be read; the error does not reveal whether it exists. */
    private static final class OutOfReachException extends IOException {
        private static final long serialVersionUID = 1L;
    }
}
