package simpleray.scene;

import java.util.List;
import simpleray.math.Colour;
import simpleray.math.Point;
import simpleray.math.Ray;
import simpleray.math.Vector;

/**
 * The explanation of a ray's colour: its hit, the terms there, and the trees of the rays that leave it. <em>Constant</em>; nothing
 * in it may be changed. The terms add up to the colour to the last bit, in this order: ambient, diffuse, specular, mirror, refracted.
 *
 * @param ray the ray
 * @param depth the number of reflections and refractions that may follow
 * @param told whether the hit is recorded; after {@link RayTreeRecorder#MAX_RAYS} rays of one pixel only colours are
 * @param hit its hit; null if there is none or it is not recorded
 * @param colour its colour, linear and not clamped
 */
public record RayTree(Ray ray, int depth, boolean told, Hit hit, Colour colour) {
    /** Whether a light reaches a point. */
    public enum Verdict {
        /** The surface is turned away from it: N.L is 0 or less. No shadow ray is traced. */
        TURNED_AWAY,
        /** This picture has no shadows. */
        NO_SHADOWS,
        /** No object is between. */
        REACHES,
        /** The objects between transmit some of it. */
        DIMMED,
        /** The objects between block it. */
        BLOCKED;

        /** {@return whether light arrives} */
        public boolean isLit() {
            return this != TURNED_AWAY && this != BLOCKED;
        }
    }

    /**
     * An object or light of the scene.
     *
     * @param number its number, from 1
     * @param kind its kind, as in scene files
     * @param line its first line in the scene's file, from 1; 0 if it is from no file
     * @param mtl where the material of the part in question stands; null if it is the object's own
     */
    public record Thing(int number, String kind, int line, Mtl mtl) {
        /**
         * Names an object or light that has one material.
         *
         * @param number its number, from 1
         * @param kind its kind, as in scene files
         * @param line its first line in the scene's file, from 1; 0 if it is from no file
         */
        public Thing(int number, String kind, int line) {
            this(number, kind, line, null);
        }
    }

    /**
     * A material of an MTL file.
     *
     * @param name its name
     * @param file the file, as messages call it
     * @param line the line on which it begins, from 1
     */
    public record Mtl(String name, String file, int line) {
    }

    /**
     * A hit of the ray.
     *
     * @param object the object
     * @param distance the distance, t
     * @param point the hit point
     * @param normal the unit normal N there, turned to the side from which the ray comes
     * @param enters whether the ray enters the object there, rather than leaves it
     * @param material its material there
     * @param light the scene's ambient light, GA
     * @param ambient Ka * GA; black if the picture does not show it
     * @param lamps the contribution of each light: a {@link Lamp}, or an {@link Area} of an area light
     * @param diffuse the sum of their diffuse parts
     * @param specular the sum of their specular parts
     * @param mirror the contribution of the mirror ray; null if there is none
     * @param refracted the contribution of the refracted ray; null if there is none
     */
    public record Hit(Thing object, double distance, Point point, Vector normal, boolean enters, Material material, Colour light,
            Colour ambient, List<Contribution> lamps, Colour diffuse, Colour specular, Next mirror, Next refracted) {
    }

    /** The contribution of a light at a hit. */
    public sealed interface Contribution permits Lamp, Area {
        /** {@return the light} */
        Thing light();

        /** {@return its colour, LC} */
        Colour intensity();

        /** {@return its diffuse term} Black if the picture does not show it. */
        Colour diffuse();

        /** {@return its specular term} Black if the picture does not show it. */
        Colour specular();
    }

    /**
     * The contribution of an area light at a hit: that of all its points, which add up to its terms to the last bit, in their order.
     *
     * @param light the light
     * @param intensity its colour, LC
     * @param points the number of its points
     * @param shadows whether this picture has shadows; without, all points that the surface faces reach it
     * @param whole the number of points whose light arrives undimmed
     * @param dimmed the number of those whose light arrives dimmed
     * @param blocked the number of those whose light is blocked
     * @param between the objects between the hit and some point, in the order of the scene; null if finding them would take too long
     * @param diffuse the sum of the points' diffuse terms; black if the picture does not show it
     * @param specular the sum of their specular terms; black if the picture does not show it
     * @param lamps each point's own contribution, if it is asked for, or else empty; null if the pixel has too many of them
     */
    public record Area(Thing light, Colour intensity, int points, boolean shadows, int whole, int dimmed, int blocked, List<Thing> between,
            Colour diffuse, Colour specular, List<Lamp> lamps) implements Contribution {
        /** {@return the number of points from which the surface is turned away} */
        public int turnedAway() {
            return points - whole - dimmed - blocked;
        }
    }

    /**
     * The contribution of a light at a hit, or of a point of an area light.
     *
     * @param light the light
     * @param intensity its colour, LC
     * @param distance its distance; infinite for a directional light
     * @param towards the unit vector to it, L
     * @param facing N.L
     * @param halfway the unit vector H halfway between L and the way back along the ray
     * @param cosine N.H
     * @param verdict whether it reaches the point
     * @param between the objects between, in the order of the scene; the last one blocks, if any does
     * @param arriving the colour that arrives; black if nothing does
     * @param diffuse Kd * arriving * N.L; black if the picture does not show it
     * @param specular Ks * arriving * (N.H)^shininess; black if the picture does not show it
     */
    public record Lamp(Thing light, Colour intensity, double distance, Vector towards, double facing, Vector halfway, double cosine,
            Verdict verdict, List<Between> between, Colour arriving, Colour diffuse, Colour specular) implements Contribution {
    }

    /**
     * An object between a hit and a light.
     *
     * @param object the object
     * @param transmission its Kt
     */
    public record Between(Thing object, Colour transmission) {
    }

    /**
     * The contribution of a ray that leaves a hit.
     *
     * @param share its factor: the mirror ray's share (Ks, or the material's mirror) or Kt; the sum of both at total internal reflection
     * @param colour the contribution: the factor times the ray's colour
     * @param tree its own tree
     */
    public record Next(Colour share, Colour colour, RayTree tree) {
    }
}
