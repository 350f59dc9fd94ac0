package simpleray.scene;

import java.util.List;
import simpleray.math.Colour;
import simpleray.math.Point;
import simpleray.math.Ray;
import simpleray.math.Vector;

/**
 * Why a ray sees the colour it sees: its hit, the terms there, and the trees of the rays that go on from it. <em>Constant</em>; nothing
 * in it is to be changed. The terms add up to the colour to the last bit, in this order: ambient, diffuse, specular, mirror, refracted.
 *
 * @param ray the ray
 * @param depth how many reflections and refractions may follow
 * @param told whether the rest is told; past {@link RayTreeRecorder#MAX_RAYS} rays of one pixel only colours are
 * @param hit what it hits; null if nothing, and if it is not told
 * @param colour what it sees, linear and not clamped
 */
public record RayTree(Ray ray, int depth, boolean told, Hit hit, Colour colour) {
    /** Which mutual position of a light and a surface lets how much of it come. */
    public enum Verdict {
        /** The surface is turned away from it: N.L is 0 or less. No shadow ray is sent. */
        TURNED_AWAY,
        /** Shadows are not asked for in this picture. */
        NO_SHADOWS,
        /** Nothing is between. */
        REACHES,
        /** What is between lets some through. */
        DIMMED,
        /** What is between lets nothing through. */
        BLOCKED
    }

    /**
     * An object or light of the scene.
     *
     * @param number its number, from 1
     * @param kind what kind it is, as scene files have it
     * @param line the line in the scene's file on which it begins, from 1; 0 if it is from no file
     */
    public record Thing(int number, String kind, int line) {
    }

    /**
     * A hit of the ray.
     *
     * @param object what is hit
     * @param distance how far, t
     * @param point where
     * @param normal the unit normal N there, turned to the side from which the ray comes
     * @param enters whether the ray enters the object there, and does not leave it
     * @param material what it is made of there
     * @param light the scene's ambient light, GA
     * @param ambient Ka * GA; black if it is not asked for
     * @param lamps what each light adds
     * @param diffuse the sum of their diffuse parts
     * @param specular the sum of their specular parts
     * @param mirror what the mirror ray adds; null if there is none
     * @param refracted what the refracted ray adds; null if there is none
     */
    public record Hit(Thing object, double distance, Point point, Vector normal, boolean enters, Material material, Colour light,
            Colour ambient, List<Lamp> lamps, Colour diffuse, Colour specular, Next mirror, Next refracted) {
    }

    /**
     * What a light adds at a hit.
     *
     * @param light which one
     * @param intensity its colour, LC
     * @param distance how far it is; infinite for a directional light
     * @param towards the unit vector to it, L
     * @param facing N.L
     * @param halfway the unit vector H halfway between L and the way back along the ray
     * @param cosine N.H
     * @param verdict whether it comes to the point
     * @param between what stands between and was asked, in the order of the scene; the last one blocks, if any does
     * @param arriving what is left of its colour; black if nothing
     * @param diffuse Kd * arriving * N.L; black if it is not asked for
     * @param specular Ks * arriving * (N.H)^shininess; black if it is not asked for
     */
    public record Lamp(Thing light, Colour intensity, double distance, Vector towards, double facing, Vector halfway, double cosine,
            Verdict verdict, List<Between> between, Colour arriving, Colour diffuse, Colour specular) {
    }

    /**
     * Something between a hit and a light.
     *
     * @param object which object
     * @param transmission its Kt
     */
    public record Between(Thing object, Colour transmission) {
    }

    /**
     * What a ray that goes on from a hit adds.
     *
     * @param share how much of it counts: Ks or Kt, or Ks + Kt at total internal reflection
     * @param colour what is added: the share of what it sees
     * @param tree its own tree
     */
    public record Next(Colour share, Colour colour, RayTree tree) {
    }
}
