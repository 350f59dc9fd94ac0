package simpleray.scene;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.awt.geom.Path2D;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Random;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import simpleray.Sample;

/** Polygons cut into triangles, against Java's own rule of what is inside. */
class EarClipperTest {
    private static final int POINTS = Sample.size(200, 200);
    private final EarClipper clipper = new EarClipper();

    /** Places the plane of a drawing in space. */
    private interface Plane {
        double[] place(double x, double y);
    }

    private static final Plane FLAT = (x, y) -> new double[] {x, y, 0};

    private int[] cut(double[] flat, Plane plane) {
        double[] vertices = new double[flat.length / 2 * 3];
        for (int i = 0; i < flat.length / 2; i++) {
            System.arraycopy(plane.place(flat[2 * i], flat[2 * i + 1]), 0, vertices, 3 * i, 3);
        }
        return clipper.cut(vertices, IntStream.range(0, flat.length / 2).toArray(), flat.length / 2);
    }

    private static double area(double[] p, int a, int b, int c) {
        return ((p[2 * b] - p[2 * a]) * (p[2 * c + 1] - p[2 * a + 1]) - (p[2 * c] - p[2 * a]) * (p[2 * b + 1] - p[2 * a + 1])) / 2;
    }

    private static double area(double[] p) {
        return IntStream.range(2, p.length / 2).mapToDouble(i -> area(p, 0, i - 1, i)).sum();
    }

    /** Checks that the triangles cover exactly the polygon, which does not touch itself, and that all its edges are theirs. */
    private static void assertCovers(double[] polygon, int[] cut) {
        int n = polygon.length / 2;
        assertCoversOnce(polygon, cut);
        assertThat(cut).hasSize(3 * (n - 2));
        for (int i = 0; i < n; i++) {
            int from = i;
            int to = (i + 1) % n;
            assertThat(IntStream.range(0, cut.length).filter(k -> cut[k] == from && cut[k - k % 3 + (k + 1) % 3] == to).count())
                .as("triangles at edge %s", from).isEqualTo(1);
        }
    }

    private static void assertCoversOnce(double[] polygon, int[] cut) {
        assertThat(cut).as("triangles").isNotNull().isNotEmpty();
        double whole = area(polygon);
        double sum = 0;
        Path2D path = path(polygon, IntStream.range(0, polygon.length / 2).toArray());
        List<Path2D> triangles = new ArrayList<>();
        for (int i = 0; i < cut.length; i += 3) {
            double area = area(polygon, cut[i], cut[i + 1], cut[i + 2]);
            assertThat(area * Math.signum(whole)).as("area of a triangle").isGreaterThan(0);
            sum += area;
            triangles.add(path(polygon, cut[i], cut[i + 1], cut[i + 2]));
        }
        assertThat(sum).isCloseTo(whole, within(Math.abs(whole) * 1e-9));
        Random random = new Random(polygon.length);
        for (int i = 0; i < POINTS; i++) {
            double x = path.getBounds2D().getMinX() + random.nextDouble() * path.getBounds2D().getWidth();
            double y = path.getBounds2D().getMinY() + random.nextDouble() * path.getBounds2D().getHeight();
            assertThat(triangles.stream().filter(triangle -> triangle.contains(x, y)).count()).as("triangles at %s %s", x, y)
                .isEqualTo(path.contains(x, y) ? 1 : 0);
        }
    }

    private static Path2D path(double[] p, int... corners) {
        Path2D path = new Path2D.Double(Path2D.WIND_EVEN_ODD);
        path.moveTo(p[2 * corners[0]], p[2 * corners[0] + 1]);
        for (int corner : corners) {
            path.lineTo(p[2 * corner], p[2 * corner + 1]);
        }
        path.closePath();
        return path;
    }

    /** {@return the polygon with the corner from which it starts, or the other way round} */
    private static double[] turned(double[] p, int start, boolean back) {
        int n = p.length / 2;
        double[] turned = new double[p.length];
        for (int i = 0; i < n; i++) {
            int from = Math.floorMod(start + (back ? -i : i), n);
            turned[2 * i] = p[2 * from];
            turned[2 * i + 1] = p[2 * from + 1];
        }
        return turned;
    }

    /** {@return the polygon with more corners on its edges} */
    private static double[] divided(double[] p, int parts) {
        int n = p.length / 2;
        double[] divided = new double[p.length * parts];
        for (int i = 0; i < n * parts; i++) {
            int a = i / parts;
            int b = (a + 1) % n;
            double share = (double) (i % parts) / parts;
            divided[2 * i] = p[2 * a] + (p[2 * b] - p[2 * a]) * share;
            divided[2 * i + 1] = p[2 * a + 1] + (p[2 * b + 1] - p[2 * a + 1]) * share;
        }
        return divided;
    }

    private static final double[] DOORWAY = {-2, -1, -0.5, -1, -0.5, 0.5, 0.5, 0.5, 0.5, -1, 2, -1, 2, 1.5, -2, 1.5};
    private static final double[] DART = {0, 0, 4, -2, 1, 0, 4, 2};

    @Test
    void aDoorwayIsCutFromEachCornerInEachWinding() {
        for (int start = 0; start < 8; start++) {
            for (boolean back : new boolean[] {false, true}) {
                for (int parts = 1; parts <= 4; parts++) {
                    double[] polygon = divided(turned(DOORWAY, start, back), parts);
                    assertCovers(polygon, cut(polygon, FLAT));
                }
            }
        }
    }

    @Test
    void aConvexPolygonStaysAFan() {
        Random random = new Random(1);
        for (int n = 3; n < 60; n++) {
            double[] polygon = new double[2 * n];
            for (int i = 0; i < n; i++) {
                polygon[2 * i] = 3 * Math.cos(2 * Math.PI * i / n);
                polygon[2 * i + 1] = 2 * Math.sin(2 * Math.PI * i / n);
            }
            double[] some = turned(polygon, random.nextInt(n), random.nextBoolean());
            for (Plane plane : planes(random)) {
                assertThat(cut(some, plane)).isSameAs(EarClipper.FAN);
                assertThat(cut(divided(some, 3), plane)).isSameAs(EarClipper.FAN);
                assertThat(cut(divided(turned(some, 0, true), 7), plane)).isSameAs(EarClipper.FAN);
            }
        }
        assertThat(cut(new double[] {0, 0, 0, 0, 1, 0, 1, 0, 1, 0, 1, 1, 0, 1, 0, 0}, FLAT)).as("corners twice").isSameAs(EarClipper.FAN);
    }

    private static List<Plane> planes(Random random) {
        List<Plane> planes = new ArrayList<>(List.of(FLAT, (x, y) -> new double[] {0, y, x}, (x, y) -> new double[] {y, -5, x}));
        for (int i = 0; i < 4; i++) {
            double[] m = random.doubles(9, -1, 1).toArray();
            planes.add((x, y) -> new double[] {m[0] * x + m[1] * y + 8 * m[2], m[3] * x + m[4] * y + 8 * m[5],
                m[6] * x + m[7] * y + 8 * m[8]});
        }
        return planes;
    }

    @Test
    void aStarredPolygonIsCutInAnyPlane() {
        Random random = new Random(2);
        for (int k = 0; k < Sample.size(2000, 200); k++) {
            int n = 4 + random.nextInt(60);
            double[] polygon = new double[2 * n];
            for (int i = 0; i < n; i++) {
                double radius = 1 + random.nextInt(8);
                polygon[2 * i] = radius * Math.cos(2 * Math.PI * i / n);
                polygon[2 * i + 1] = radius * Math.sin(2 * Math.PI * i / n);
            }
            double[] some = turned(polygon, 0, random.nextBoolean());
            for (Plane plane : planes(random)) {
                int[] cut = cut(some, plane);
                if (cut != EarClipper.FAN) {
                    assertCovers(some, cut);
                }
            }
        }
    }

    /** Cells of a square grid, joined to a tree: all corners lie on few lines, and many edges are parallel. */
    @Test
    void aMazeIsCut() {
        Random random = new Random(3);
        for (int k = 0; k < Sample.size(400, 60); k++) {
            double[] maze = maze(2 + random.nextInt(9), random);
            double[] some = turned(maze, random.nextInt(maze.length / 2), random.nextBoolean());
            assertCovers(some, cut(some, FLAT));
            Plane plane = planes(random).get(4);
            assertThat(cut(some, plane)).as("tilted").hasSize(3 * (some.length / 2 - 2));
            assertCoversOnce(some, cut(some, plane));
        }
    }

    /** {@return the outline of a spanning tree of a grid, around which the wall is followed} */
    private static double[] maze(int side, Random random) {
        boolean[][] open = new boolean[2 * side + 1][2 * side + 1];
        List<int[]> way = new ArrayList<>(List.of(new int[] {1, 1}));
        open[1][1] = true;
        while (!way.isEmpty()) {
            int[] at = way.get(way.size() - 1);
            List<int[]> steps = new ArrayList<>(List.of(new int[] {2, 0}, new int[] {-2, 0}, new int[] {0, 2}, new int[] {0, -2}));
            Collections.shuffle(steps, random);
            steps.removeIf(s -> at[0] + s[0] < 0 || at[0] + s[0] > 2 * side || at[1] + s[1] < 0 || at[1] + s[1] > 2 * side
                || open[at[0] + s[0]][at[1] + s[1]]);
            if (steps.isEmpty()) {
                way.remove(way.size() - 1);
            } else {
                int[] s = steps.get(0);
                open[at[0] + s[0] / 2][at[1] + s[1] / 2] = true;
                open[at[0] + s[0]][at[1] + s[1]] = true;
                way.add(new int[] {at[0] + s[0], at[1] + s[1]});
            }
        }
        List<Double> outline = new ArrayList<>();
        int x = 1;
        int y = 1;
        int dx = 1;
        int dy = 0;
        do {                                                  // the open cells lie on the left
            outline.add((double) x);
            outline.add((double) y);
            x += dx;
            y += dy;
            if (isOpen(open, x, y, dx, dy, 1)) {
                if (isOpen(open, x, y, dx, dy, -1)) {
                    int turn = dx;
                    dx = dy;
                    dy = -turn;
                }
            } else {
                int turn = dx;
                dx = -dy;
                dy = turn;
            }
        } while (x != 1 || y != 1 || dx != 1);
        return outline.stream().mapToDouble(Double::doubleValue).toArray();
    }

    /** {@return whether the cell before a corner of the grid, to the left (1) or right (-1), is open} */
    private static boolean isOpen(boolean[][] open, int x, int y, int dx, int dy, int side) {
        double cx = x + dx * 0.5 - dy * 0.5 * side;
        double cy = y + dy * 0.5 + dx * 0.5 * side;
        int i = (int) Math.floor(cx);
        int j = (int) Math.floor(cy);
        return i >= 0 && j >= 0 && i < open.length && j < open.length && open[i][j];
    }

    @ParameterizedTest
    @ValueSource(doubles = {1e-90, 1e-9, 1, 1e9, 1e90})
    void theSizeDoesNotMatter(double size) {
        for (double[] shape : new double[][] {DOORWAY, turned(DART, 3, false), turned(DART, 1, true)}) {
            double[] polygon = divided(shape, 3);
            assertCovers(polygon, cut(polygon, (x, y) -> new double[] {size * x, size * y, size * (x + y) / 4}));
            assertThat(cut(polygon, (x, y) -> new double[] {size * x, size * (3e6 + y / 8), size * (x + 5e6)})).as("far away")
                .hasSize(3 * (polygon.length / 2 - 2));
        }
    }

    @Test
    void aPolygonNeedNotBeExactlyFlat() {
        Random random = new Random(4);
        for (int k = 0; k < 50; k++) {
            assertCovers(DOORWAY, cut(DOORWAY, (x, y) -> new double[] {x, y, x / 3 + 0.2 * random.nextDouble()}));
        }
    }

    /** A hole is joined to the outline by an edge there and back. */
    @Test
    void holesAtTheEndOfABridgeStayOpen() {
        double[] one = {0, 0, 9, 0, 9, 9, 0, 9, 0, 0, 3, 3, 3, 6, 6, 6, 6, 3, 3, 3};
        double[] two = {0, 0, 3, 3, 3, 4, 4, 4, 4, 3, 3, 3, 0, 0, 9, 0, 9, 9, 6, 6, 6, 5, 5, 5, 5, 6, 6, 6, 9, 9, 0, 9};
        double[] chain = {0, 0, 9, 0, 9, 9, 0, 9, 0, 0, 2, 2, 2, 3, 3, 3, 5, 5, 5, 6, 6, 6, 6, 5, 5, 5, 3, 3, 3, 2, 2, 2};
        double[] straight = {0, 0, 4, 0, 4, 4, 4, 6, 6, 6, 6, 4, 4, 4, 4, 0, 9, 0, 9, 9, 0, 9};
        double[] round = roundHole(50);
        for (double[] shape : new double[][] {one, two, chain, straight, round}) {
            for (int start = 0; start < shape.length / 2; start++) {
                for (boolean back : new boolean[] {false, true}) {
                    double[] polygon = turned(shape, start, back);
                    assertCoversOnce(polygon, cut(polygon, FLAT));
                    assertCoversOnce(polygon, cut(polygon, (x, y) -> new double[] {0.3 * x + 1.7, y * 0.7, 0.9 * x + 0.1 * y}));
                }
            }
        }
    }

    private static double[] roundHole(int n) {
        double[] shape = new double[4 * n + 4];
        for (int i = 0; i <= 2 * n + 1; i++) {
            double angle = 2 * Math.PI * (i <= n ? i % n : (2 * n + 1 - i) % n) / n;
            shape[2 * i] = (i <= n ? 2 : 1) * Math.cos(angle);
            shape[2 * i + 1] = (i <= n ? 2 : 1) * Math.sin(angle);
        }
        return shape;
    }

    @Test
    void spikesAndRepeatedCornersAreNoTriangles() {
        double[] spike = {0, 0, 4, 0, 9, 0, 4, 0, 4, 4, 2, 1, 0, 4};
        double[] inward = {0, 0, 4, 0, 4, 4, 2, 4, 2, 2, 2, 4, 0, 4};
        double[] twice = {0, 0, 0, 0, 4, 0, 4, 0, 4, 4, 2, 1, 2, 1, 2, 1, 0, 4, 0, 0};
        double[] touching = {0, 0, 4, 0, 4, 4, 2, 0, 0, 4};
        for (double[] shape : new double[][] {spike, inward, twice, touching}) {
            for (int start = 0; start < shape.length / 2; start++) {
                double[] polygon = turned(shape, start, start % 2 == 1);
                assertCoversOnce(polygon, cut(polygon, FLAT));
            }
        }
    }

    @Test
    void whatCrossesItselfIsNotCut() {
        double[] bowTie = {0, 0, 2, 2, 2, 0, 0, 2};
        double[] uneven = {0, 0, 3, 3, 3, 0, 0, 1};
        double[] loop = {0, 0, 6, 0, 6, 6, 2, 2, 4, -2, -3, 3};
        double[] star = new double[10];
        for (int i = 0; i < 5; i++) {
            star[2 * i] = Math.cos(4 * Math.PI * i / 5);
            star[2 * i + 1] = Math.sin(4 * Math.PI * i / 5);
        }
        double[] overlapping = {0, 0, 10, 0, 10, 6, 3, 6, 3, 3, 6, 3, 6, 8, 12, 8, 12, 10, 0, 10};
        double[] crossedCorner = {-1, -1, 0, 0, 1, 1, 1, -1, 0, 0, -1, 1};
        for (double[] shape : new double[][] {bowTie, uneven, loop, star, overlapping, crossedCorner}) {
            for (int start = 0; start < shape.length / 2; start++) {
                assertThat(cut(turned(shape, start, false), FLAT)).isNull();
                assertThat(cut(turned(shape, start, true), (x, y) -> new double[] {y, x + y, 7 - x})).isNull();
            }
        }
    }

    @Test
    void whatRunsRoundTwiceIsItsFan() {
        assertThat(cut(new double[] {0, 0, 4, 0, 4, 4, 0, 4, 0, 0, 4, 0, 4, 4, 0, 4}, FLAT)).isSameAs(EarClipper.FAN);
    }

    @Test
    void whatHasNoAreaIsNotCut() {
        assertThat(cut(new double[] {0, 0, 1, 0, 2, 0, 3, 0, 1.5, 0}, FLAT)).isNull();
        assertThat(cut(new double[] {0, 0, 1, 0, 1, 1, 1, 0}, FLAT)).isNull();
        assertThat(cut(new double[] {1, 1, 1, 1, 1, 1, 1, 1, 1, 1}, FLAT)).isNull();
    }

    /** Each takes a part of a second: none of the steps looks at all corners for each corner. */
    @Test
    void manyCornersAreCutAtOnce() {
        int n = Sample.size(100_000, 20_000);
        double[] gear = new double[2 * n];
        double[] spiral = new double[2 * n];
        double[] comb = new double[2 * n];
        for (int i = 0; i < n; i++) {
            double angle = 2 * Math.PI * i / n;
            gear[2 * i] = (5 + i / 2 % 2) * Math.cos(angle);
            gear[2 * i + 1] = (5 + i / 2 % 2) * Math.sin(angle);
            int k = i < n / 2 ? i : n - 1 - i;                // outwards, and back beside it
            double turn = 40 * Math.PI * k / n;
            double radius = i < n / 2 ? 1 + turn / 7 : 0.9 + turn / 7.25;
            spiral[2 * i] = radius * Math.cos(turn);
            spiral[2 * i + 1] = radius * Math.sin(turn);
            comb[2 * i] = i == 0 ? -1 : i == n - 1 ? n : i;
            comb[2 * i + 1] = i == 0 || i == n - 1 ? -1 : i % 2 * n;
        }
        for (double[] shape : new double[][] {gear, spiral, comb}) {
            int[] cut = cut(shape, (x, y) -> new double[] {y, x, x + y});
            assertThat(cut).hasSize(3 * (n - 2));
            assertThat(IntStream.iterate(0, i -> i < cut.length, i -> i + 3)
                .mapToDouble(i -> area(shape, cut[i], cut[i + 1], cut[i + 2])).sum())
                .isCloseTo(area(shape), within(Math.abs(area(shape)) * 1e-9));
        }
    }
}
