package simpleray.scene;

/** The materials that MTL files give the triangles of a mesh. <em>Constant.</em> Where they give none, it is the mesh's own. */
final class MeshMaterials {
    private final MaterialRuns runs;
    private final MtlMaterial[] found;
    private final Material[] made;

    /**
     * Creates the materials of a mesh.
     *
     * @param runs which triangles have which name
     * @param found what a file says of each name; null for the mesh's own material
     * @param made the material made of it; null for the mesh's own
     */
    MeshMaterials(MaterialRuns runs, MtlMaterial[] found, Material[] made) {
        this.runs = runs;
        this.found = found;
        this.made = made;
    }

    /** {@return the number of materials, the mesh's own included} */
    int count() {
        return made.length + 1;
    }

    /** {@return the number of a triangle's material; the last is the mesh's own} */
    int number(int triangle) {
        int number = runs.number(triangle);
        return number == MaterialRuns.NONE || made[number] == null ? made.length : number;
    }

    /** {@return the material of this number; null for the mesh's own and for one that no triangle has} */
    Material get(int number) {
        return number < made.length ? made[number] : null;
    }

    /** {@return whether no light passes through any of them} */
    boolean areOpaque() {
        for (Material material : made) {
            if (material != null && !material.transmission.isBlack()) {
                return false;
            }
        }
        return true;
    }

    /** {@return where a material stands; null for the mesh's own} */
    RayTree.Mtl origin(Material material) {
        for (int i = 0; i < made.length; i++) {
            if (made[i] == material) {
                return new RayTree.Mtl(found[i].name, found[i].file, found[i].line);
            }
        }
        return null;
    }
}
