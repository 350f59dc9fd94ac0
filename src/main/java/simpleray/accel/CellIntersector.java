package simpleray.accel;

/** Tests the primitives in a cell of a {@link UniformGrid}, for a ray that it knows. */
public interface CellIntersector {
    /**
     * Looks for nearer hits than that found so far.
     *
     * @param list lists of primitives
     * @param first where the list of those in question begins
     * @param end one after its last place
     * @return how far the nearest hit so far is; infinite if there is none
     */
    double closest(int[] list, int first, int end);

    /**
     * Looks whether something is in the way.
     *
     * @param list lists of primitives
     * @param first where the list of those in question begins
     * @param end one after its last place
     * @return whether nothing more gets through
     */
    boolean occluded(int[] list, int first, int end);
}
