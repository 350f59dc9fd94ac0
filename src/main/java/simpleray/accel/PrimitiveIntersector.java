package simpleray.accel;

/** Tests the primitives of a leaf of a {@link Bvh} or in a cell of a {@link UniformGrid}, for a ray that it knows. */
public interface PrimitiveIntersector {
    /**
     * Looks for nearer hits than that found so far.
     *
     * @param list lists of primitives; null for all in the order of the boxes
     * @param first the place in it of the first primitive in question
     * @param end one after the place of the last
     * @return how far the nearest hit so far is; infinite if there is none
     */
    double closest(int[] list, int first, int end);

    /**
     * Looks whether something is in the way.
     *
     * @param list lists of primitives; null for all in the order of the boxes
     * @param first the place in it of the first primitive in question
     * @param end one after the place of the last
     * @return whether nothing more gets through
     */
    boolean occluded(int[] list, int first, int end);
}
