package simpleray.scene;

import simpleray.math.Vector;

/** Remembers the unit vector of a vector that hardly ever changes, which costs a root and three quotients. Any thread may call. */
final class UnitVector {
    private Known known;                                      // constant: a race between threads has it found twice, and alike

    private record Known(double x, double y, double z, double unitX, double unitY, double unitZ) {
        static Known of(Vector v) {
            Vector unit = v.normalised();
            return new Known(v.x, v.y, v.z, unit.x, unit.y, unit.z);
        }
    }

    /**
     * Finds the unit vector.
     *
     * @param of the vector
     * @param unit gets it, as {@link Vector#normalise()} makes it
     */
    void of(Vector of, Vector unit) {
        Known k = known;
        if (k == null || k.x != of.x || k.y != of.y || k.z != of.z) {
            k = Known.of(of);
            known = k;
        }
        unit.set(k.unitX, k.unitY, k.unitZ);
    }
}
