package simpleray.convert;

import java.io.IOException;
import java.util.List;
import simpleray.scene.Scene;
import simpleray.text.Diagnostic;
import simpleray.text.SceneWriter;

/**
 * A scene of another program.
 *
 * @param name the file that it is from, for people
 * @param scene its scene; what is in the facets stands there as triangles, too
 * @param text the scene as it is written
 * @param facets its polygons
 * @param warnings what is changed or left out, and why
 */
public record ImportedScene(String name, Scene scene, String text, Facets facets, List<Diagnostic> warnings) {
    /** How every file begins that an import writes. */
    public static final String MARK = "# imported by SimpleRay";

    /**
     * Writes the scene, its polygons as triangles.
     *
     * @param os where to
     * @throws IOException if it cannot be written
     */
    public void write(SceneWriter os) throws IOException {
        writeMark(os);
        os.writeString(text);
    }

    /**
     * Writes the scene, its polygons as a mesh.
     *
     * @param os where to
     * @param obj the name of the OBJ beside the scene
     * @throws IOException if it cannot be written
     */
    public void write(SceneWriter os, String obj) throws IOException {
        writeMark(os);
        facets.inMesh(scene, obj).write(os);
    }

    /**
     * Writes the OBJ.
     *
     * @param os where to
     * @param mtl the name of the MTL file beside it; not looked at if there is only one material
     * @throws IOException if it cannot be written
     */
    public void writeObj(SceneWriter os, String mtl) throws IOException {
        writeMark(os);
        facets.writeObj(os, mtl);
    }

    /**
     * Writes the materials of the OBJ.
     *
     * @param os where to
     * @throws IOException if it cannot be written
     */
    public void writeMtl(SceneWriter os) throws IOException {
        writeMark(os);
        facets.writeMtl(os);
    }

    private void writeMark(SceneWriter os) throws IOException {
        os.writeString(MARK + " from " + Diagnostic.printable(name.substring(1 + Math.max(name.lastIndexOf('/'), name.lastIndexOf('\\')))) + '\n');
    }
}
