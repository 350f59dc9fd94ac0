package simpleray.accel;

/** Tests the primitives of a leaf of a {@link Bvh}, for a ray that it knows. */
public interface LeafIntersector {
    /**
     * Looks for nearer hits than that found so far.
     *
     * @param first the first primitive, in the order of the boxes
     * @param end one after the last
     * @return how far the nearest hit so far is; infinite if there is none
     */
    double closest(int first, int end);

    /**
     * Looks whether something is in the way.
     *
     * @param first the first primitive, in the order of the boxes
     * @param end one after the last
     * @return whether nothing more gets through
     */
    boolean occluded(int first, int end);
}
