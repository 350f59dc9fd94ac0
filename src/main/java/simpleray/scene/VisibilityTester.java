package simpleray.scene;

import simpleray.math.Colour;
import simpleray.math.Point;
import simpleray.math.Ray;
import simpleray.math.Vector;

/** Decides how much of a light reaches a point; no other class does. <em>Mutable</em>: one thread's own. */
public final class VisibilityTester {
    /** The cosine N·L below which rounding errors of a surface's points may count, however near the light is. */
    private static final double GRAZING = 1e-3;

    /** The unit vector towards the light, L. */
    public final Vector towards = new Vector();
    /** The distance of the light; infinite for a directional one. */
    public double distance;
    /** How far objects block the light: to just before it, so that a surface in which a lamp lies does not. */
    public double end;
    /** The cosine N·L; 0 or less for a light behind the surface. */
    public double facing;

    /** Whether objects between block light. */
    final boolean shadows;

    private final Intersector intersector;
    private final RayStats stats;
    private final Ray ray = new Ray(null, towards);
    private final Point lifted = new Point();

    /**
     * Creates a tester.
     *
     * @param intersector finds the objects between
     * @param shadows whether objects between block light
     * @param stats counts the shadow rays
     */
    public VisibilityTester(Intersector intersector, boolean shadows, RayStats stats) {
        this.intersector = intersector;
        this.shadows = shadows;
        this.stats = stats;
    }

    /**
     * Announces that until {@link #leave} all calls of {@link #reaches} are for points of one area light, seen from one surface.
     *
     * @param light the area light
     * @param at the surface
     */
    public void approach(AreaLight light, Interaction at) {
        if (shadows) {
            intersector.approach(at.point, light);
        }
    }

    /** Ends what {@link #approach} began. */
    public void leave() {
        intersector.leave();
    }

    /**
     * Computes how much of a light reaches a surface.
     *
     * @param light the light, or a point of an area light
     * @param number its index in the scene
     * @param at the surface
     * @param arriving the light's colour; gets the part that arrives, black if the surface is turned away
     * @return whether it is not black
     */
    public boolean reaches(Light light, int number, Interaction at, Colour arriving) {
        distance = light.towards(at.point, towards);
        end = distance - Optics.margin(at.point, distance);
        facing = at.normal.dot(towards);
        ray.origin = at.point;
        if (facing > 0 && facing < GRAZING) {
            graze(at);
        }
        if (facing <= 0) {
            arriving.reset();
            return false;
        }
        if (!shadows) {
            return !arriving.isBlack();
        }
        stats.shadow++;
        return !intersector.occluded(ray, end, number, arriving);
    }

    /**
     * Keeps rounding errors out of a light that all but grazes the surface: they would decide point by point whether the surface faces a lamp
     * that lies in it, and whether the shadow ray hits the surface it leaves. A highlight, which no cosine weakens, would show that as specks.
     */
    private void graze(Interaction at) {
        double error = Optics.error(at.point, at.t);
        if (facing <= Optics.ROUNDINGS || facing * distance <= error) {
            facing = 0;
        } else {
            lifted.copy(at.point);
            Optics.move(lifted, at.normal, error);
            ray.origin = lifted;
        }
    }
}
