package simpleray.rays;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.Rectangle;
import java.awt.RenderingHints;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Line2D;
import java.awt.geom.Path2D;
import java.awt.image.BufferedImage;
import java.util.ArrayList;
import java.util.EnumMap;
import java.util.EnumSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import simpleray.image.Picture;
import simpleray.image.PixelFont;
import simpleray.math.Point;
import simpleray.math.Ray;
import simpleray.math.Vector;
import simpleray.rays.RaySegment.Kind;
import simpleray.scene.Camera;

/**
 * Draws the rays of a pixel over a view of its scene: with arrowheads, each kind in its colour and line style, dashed where a surface
 * hides them. <em>Constant.</em>
 */
public final class RayDrawing {
    /** The kinds that are drawn unless more are asked for. */
    public static final Set<Kind> RAYS = Set.of(Kind.PRIMARY, Kind.MIRROR, Kind.REFRACTED, Kind.ARRIVING, Kind.STOPPED);

    private static final Map<Kind, Color> COLOURS = new EnumMap<>(Map.of(Kind.PRIMARY, new Color(0xffffff),
        Kind.MIRROR, new Color(0xff9e3d), Kind.REFRACTED, new Color(0x59c2ff), Kind.ARRIVING, new Color(0xffe14d),
        Kind.STOPPED, new Color(0xff5c5c), Kind.NORMAL, new Color(0x7be07b), Kind.HALFWAY, new Color(0xe58cff)));
    private static final Map<Kind, float[]> DASHES = new EnumMap<>(Map.of(Kind.REFRACTED, new float[] {14, 3, 3, 3}, Kind.ARRIVING,
        new float[] {2, 3}, Kind.STOPPED, new float[] {2, 5}));
    private static final float[] HIDDEN = {5, 6};
    private static final float WIDTH = 2;
    private static final float SELECTED = 4;
    private static final float THIN = 1.3f;
    private static final int HIDDEN_ALPHA = 110;
    private static final Color SHADE = new Color(0, 0, 0, 140);
    private static final Color GRID = new Color(220, 230, 255, 110);
    private static final Color PIXEL = new Color(255, 255, 255, 230);
    private static final int MAX_CELLS = 12;
    /** The distance of the image plane, as a share of that of the first hit. */
    private static final double PLANE = 0.3;
    /** How much nearer than a ray a surface must be to hide it, as a share of the distance. */
    private static final double TOLERANCE = 2e-3;
    private static final double NEAR = 1e-6;
    private static final int MAX_STEPS = 1 << 14;
    private static final double HEAD = 11;
    private static final double HEAD_ANGLE = 0.42;
    private static final int EYE = 5;
    private static final int MARGIN = 10;
    private static final int SAMPLE = 26;
    /** A narrower drawing has no legend: it would hide the rays. */
    private static final int SMALL = 360;
    private static final int LINE = PixelFont.HEIGHT + 5;

    private final OutsideView view;
    private final Camera inside;
    private final List<RaySegment> segments;
    private final Point eye;
    private final Vector forward;
    private final Vector right;
    private final Vector up;

    /**
     * Prepares a drawing.
     *
     * @param view the scene from outside
     * @param inside the scene's own camera
     * @param segments the rays of a pixel
     * @param kinds which kinds are drawn
     */
    public RayDrawing(OutsideView view, Camera inside, List<RaySegment> segments, Set<Kind> kinds) {
        this.view = view;
        this.inside = inside;
        this.segments = segments.stream().filter(segment -> kinds.contains(segment.kind())).toList();
        eye = view.camera.eye();
        forward = view.camera.forward();
        right = view.camera.right();
        up = view.camera.up();
    }

    /**
     * Paints everything into a picture.
     *
     * @param px the pixel's column
     * @param py the pixel's row
     * @return a new picture with the view, the camera, the rays and a legend
     */
    public Picture picture(int px, int py) {
        BufferedImage image = new BufferedImage(view.camera.width(), view.camera.height(), BufferedImage.TYPE_INT_RGB);
        Graphics2D g = image.createGraphics();
        paint(g, px, py, segments.size(), null);
        g.dispose();
        return Picture.of(image);
    }

    /**
     * Paints the view, the camera, the rays and a legend.
     *
     * @param g where, the view's upper left corner at 0, 0
     * @param px the pixel's column
     * @param py the pixel's row
     * @param count how many of the segments are painted, from the first
     * @param selected is painted thicker than others; null for none
     */
    public void paint(Graphics2D g, int px, int py, int count, RaySegment selected) {
        g.setRenderingHint(RenderingHints.KEY_INTERPOLATION, RenderingHints.VALUE_INTERPOLATION_BILINEAR);
        g.drawImage(view.image, 0, 0, view.camera.width(), view.camera.height(), null);
        g.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
        g.setRenderingHint(RenderingHints.KEY_STROKE_CONTROL, RenderingHints.VALUE_STROKE_PURE);
        Point from = paintCamera(g, px, py);
        for (RaySegment segment : segments.subList(0, Math.min(count, segments.size()))) {
            paint(g, segment, selected != null && segment.isSame(selected));
        }
        paintLegend(g, from);
    }

    /** {@return the segments that are drawn, in the order of the recursion} */
    public List<RaySegment> segments() {
        return segments;
    }

    /**
     * Finds the segment at a place of the drawing.
     *
     * @param x pixels from the left
     * @param y pixels from the top
     * @param reach how far away it may be, in pixels
     * @return the nearest one; null if none is in reach
     */
    public RaySegment at(double x, double y, double reach) {
        RaySegment nearest = null;
        double least = reach;
        for (RaySegment segment : segments) {
            double[] ends = ends(segment.from(), segment.to());
            double away = ends == null ? Double.POSITIVE_INFINITY : Line2D.ptSegDist(ends[0], ends[1], ends[3], ends[4], x, y);
            if (away <= least) {
                least = away;
                nearest = segment;
            }
        }
        return nearest;
    }

    /** {@return column, row and depth along the view of both ends of the visible part of a line; null if all of it is behind the eye} */
    double[] ends(Point from, Point to) {
        double near = NEAR * (1 + Math.max(depth(from), depth(to)));
        double a = depth(from) - near;
        double b = depth(to) - near;
        if (!(a > 0 || b > 0)) {
            return null;
        }
        Point begin = a > 0 ? from : between(from, to, a / (a - b));
        Point end = b > 0 ? to : between(from, to, a / (a - b));
        double[] ends = new double[6];
        project(begin, ends, 0);
        project(end, ends, 3);
        return ends;
    }

    private static Point between(Point from, Point to, double share) {
        return new Point(from.x + share * (to.x - from.x), from.y + share * (to.y - from.y), from.z + share * (to.z - from.z));
    }

    private double depth(Point p) {
        return Vector.subtract(p, eye).dot(forward);
    }

    private void project(Point p, double[] out, int at) {
        Vector v = Vector.subtract(p, eye);
        double z = Math.max(v.dot(forward), Double.MIN_NORMAL);
        out[at] = view.camera.width() * (0.5 + v.dot(right) / (z * right.squarednorm()));
        out[at + 1] = view.camera.height() * (0.5 - v.dot(up) / (z * up.squarednorm()));
        out[at + 2] = z;
    }

    private void paint(Graphics2D g, RaySegment segment, boolean selected) {
        Kind kind = segment.kind();
        Color colour = COLOURS.get(kind);
        float width = selected ? SELECTED : kind.isVector() || kind == Kind.ARRIVING || kind == Kind.STOPPED ? THIN : WIDTH;
        double[] whole = ends(segment.from(), segment.to());
        double[] ends = inside(whole);
        if (ends == null) {
            return;
        }
        paintLine(g, ends, colour, width, DASHES.get(kind));
        g.setColor(colour);
        if (kind != Kind.STOPPED) {
            paintHead(g, ends);
        } else if (ends[3] == whole[3] && ends[4] == whole[4]) {
            paintCross(g, ends[3], ends[4]);
        }
    }

    /** {@return the part of a line that lies in the view; null if none does} What goes on has its arrowhead where it leaves the view. */
    double[] inside(double[] ends) {
        double begin = 0;
        double end = 1;
        for (int axis = 0; ends != null && axis < 2; axis++) {
            double from = ends[axis];
            double way = ends[3 + axis] - from;
            double size = axis == 0 ? view.camera.width() : view.camera.height();
            if (way != 0) {
                begin = Math.max(begin, (way > 0 ? -from : size - from) / way);
                end = Math.min(end, (way > 0 ? size - from : -from) / way);
            } else if (from < 0 || from > size) {
                return null;
            }
        }
        if (ends == null || begin >= end) {
            return null;
        }
        double[] first = at(ends, begin);
        double[] last = at(ends, end);
        return new double[] {first[0], first[1], first[2], last[0], last[1], last[2]};
    }

    /** {@return column, row and depth of a point of a line, so far along it on the screen} */
    private static double[] at(double[] ends, double share) {
        double rest = 1 - share;
        return new double[] {rest * ends[0] + share * ends[3], rest * ends[1] + share * ends[4],
            1 / (rest / ends[2] + share / ends[5])};          // on the screen 1/z changes evenly
    }

    /** Paints a line whose parts behind surfaces are dashed. */
    private void paintLine(Graphics2D g, double[] ends, Color colour, float width, float[] dash) {
        double dx = ends[3] - ends[0];
        double dy = ends[4] - ends[1];
        int steps = (int) Math.max(1, Math.min(MAX_STEPS, Math.ceil(Math.max(Math.abs(dx), Math.abs(dy)))));
        Color pale = new Color(colour.getRed(), colour.getGreen(), colour.getBlue(), Math.min(colour.getAlpha(), HIDDEN_ALPHA));
        int begin = 0;
        boolean hidden = isHidden(ends, 0.5 / steps);
        for (int i = 1; i <= steps; i++) {
            boolean next = i < steps && isHidden(ends, (i + 0.5) / steps);
            if (i == steps || next != hidden) {
                g.setColor(hidden ? pale : colour);
                float[] pattern = hidden ? HIDDEN : dash;
                g.setStroke(stroke(width, pattern, (float) (begin * Math.hypot(dx, dy) / steps)));
                g.draw(new Line2D.Double(ends[0] + dx * begin / steps, ends[1] + dy * begin / steps, ends[0] + dx * i / steps,
                    ends[1] + dy * i / steps));
                begin = i;
                hidden = next;
            }
        }
    }

    private static BasicStroke stroke(float width, float[] dash, float phase) {
        return dash == null ? new BasicStroke(width) : new BasicStroke(width, BasicStroke.CAP_BUTT, BasicStroke.JOIN_MITER, 1, dash, phase);
    }

    /** {@return whether a surface lies before a part of a line, so far along it on the screen} */
    boolean isHidden(double[] ends, double share) {
        double[] at = at(ends, share);
        double across = (at[0] / view.camera.width() - 0.5) * right.norm();
        double high = (0.5 - at[1] / view.camera.height()) * up.norm();
        return view.distance(at[0], at[1]) < at[2] * Math.sqrt(1 + across * across + high * high) * (1 - TOLERANCE);
    }

    private static void paintHead(Graphics2D g, double[] ends) {
        double angle = Math.atan2(ends[4] - ends[1], ends[3] - ends[0]);
        double size = Math.min(HEAD, Math.hypot(ends[4] - ends[1], ends[3] - ends[0]) / 2);
        Path2D head = new Path2D.Double();
        head.moveTo(ends[3], ends[4]);
        head.lineTo(ends[3] - size * Math.cos(angle - HEAD_ANGLE), ends[4] - size * Math.sin(angle - HEAD_ANGLE));
        head.lineTo(ends[3] - size * Math.cos(angle + HEAD_ANGLE), ends[4] - size * Math.sin(angle + HEAD_ANGLE));
        head.closePath();
        g.fill(head);
    }

    private static void paintCross(Graphics2D g, double x, double y) {
        double half = HEAD / 2;
        g.setStroke(new BasicStroke(WIDTH));
        g.draw(new Line2D.Double(x - half, y - half, x + half, y + half));
        g.draw(new Line2D.Double(x - half, y + half, x + half, y - half));
    }

    /** Paints the camera. {@return where its ray begins; null if no ray begins there} */
    private Point paintCamera(Graphics2D g, int px, int py) {
        RaySegment primary = segments.stream().filter(segment -> segment.kind() == Kind.PRIMARY).findFirst().orElse(null);
        if (primary == null || !primary.from().equals(primary.ray().ray().origin)) {
            return null;
        }
        int w = inside.width();
        int h = inside.height();
        double away = planeDistance(primary);
        int across = Math.min(w, MAX_CELLS);
        int down = Math.min(h, Math.max(1, (int) Math.round((double) MAX_CELLS * h / w)));
        for (int i = 0; i <= across; i++) {
            paintGrid(g, onPlane((double) i * w / across, 0, away), onPlane((double) i * w / across, h, away));
        }
        for (int i = 0; i <= down; i++) {
            paintGrid(g, onPlane(0, (double) i * h / down, away), onPlane(w, (double) i * h / down, away));
        }
        Point before = inside.through(0, h).origin;
        for (double[] corner : new double[][] {{0, 0}, {w, 0}, {w, h}, {0, h}}) {
            Point start = inside.through(corner[0], corner[1]).origin;
            paintGrid(g, start, onPlane(corner[0], corner[1], away));
            if (inside.eye() == null) {
                paintGrid(g, before, start);                  // the plane in which parallel rays start
            }
            before = start;
        }
        g.setColor(PIXEL);
        Path2D pixel = new Path2D.Double();
        for (double[] corner : new double[][] {{px, py}, {px + 1, py}, {px + 1, py + 1}, {px, py + 1}}) {
            double[] at = new double[3];
            project(onPlane(corner[0], corner[1], away), at, 0);
            if (pixel.getCurrentPoint() == null) {
                pixel.moveTo(at[0], at[1]);
            } else {
                pixel.lineTo(at[0], at[1]);
            }
        }
        pixel.closePath();
        g.fill(pixel);
        paintDot(g, onPlane(px + 0.5, py + 0.5, away), 3);
        paintDot(g, primary.from(), EYE);
        return primary.from();
    }

    private void paintDot(Graphics2D g, Point p, double radius) {
        double[] at = new double[3];
        if (depth(p) > 0) {
            project(p, at, 0);
            g.fill(new Ellipse2D.Double(at[0] - radius, at[1] - radius, 2 * radius, 2 * radius));
        }
    }

    private void paintGrid(Graphics2D g, Point from, Point to) {
        double[] ends = ends(from, to);
        if (ends != null) {
            paintLine(g, ends, GRID, 1, null);
        }
    }

    private Point onPlane(double x, double y, double away) {
        return onPlane(inside, x, y, away);
    }

    /** {@return the point of the image plane that a point of the picture shows} */
    static Point onPlane(Camera inside, double x, double y, double away) {
        Ray middle = inside.through(inside.width() / 2.0, inside.height() / 2.0);
        Ray ray = inside.through(x, y);
        Vector apart = Vector.subtract(ray.origin, middle.origin);
        return ray.getPointAt((away - apart.dot(middle.direction)) / ray.direction.dot(middle.direction));
    }

    /** {@return how far from the eye the image plane is drawn} */
    static double planeDistance(RaySegment primary) {
        return PLANE * Vector.subtract(primary.from(), primary.to()).norm();
    }

    /** Paints the legend at the lower left, or in the next corner where it does not cover the camera's eye, which may be null. */
    private void paintLegend(Graphics2D g, Point from) {
        if (view.camera.width() < SMALL) {
            return;
        }
        Set<Kind> used = EnumSet.noneOf(Kind.class);
        segments.forEach(segment -> used.add(segment.kind()));
        List<String> labels = new ArrayList<>(used.stream().map(Kind::label).toList());
        labels.add("behind a surface");
        int wide = labels.stream().mapToInt(label -> PixelFont.width(label.length())).max().orElse(0) + SAMPLE + 3 * MARGIN;
        int high = LINE * labels.size() + MARGIN;
        int right = view.camera.width() - MARGIN - wide;
        int bottom = view.camera.height() - MARGIN - high;
        Rectangle box = new Rectangle(MARGIN, bottom, wide, high);
        if (from != null && depth(from) > 0) {
            double[] at = new double[3];
            project(from, at, 0);
            for (int corner = 1; corner < 4 && box.intersects(at[0] - EYE, at[1] - EYE, 2 * EYE, 2 * EYE); corner++) {
                box.setLocation(corner % 2 == 0 ? MARGIN : right, corner == 1 ? bottom : MARGIN);
            }
        }
        g.setColor(SHADE);
        g.fill(box);
        int x = box.x + MARGIN;
        int y = box.y + MARGIN;
        for (Kind kind : used) {
            g.setColor(COLOURS.get(kind));
            g.setStroke(stroke(WIDTH, DASHES.get(kind), 0));
            paintSample(g, x, y, kind.label());
            y += LINE;
        }
        g.setColor(Color.LIGHT_GRAY);
        g.setStroke(stroke(THIN, HIDDEN, 0));
        paintSample(g, x, y, labels.get(labels.size() - 1));
    }

    private static void paintSample(Graphics2D g, int left, int y, String label) {
        g.draw(new Line2D.Double(left, y + 4, left + SAMPLE, y + 4));
        g.setColor(Color.WHITE);
        for (int row = 0; row < PixelFont.HEIGHT; row++) {
            for (int x = 0; x < PixelFont.width(label.length()); x++) {
                if (PixelFont.isDark(label, x, row)) {
                    g.fillRect(left + SAMPLE + MARGIN + x, y + row, 1, 1);
                }
            }
        }
    }
}
