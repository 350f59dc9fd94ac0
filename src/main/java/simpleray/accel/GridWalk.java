package simpleray.accel;

import simpleray.math.Ray;

/**
 * Follows rays through a {@link Grid}, from cell to cell (Amanatides and Woo, "A Fast Voxel Traversal Algorithm for Ray Tracing", 1987).
 * <em>Mutable</em>: one thread's own.
 */
final class GridWalk extends Walk {
    private final Grid grid;

    // where a ray enters, and how it goes on
    private int column;
    private int row;
    private int layer;
    private double nextX;
    private double nextY;
    private double nextZ;
    private double deltaX;
    private double deltaY;
    private double deltaZ;

    GridWalk(Grid grid, Finder finder) {
        super(finder, grid.boxes);
        this.grid = grid;
    }

    /** Brings a ray to its first cell; false if it passes by, or gets there only beyond a limit. */
    private boolean enter(Ray ray, double limit) {
        double[] middle = grid.boxes.middle;
        double[] half = grid.half;
        double x = ray.origin.x - middle[0];
        double y = ray.origin.y - middle[1];
        double z = ray.origin.z - middle[2];
        double dx = ray.direction.x;
        double dy = ray.direction.y;
        double dz = ray.direction.z;
        double ix = 1 / dx;
        double iy = 1 / dy;
        double iz = 1 / dz;
        double start = 0;
        if (Math.abs(x) > half[0] || Math.abs(y) > half[1] || Math.abs(z) > half[2]) {
            if (dx == 0 && Math.abs(x) > half[0] || dy == 0 && Math.abs(y) > half[1] || dz == 0 && Math.abs(z) > half[2]) {
                return false;
            }
            double hx = dx == 0 ? Double.POSITIVE_INFINITY : half[0] * Math.abs(ix);
            double hy = dy == 0 ? Double.POSITIVE_INFINITY : half[1] * Math.abs(iy);
            double hz = dz == 0 ? Double.POSITIVE_INFINITY : half[2] * Math.abs(iz);
            double cx = dx == 0 ? 0 : -x * ix;
            double cy = dy == 0 ? 0 : -y * iy;
            double cz = dz == 0 ? 0 : -z * iz;
            start = Math.max(0, Math.max(cx - hx, Math.max(cy - hy, cz - hz)));
            if (start > Math.min(cx + hx, Math.min(cy + hy, cz + hz)) || start > limit) {
                return false;
            }
        }
        column = grid.cell(0, x + start * dx);
        row = grid.cell(1, y + start * dy);
        layer = grid.cell(2, z + start * dz);
        deltaX = Math.abs(grid.size[0] * ix);
        deltaY = Math.abs(grid.size[1] * iy);
        deltaZ = Math.abs(grid.size[2] * iz);
        nextX = dx == 0 ? Double.POSITIVE_INFINITY : ((column + (dx > 0 ? 1 : 0)) * grid.size[0] - half[0] - x) * ix;
        nextY = dy == 0 ? Double.POSITIVE_INFINITY : ((row + (dy > 0 ? 1 : 0)) * grid.size[1] - half[1] - y) * iy;
        nextZ = dz == 0 ? Double.POSITIVE_INFINITY : ((layer + (dz > 0 ? 1 : 0)) * grid.size[2] - half[2] - z) * iz;
        return true;
    }

    @Override
    void nearest(Ray ray) {
        if (enter(ray, finder.t)) {
            follow(ray, 0, false);
        }
    }

    @Override
    int blocker(Ray ray, double distance) {
        return enter(ray, distance) ? follow(ray, distance, true) : Finder.NONE;
    }

    /** Goes from cell to cell until the nearest hit lies behind, or (for a shadow) something blocks or the light is reached. */
    private int follow(Ray ray, double distance, boolean shadow) {
        int[] starts = grid.starts;
        int wide = grid.cells[0];
        int slice = wide * grid.cells[1];
        int stepX = ray.direction.x > 0 ? 1 : -1;
        int stepY = ray.direction.y > 0 ? wide : -wide;
        int stepZ = ray.direction.z > 0 ? slice : -slice;
        int leftX = ray.direction.x > 0 ? wide - 1 - column : column;
        int leftY = ray.direction.y > 0 ? grid.cells[1] - 1 - row : row;
        int leftZ = ray.direction.z > 0 ? grid.cells[2] - 1 - layer : layer;
        int cell = column + row * wide + layer * slice;
        double tx = nextX;
        double ty = nextY;
        double tz = nextZ;
        int blocker = Finder.NONE;
        int visited = 0;
        while (true) {
            visited++;
            if (shadow) {
                blocker = finder.blockerOfList(ray, distance, grid.places, starts[cell], starts[cell + 1]);
                if (blocker != Finder.NONE) {
                    break;
                }
            } else {
                finder.nearestOfList(ray, grid.places, starts[cell], starts[cell + 1]);
            }
            double far = shadow ? distance : finder.t;
            if (tx < ty && tx < tz) {
                if (far <= tx || --leftX < 0) {
                    break;
                }
                tx += deltaX;
                cell += stepX;
            } else if (ty < tz) {
                if (far <= ty || --leftY < 0) {
                    break;
                }
                ty += deltaY;
                cell += stepY;
            } else {
                if (far <= tz || --leftZ < 0) {
                    break;
                }
                tz += deltaZ;
                cell += stepZ;
            }
        }
        finder.stats.steps += visited;
        return blocker;
    }
}
