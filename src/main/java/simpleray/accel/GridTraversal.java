package simpleray.accel;

import simpleray.math.Ray;

/**
 * Traverses a {@link UniformGrid} along a ray, cell by cell (Amanatides and Woo, "A Fast Voxel Traversal Algorithm for Ray Tracing", 1987).
 * <em>Mutable</em>: one thread's own.
 */
public final class GridTraversal {
    /** A smaller component of a direction counts as 0: its reciprocal would give infinite numbers, and NaN as their differences. */
    private static final double STILL = 1e-200;

    /** The number of cells visited. */
    public long steps;

    private final UniformGrid grid;
    private final PrimitiveIntersector primitives;

    // the entry of a ray and its increments, in units of the grid
    private int column;
    private int row;
    private int layer;
    private double nextX;
    private double nextY;
    private double nextZ;
    private double deltaX;
    private double deltaY;
    private double deltaZ;

    /**
     * Creates a traversal.
     *
     * @param grid the grid
     * @param primitives tests the primitives of a cell, or all for a ray that starts too far away
     */
    public GridTraversal(UniformGrid grid, PrimitiveIntersector primitives) {
        this.grid = grid;
        this.primitives = primitives;
    }

    /**
     * Tests all primitives that the ray may hit no farther than the nearest hit.
     *
     * @param ray the ray
     * @param limit t of the nearest hit found before; infinite if there is none
     */
    public void closest(Ray ray, double limit) {
        if (!canFollow(ray)) {
            primitives.closest(null, 0, grid.primitives);
        } else if (enter(ray, limit)) {
            follow(ray, limit, false);
        }
    }

    /**
     * Tests primitives that the ray may hit before some distance, until no light passes.
     *
     * @param ray the ray
     * @param distance the distance
     * @return whether no light passes
     */
    public boolean occluded(Ray ray, double distance) {
        return canFollow(ray) ? enter(ray, distance) && follow(ray, distance, true) : primitives.occluded(null, 0, grid.primitives);
    }

    /** {@return whether a ray starts near enough for the grid; else all primitives must be tested} */
    private boolean canFollow(Ray ray) {
        double[] middle = grid.middle;
        return Math.max(Math.abs(ray.origin.x - middle[0]), Math.max(Math.abs(ray.origin.y - middle[1]),
            Math.abs(ray.origin.z - middle[2]))) <= PrimitiveBounds.MAX_DISTANCE * grid.extent;
    }

    /** Finds the first cell of a ray. {@return false if the ray misses the grid, or enters it beyond the limit} */
    private boolean enter(Ray ray, double limit) {
        double[] middle = grid.middle;
        double[] half = grid.half;
        double unit = 1 / grid.extent;
        double x = (ray.origin.x - middle[0]) * unit;
        double y = (ray.origin.y - middle[1]) * unit;
        double z = (ray.origin.z - middle[2]) * unit;
        double dx = moving(ray.direction.x * unit);
        double dy = moving(ray.direction.y * unit);
        double dz = moving(ray.direction.z * unit);
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

    private static double moving(double d) {
        return Math.abs(d) < STILL ? 0 : d;
    }

    /** Visits cells up to the nearest hit or, for a shadow ray, until the light is blocked or reached. */
    private boolean follow(Ray ray, double limit, boolean shadow) {
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
        double far = limit;
        boolean blocked = false;
        int visited = 0;
        while (true) {
            visited++;
            if (shadow) {
                blocked = primitives.occluded(grid.places, starts[cell], starts[cell + 1]);
                if (blocked) {
                    break;
                }
            } else {
                far = primitives.closest(grid.places, starts[cell], starts[cell + 1]);
            }
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
        steps += visited;
        return blocked;
    }
}
