/**
 * Finds what rays hit faster than by asking every object, and the same: the answers are those of
 * {@link simpleray.scene.BruteForceIntersector}, bit for bit.
 */
package simpleray.accel;
