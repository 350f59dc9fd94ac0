package simpleray.ui.inspect;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.Shape;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Path2D;
import java.util.ArrayList;
import java.util.List;
import simpleray.math.Point;
import simpleray.rays.Projection;
import simpleray.rays.RaySegment;
import simpleray.scene.Camera;
import simpleray.scene.RayTree;
import simpleray.scene.RayTree.Contribution;
import simpleray.scene.RayTree.Lamp;
import simpleray.scene.RayTree.Next;
import simpleray.scene.RayTree.Verdict;
import simpleray.scene.Scene;

/**
 * Where a picture shows a point of a pixel's story. <em>Constant.</em>
 *
 * @param kind what the point is
 * @param x pixels of the picture from its left edge
 * @param y pixels from its top edge
 */
record StoryMark(Kind kind, double x, double y) {
    /** What is marked. */
    enum Kind {
        /** The point that a ray hits: a ring. */
        POINT,
        /** Where a shadow ray is stopped: a cross. */
        BLOCKER,
        /** What the mirror ray or the refracted ray from there hits: a diamond. */
        NEXT
    }

    private static final double RADIUS = 6;
    private static final float WIDTH = 2;
    private static final float EDGE = 4.5F;

    /** {@return the marks of a ray, of all lights at its hit and of the rays that leave it; or of one light} What is not in the picture has none. */
    static List<StoryMark> of(RayTree ray, Lamp lamp, Scene scene, Camera camera) {
        List<StoryMark> marks = new ArrayList<>();
        RayTree.Hit hit = ray.hit();
        if (hit == null) {
            return marks;
        }
        Projection projection = new Projection(camera);
        add(marks, Kind.POINT, hit.point(), projection, camera);
        for (Contribution light : lamp == null ? hit.lamps() : List.of(lamp)) {
            if (light instanceof Lamp one && one.verdict() == Verdict.BLOCKED) {
                add(marks, Kind.BLOCKER, RaySegment.stop(ray, one, scene), projection, camera);
            }
        }
        if (lamp == null) {
            add(marks, hit.mirror(), projection, camera);
            add(marks, hit.refracted(), projection, camera);
        }
        return marks;
    }

    private static void add(List<StoryMark> marks, Next next, Projection projection, Camera camera) {
        if (next != null && next.tree().hit() != null) {
            add(marks, Kind.NEXT, next.tree().hit().point(), projection, camera);
        }
    }

    private static void add(List<StoryMark> marks, Kind kind, Point point, Projection projection, Camera camera) {
        double[] at = projection.of(point);
        if (at != null && at[0] >= 0 && at[0] <= camera.width() && at[1] >= 0 && at[1] <= camera.height()) {
            marks.add(new StoryMark(kind, at[0], at[1]));
        }
    }

    /** Paints the mark at a place, white with a black edge. */
    void paint(Graphics2D g, double px, double py) {
        Graphics2D canvas = (Graphics2D) g.create();
        canvas.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
        canvas.translate(px, py);
        Shape shape = shape();
        canvas.setStroke(new BasicStroke(EDGE));
        canvas.setColor(Color.BLACK);
        canvas.draw(shape);
        canvas.setStroke(new BasicStroke(WIDTH));
        canvas.setColor(Color.WHITE);
        canvas.draw(shape);
        canvas.dispose();
    }

    private Shape shape() {
        if (kind == Kind.POINT) {
            return new Ellipse2D.Double(-RADIUS, -RADIUS, 2 * RADIUS, 2 * RADIUS);
        }
        Path2D path = new Path2D.Double();
        if (kind == Kind.BLOCKER) {
            path.moveTo(-RADIUS, -RADIUS);
            path.lineTo(RADIUS, RADIUS);
            path.moveTo(-RADIUS, RADIUS);
            path.lineTo(RADIUS, -RADIUS);
        } else {
            path.moveTo(0, -RADIUS - 1);
            path.lineTo(RADIUS + 1, 0);
            path.lineTo(0, RADIUS + 1);
            path.lineTo(-RADIUS - 1, 0);
            path.closePath();
        }
        return path;
    }
}
