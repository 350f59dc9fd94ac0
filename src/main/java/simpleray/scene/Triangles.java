package simpleray.scene;

import java.util.Arrays;
import java.util.HashSet;
import java.util.Set;
import simpleray.math.Vector;

/**
 * Triangles with shared vertices, in flat arrays. <em>Constant</em>: the arrays are kept, and must not change.
 *
 * @param vertices x, y, z of each vertex
 * @param corners three vertices of each triangle, counted from 0, anticlockwise as seen from outside
 * @param normals x, y, z of each vertex normal, of unit length; zero for a normal of no length
 * @param cornerNormals three normals of each triangle, counted from 0, each -1 if it has none; null if no triangle has any
 * @param materials the names of their materials
 */
record Triangles(double[] vertices, int[] corners, double[] normals, int[] cornerNormals, MaterialRuns materials) {
    /** A normal with this squared length or less is only rounding error. */
    private static final double NO_LENGTH = 1e-24;

    /** No triangle. */
    static final Triangles NONE = new Triangles(new double[0], new int[0], new double[0], null);

    /** Creates triangles of which no material is known. */
    Triangles(double[] vertices, int[] corners, double[] normals, int[] cornerNormals) {
        this(vertices, corners, normals, cornerNormals, new MaterialRuns());
    }

    /** {@return the number of triangles} */
    int count() {
        return corners.length / 3;
    }

    /** {@return some of the triangles, with the same vertices} */
    Triangles some(int[] which) {
        int[] some = new int[3 * which.length];
        int[] theirNormals = cornerNormals == null ? null : new int[some.length];
        for (int i = 0; i < some.length; i++) {
            some[i] = corners[3 * which[i / 3] + i % 3];
            if (theirNormals != null) {
                theirNormals[i] = cornerNormals[3 * which[i / 3] + i % 3];
            }
        }
        return new Triangles(vertices, some, normals, theirNormals);
    }

    /**
     * Computes the box of a triangle.
     *
     * @param triangle the triangle
     * @param box gets xmin, ymin, zmin, xmax, ymax, zmax
     */
    void bounds(int triangle, double[] box) {
        int a = 3 * corners[3 * triangle];
        int b = 3 * corners[3 * triangle + 1];
        int c = 3 * corners[3 * triangle + 2];
        for (int axis = 0; axis < 3; axis++) {
            double p = vertices[a + axis];
            double q = vertices[b + axis];
            double r = vertices[c + axis];
            box[axis] = Math.min(p, Math.min(q, r));
            box[axis + 3] = Math.max(p, Math.max(q, r));
        }
    }

    /** {@return the box of all triangles: xmin, ymin, zmin, xmax, ymax, zmax} */
    double[] bounds() {
        double[] all = {Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY, Double.NEGATIVE_INFINITY,
            Double.NEGATIVE_INFINITY, Double.NEGATIVE_INFINITY};
        double[] box = new double[6];
        for (int i = 0; i < count(); i++) {
            bounds(i, box);
            for (int axis = 0; axis < 3; axis++) {
                all[axis] = Math.min(all[axis], box[axis]);
                all[axis + 3] = Math.max(all[axis + 3], box[axis + 3]);
            }
        }
        return all;
    }

    /** {@return whether each edge of a triangle is another's in the opposite direction, so that they enclose an inside} */
    boolean isClosed() {
        Set<Long> edges = new HashSet<>();
        for (int i = 0; i < corners.length; i++) {
            edges.add((long) corners[i] << Integer.SIZE | corners[i - i % 3 + (i + 1) % 3]);
        }
        return edges.stream().allMatch(edge -> edges.contains(edge << Integer.SIZE | edge >>> Integer.SIZE));
    }

    /** Computes the vector (B - A) × (C - A) of a triangle, outward, with a length of twice its area. {@return whether it is not zero} */
    boolean cross(int triangle, double[] out) {
        return cross(vertices, 3 * corners[3 * triangle], 3 * corners[3 * triangle + 1], 3 * corners[3 * triangle + 2], out);
    }

    /** Computes (B - A) × (C - A) of the points at these indices of the array. {@return whether it is not zero} */
    static boolean cross(double[] v, int a, int b, int c, double[] out) {
        double ex = v[b] - v[a];
        double ey = v[b + 1] - v[a + 1];
        double ez = v[b + 2] - v[a + 2];
        double fx = v[c] - v[a];
        double fy = v[c + 1] - v[a + 1];
        double fz = v[c + 2] - v[a + 2];
        out[0] = ey * fz - ez * fy;
        out[1] = ez * fx - ex * fz;
        out[2] = ex * fy - ey * fx;
        return out[0] != 0 || out[1] != 0 || out[2] != 0;
    }

    /**
     * Interpolates the normals of the corners.
     *
     * @param triangle the triangle
     * @param weights the weights of its corners, of any sum but 0
     * @param out gets the normal, not of unit length
     * @return whether there is one: the triangle has normals, and they do not cancel
     */
    boolean interpolate(int triangle, double[] weights, double[] out) {
        if (cornerNormals == null || cornerNormals[3 * triangle] < 0) {
            return false;
        }
        double sum = weights[0] + weights[1] + weights[2];
        Arrays.fill(out, 0, 3, 0);
        for (int corner = 0; corner < 3; corner++) {
            int normal = 3 * cornerNormals[3 * triangle + corner];
            for (int axis = 0; axis < 3; axis++) {
                out[axis] += weights[corner] / sum * normals[normal + axis];
            }
        }
        return out[0] * out[0] + out[1] * out[1] + out[2] * out[2] > NO_LENGTH;
    }

    /**
     * Returns the squared distance of a triangle from a point (Ericson, "Real-Time Collision Detection", 2005, chapter 5.1.5).
     *
     * @param triangle the triangle
     * @param p the point, x, y, z
     * @return the squared distance
     */
    double squaredDistance(int triangle, double[] p) {
        int a = 3 * corners[3 * triangle];
        int b = 3 * corners[3 * triangle + 1];
        int c = 3 * corners[3 * triangle + 2];
        double[] n = new double[3];
        cross(triangle, n);
        Vector normal = new Vector(n[0], n[1], n[2]).normalised();
        boolean above = true;                                 // whether the point's projection is in the triangle
        double nearest = Double.POSITIVE_INFINITY;
        int[] ring = {a, b, c, a};
        for (int i = 0; i < 3; i++) {
            double ex = vertices[ring[i + 1]] - vertices[ring[i]];
            double ey = vertices[ring[i + 1] + 1] - vertices[ring[i] + 1];
            double ez = vertices[ring[i + 1] + 2] - vertices[ring[i] + 2];
            double px = p[0] - vertices[ring[i]];
            double py = p[1] - vertices[ring[i] + 1];
            double pz = p[2] - vertices[ring[i] + 2];
            above &= (ey * pz - ez * py) * normal.x + (ez * px - ex * pz) * normal.y + (ex * py - ey * px) * normal.z >= 0;
            double along = Math.max(0, Math.min(1, (ex * px + ey * py + ez * pz) / (ex * ex + ey * ey + ez * ez)));
            double dx = px - along * ex;
            double dy = py - along * ey;
            double dz = pz - along * ez;
            nearest = Math.min(nearest, dx * dx + dy * dy + dz * dz);
        }
        if (!above) {
            return nearest;
        }
        double height = (p[0] - vertices[a]) * normal.x + (p[1] - vertices[a + 1]) * normal.y + (p[2] - vertices[a + 2]) * normal.z;
        return height * height;
    }
}
