package simpleray.image;

/** The five ways in which PNG predicts a byte from its neighbours, so that a row becomes small numbers. */
final class PngFilter {
    private static final int PIXEL = 3;
    private static final int FILTERS = 5;

    private PngFilter() {
    }

    /**
     * Filters a row in the way whose bytes, taken as signed, have the smallest sum (the PNG specification's own advice, section 12.8).
     *
     * @param row the row's bytes
     * @param above those of the row above, zeros for the first row
     * @return the filter's number and the filtered bytes
     */
    static byte[] best(byte[] row, byte[] above) {
        byte[] best = null;
        long least = Long.MAX_VALUE;
        for (int filter = 0; filter < FILTERS; filter++) {
            byte[] filtered = new byte[row.length + 1];
            filtered[0] = (byte) filter;
            long sum = 0;
            for (int i = 0; i < row.length; i++) {
                int left = i < PIXEL ? 0 : row[i - PIXEL] & 0xFF;
                int up = above[i] & 0xFF;
                int upLeft = i < PIXEL ? 0 : above[i - PIXEL] & 0xFF;
                byte difference = (byte) ((row[i] & 0xFF) - predicted(filter, left, up, upLeft));
                filtered[i + 1] = difference;
                sum += Math.abs(difference);
            }
            if (sum < least) {
                least = sum;
                best = filtered;
            }
        }
        return best;
    }

    private static int predicted(int filter, int left, int up, int upLeft) {
        return switch (filter) {
            case 0 -> 0;
            case 1 -> left;
            case 2 -> up;
            case 3 -> (left + up) / 2;
            default -> paeth(left, up, upLeft);
        };
    }

    /** {@return the neighbour closest to left + up - upLeft} Paeth, "Image file compression made easy", Graphics Gems II, 1991. */
    private static int paeth(int left, int up, int upLeft) {
        int estimate = left + up - upLeft;
        int byLeft = Math.abs(estimate - left);
        int byUp = Math.abs(estimate - up);
        int byUpLeft = Math.abs(estimate - upLeft);
        if (byLeft <= byUp && byLeft <= byUpLeft) {
            return left;
        }
        return byUp <= byUpLeft ? up : upLeft;
    }
}
