package simpleray.accel;

/** Tests the primitives of a leaf of a {@link Bvh} or of a cell of a {@link UniformGrid} with the current ray. */
public interface PrimitiveIntersector {
    /**
     * Looks for a hit nearer than the nearest so far.
     *
     * @param list lists of primitives; null for all in the order of the boxes
     * @param first the index in it of the first primitive to test
     * @param end the index after the last
     * @return t of the nearest hit so far; infinite if there is none
     */
    double closest(int[] list, int first, int end);

    /**
     * Tests whether primitives block the ray.
     *
     * @param list lists of primitives; null for all in the order of the boxes
     * @param first the index in it of the first primitive to test
     * @param end the index after the last
     * @return whether no light passes
     */
    boolean occluded(int[] list, int first, int end);
}
