package simpleray.scene;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import simpleray.text.Diagnostic;

/**
 * The names of materials that an OBJ gives its triangles ({@code usemtl}), and the MTL files that it names ({@code mtllib}). <em>Mutable</em> while
 * the OBJ is read, and then constant. Triangles come in the order of the OBJ.
 */
final class MaterialRuns {
    /** The number of no material. */
    static final int NONE = -1;

    private static final int INITIAL = 16;

    /** The files that the OBJ names, a line each. */
    final List<Name> libraries = new ArrayList<>();
    /** The materials that it names, each once; perhaps no triangle has them. */
    final List<Name> names = new ArrayList<>();

    private final Map<String, Integer> numbers = new HashMap<>();
    private int[] starts = {};                                // the first triangle of each run
    private int[] materials = {};                             // the number of its name
    private int count;

    /**
     * A name.
     *
     * @param text the name
     * @param place where it stands
     */
    record Name(String text, Diagnostic place) {
    }

    /**
     * Begins a run.
     *
     * @param triangle its first triangle
     * @param name the material, empty for none
     * @param lines is at the line that names it
     */
    void begin(int triangle, String name, LineReader lines) {
        Integer number = name.isEmpty() ? Integer.valueOf(NONE) : numbers.get(name);
        if (number == null) {
            number = names.size();
            numbers.put(name, number);
            names.add(new Name(name, lines.warning("")));
        }
        if (count > 0 && starts[count - 1] == triangle) {
            count--;                                          // the run before has no triangle
        }
        if (count == starts.length) {
            starts = Arrays.copyOf(starts, 2 * count + INITIAL);
            materials = Arrays.copyOf(materials, 2 * count + INITIAL);
        }
        starts[count] = triangle;
        materials[count++] = number;
    }

    /** Ends the last run. */
    void end(int triangles) {
        count -= count > 0 && starts[count - 1] == triangles ? 1 : 0;
        starts = Arrays.copyOf(starts, count);
        materials = Arrays.copyOf(materials, count);
    }

    /** {@return the number of a triangle's material, an index of the names; {@link #NONE} if it has none} */
    int number(int triangle) {
        int run = Arrays.binarySearch(starts, triangle);
        run = run < 0 ? -run - 2 : run;
        return run < 0 ? NONE : materials[run];
    }

    /** {@return the first triangles of all runs, and then the numbers of their materials} */
    int[] all() {
        int[] all = Arrays.copyOf(starts, 2 * count);
        System.arraycopy(materials, 0, all, count, count);
        return all;
    }

    /** {@return whether triangles have each of the names} */
    boolean[] used() {
        boolean[] used = new boolean[names.size()];
        for (int material : materials) {
            if (material != NONE) {
                used[material] = true;
            }
        }
        return used;
    }
}
