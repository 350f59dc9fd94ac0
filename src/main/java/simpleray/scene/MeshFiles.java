package simpleray.scene;

import java.io.IOException;
import java.nio.file.AccessDeniedException;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.LinkOption;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.security.DigestInputStream;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Set;
import java.util.function.Function;
import simpleray.io.Sha256;
import simpleray.text.Diagnostic;
import simpleray.text.SceneFormatException;
import simpleray.text.SceneReader;

/** The OBJ files that one scene names, and their MTL files, each read once, if it is within reach. <em>Mutable,</em> for one thread. */
final class MeshFiles {
    /** Names that Windows takes for a drive or for the root. Not compiled: that takes 5 ms, and most scenes name no file. */
    private static final String ROOTED = "(?s)/.*|[A-Za-z]:.*";

    /** Each that was read, once, under the name that the scene had for it first. */
    final List<SourceText.MeshFile> read = new ArrayList<>();

    private final Reach reach;
    private final Map<Path, TriangleMesh> meshes = new HashMap<>();     // by absolute path
    private final Map<Path, List<MtlMaterial>> libraries = new HashMap<>();
    private final Map<Path, SceneFormatException> unreadable = new HashMap<>();     // of libraries that are no text
    private final Map<TriangleMesh, MtlMaterial[]> materials = new HashMap<>();
    private final Set<SceneFormatException> reported = new HashSet<>();

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
            Path path = path(is, name);
            Path key = path.toAbsolutePath().normalize();
            TriangleMesh known = meshes.get(key);
            if (known != null) {
                return known;
            }
            List<Diagnostic> problems = new ArrayList<>();
            List<Diagnostic> error = List.of();
            try {
                mesh = new TriangleMesh(ObjReader.read(path, problems::add,
                    digest -> read.add(new SourceText.MeshFile(name, digest))), path);
            } catch (SceneFormatException e) {
                error = e.problems();
            }
            meshes.put(key, mesh);                          // with errors too: they are reported once
            for (Diagnostic problem : problems) {
                is.report(problem);
            }
            is.report(error);
        } catch (OutOfReachException e) {
            is.reject("OBJ file within the scene's folder (--allow-outside allows any)");
        } catch (FileSystemException e) {
            is.reject("OBJ file that can be read (" + Diagnostic.printable(e.getFile() + ": " + reason(e)) + ')');
        } catch (InvalidPathException e) {
            is.reject("OBJ file that can be read (" + e.getReason() + ')');
        }
        return mesh;
    }

    /** {@return the path of a file that may be read, whether it is there or not} */
    private Path path(SceneReader is, String name) throws IOException {
        if (reach == Reach.FOLDER && leavesByName(name)) {
            throw new OutOfReachException();
        }
        Path path = is.resolve(name);
        if (reach == Reach.FOLDER && leaves(is.resolve(""), path)) {
            throw new OutOfReachException();
        }
        return path;
    }

    /**
     * Opens a file that a scene names, and computes its SHA-256 as it is read.
     *
     * @param path the file
     * @throws FileSystemException if it cannot be opened, with a readable reason
     * @throws IOException if it cannot be read
     */
    static DigestInputStream open(Path path) throws IOException {
        if (Files.isDirectory(path)) {
            throw new FileSystemException(path.toString(), null, "is a folder");
        }
        if (Files.exists(path) && !Files.isRegularFile(path)) {   // a pipe or a device may never end
            throw new FileSystemException(path.toString(), null, "is no regular file");
        }
        try {
            return new DigestInputStream(Files.newInputStream(path), Sha256.begin());
        } catch (NoSuchFileException | AccessDeniedException e) {
            String reason = e instanceof NoSuchFileException ? "no such file" : "may not be read";
            throw (IOException) new FileSystemException(path.toString(), null, reason).initCause(e);
        }
    }

    /**
     * Returns the materials that an OBJ's MTL files give its triangles; what is wrong with them is noted.
     *
     * @param is the reader of the scene
     * @param obj the OBJ's name
     * @param mesh its triangles
     * @param own the mesh's own material
     * @throws IOException if that was one error too many, or a file breaks off
     */
    MeshMaterials materials(SceneReader is, String obj, TriangleMesh mesh, Material own) throws IOException {
        MaterialRuns runs = mesh.triangles.materials();
        MtlMaterial[] found = materials.get(mesh);
        if (found == null) {
            List<Diagnostic> problems = new ArrayList<>();
            found = find(is, obj, mesh, problems);
            materials.put(mesh, found);
            for (Diagnostic problem : problems) {
                is.report(problem);
            }
        }
        Material[] made = new Material[found.length];
        for (int i = 0; i < found.length; i++) {
            try {
                made[i] = found[i] == null ? null : found[i].material(own);
            } catch (SceneFormatException e) {
                if (reported.add(e)) {
                    is.report(e.problems().get(0));
                }
            }
        }
        return new MeshMaterials(runs, found, made);
    }

    /** {@return what the MTL files say of each name that triangles have; null if nothing} */
    private MtlMaterial[] find(SceneReader is, String obj, TriangleMesh mesh, List<Diagnostic> problems) throws IOException {
        MaterialRuns runs = mesh.triangles.materials();
        Map<String, MtlMaterial> known = new LinkedHashMap<>();
        List<SceneFormatException> broken = new ArrayList<>();
        MtlReader.Skipped skipped = new MtlReader.Skipped();
        for (MaterialRuns.Name line : runs.libraries) {
            for (String file : MtlNames.split(line.text(), name -> isThere(is, MtlNames.besideObj(obj, name)))) {
                library(is, obj, file, line.place(), skipped, problems, broken)
                    .forEach(material -> known.putIfAbsent(material.name, material));
            }
        }
        if (runs.libraries.isEmpty() && mesh.triangles.count() > 0) {
            problems.add(new Diagnostic(is.resolve(obj).toString(), 1, 1, false,
                "expected mtllib, which names MTL files, found none: the mesh's own material is taken", null));
        }
        skipped.all().forEach(kind -> kind.warn(problems::add));
        Map<String, MtlMaterial> readings = new HashMap<>();
        known.forEach((name, material) -> MtlNames.readings(name).forEach(reading -> readings.putIfAbsent(reading, material)));
        MtlMaterial[] found = new MtlMaterial[runs.names.size()];
        boolean[] used = runs.used();
        List<MaterialRuns.Name> missing = new ArrayList<>();
        for (int i = 0; i < found.length; i++) {
            if (used[i]) {
                String name = runs.names.get(i).text();
                found[i] = MtlNames.readings(name).stream().map(known::get).filter(Objects::nonNull).findFirst().orElse(readings.get(name));
                if (found[i] == null) {
                    missing.add(runs.names.get(i));
                }
            }
        }
        for (SceneFormatException e : broken) {               // what is missing may be in them
            if (missing.isEmpty()) {
                problems.add(needless(e.problems().get(0), ""));
            } else if (reported.add(e)) {
                problems.addAll(0, e.problems());
            }
        }
        if (!missing.isEmpty()) {
            String others = missing.size() == 1 ? "" : " and " + (missing.size() - 1) + (missing.size() == 2 ? " other" : " others");
            problems.add(warning(missing.get(0).place(), "a material of the MTL files", Diagnostic.quoted(missing.get(0).text()) + others
                + ", in place of which the mesh's own is taken"));
        }
        known.values().removeIf(material -> !material.isUsable() && Arrays.asList(found).contains(material));   // errors
        List<Diagnostic> needless = known.values().stream().flatMap(material -> material.problems().stream()).toList();
        if (!needless.isEmpty()) {
            problems.add(needless(needless.get(0), needless.size() == 1 ? "" : " (and " + (needless.size() - 1) + " more)"));
        }
        return found;
    }

    private static Diagnostic needless(Diagnostic error, String more) {
        return new Diagnostic(error.file(), error.line(), error.column(), false,
            error.message() + ", which the picture does not need" + more, error.source());
    }

    /** {@return the materials of an MTL file; none if it cannot be read, of which a warning tells} */
    private List<MtlMaterial> library(SceneReader is, String obj, String file, Diagnostic place, MtlReader.Skipped skipped,
            List<Diagnostic> problems, List<SceneFormatException> broken) throws IOException {
        String name = MtlNames.besideObj(obj, file);
        String why;
        try {
            Path path = path(is, name);
            Path key = path.toAbsolutePath().normalize();
            List<MtlMaterial> library = libraries.get(key);
            if (library == null) {
                try (DigestInputStream in = open(path)) {
                    library = MtlReader.read(in, path.toString(), skipped);
                    read.add(new SourceText.MeshFile(name, Sha256.hex(in.getMessageDigest().digest())));
                } catch (SceneFormatException e) {
                    unreadable.put(key, e);
                    library = List.of();
                }
                libraries.put(key, library);
            }
            if (unreadable.containsKey(key)) {
                broken.add(unreadable.get(key));
            }
            return library;
        } catch (OutOfReachException e) {
            why = "MTL file within the scene's folder (--allow-outside allows any)";
        } catch (FileSystemException e) {
            why = "MTL file that can be read (" + Diagnostic.printable(e.getFile() + ": " + reason(e)) + ')';
        } catch (InvalidPathException e) {
            why = "MTL file that can be read (" + e.getReason() + ')';
        }
        problems.add(warning(place, why, Diagnostic.quoted(file)));
        return List.of();
    }

    private boolean isThere(SceneReader is, String name) {
        try {
            return Files.isRegularFile(path(is, name));
        } catch (IOException | InvalidPathException e) {
            return false;
        }
    }

    private static Diagnostic warning(Diagnostic place, String wanted, String found) {
        return new Diagnostic(place.file(), place.line(), place.column(), false, "expected " + wanted + ", found " + found, place.source());
    }

    private static String reason(FileSystemException e) {
        return e.getReason() == null ? e.toString() : e.getReason();
    }

    /** {@return whether a name leads out of its folder on any system, so that a scene is the same everywhere} */
    static boolean leavesByName(String name) {
        String path = name.replace('\\', '/');
        if (isRooted(path)) {
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

    /** {@return whether a name with slashes begins at a root or a drive of any system} */
    static boolean isRooted(String name) {
        return name.matches(ROOTED);
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
