package simpleray.scene;

import simpleray.math.Vector;

/** Caches the unit vector of a vector that rarely changes, to save a root and three divisions. Any thread may call. */
final class UnitVector {
    private Known known;                                      // constant: in a race, threads compute equal values

    private record Known(double x, double y, double z, double unitX, double unitY, double unitZ) {
        static Known of(Vector v) {
            Vector unit = v.normalised();
            return new Known(v.x, v.y, v.z, unit.x, unit.y, unit.z);
        }
    }

    /**
     * Returns the unit vector in an argument.
     *
     * @param of the vector
     * @param unit gets the unit vector, as by {@link Vector#normalise()}
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
