package simpleray.scene;

import java.io.IOException;
import java.util.function.Function;
import simpleray.math.Colour;
import simpleray.text.SceneReader;

/**
 * The materials of the objects of one file, without duplicates: a million spheres rarely have a million materials.
 * <em>Mutable,</em> for one thread.
 */
final class Materials {
    static final Function<Class<?>, Materials> MAKER = new Function<>() {
        @Override
        public Materials apply(Class<?> type) {
            return new Materials();
        }
    };

    private static final int FIRST_SIZE = 64;
    /** So many places are looked at; a material that is not found there, which hardly happens, is not shared. */
    private static final int MAX_PROBES = 256;
    /** An odd number without a pattern in its bits: 2^64 by the golden ratio. */
    private static final long MIXER = 0x9E3779B97F4A7C15L;

    private Material[] table = new Material[FIRST_SIZE];      // hashed, at most half full
    private int count;
    private Material next = new Material();

    /** {@return the next material in the file, or an equal one read before} */
    Material read(SceneReader is) throws IOException {
        next.read(is);
        Material shared = shared(next);
        if (shared == next) {
            next = new Material();
        }
        return shared;
    }

    /** {@return this material, which must not change any more, or an equal one read before} */
    Material shared(Material read) {
        int slot = slot(read);
        if (slot >= 0 && table[slot] != null) {
            return table[slot];
        }
        if (slot >= 0) {
            table[slot] = read;
            count++;
            if (2 * count > table.length) {
                grow();
            }
        }
        return read;
    }

    /** {@return the slot of an equal material, or a free slot for this one; -1 for neither} */
    private int slot(Material m) {
        int slot = (int) hash(m) & table.length - 1;
        for (int i = 0; i < MAX_PROBES; i++) {
            if (table[slot] == null || m.isSame(table[slot])) {
                return slot;
            }
            slot = slot + 1 & table.length - 1;
        }
        return -1;
    }

    private void grow() {
        Material[] old = table;
        table = new Material[2 * old.length];
        for (Material m : old) {
            int slot = m == null ? -1 : slot(m);
            if (slot >= 0) {
                table[slot] = m;
            }
        }
    }

    /** {@return a hash, equal for equal materials} */
    static long hash(Material m) {
        long hash = mixed(bits(m.ambient), bits(m.diffuse));
        hash = mixed(hash, bits(m.specular));
        hash = m.mirror == null ? hash : mixed(hash, bits(m.mirror));
        hash = mixed(hash, bits(m.transmission));
        hash = mixed(hash, Double.doubleToRawLongBits(m.shininess));
        return mixed(hash, Double.doubleToRawLongBits(m.index));
    }

    private static long bits(Colour c) {
        return mixed(mixed(Double.doubleToRawLongBits(c.r), Double.doubleToRawLongBits(c.g)), Double.doubleToRawLongBits(c.b));
    }

    private static long mixed(long hash, long bits) {
        long product = (hash ^ bits) * MIXER;
        return product ^ product >>> Integer.SIZE;
    }
}
