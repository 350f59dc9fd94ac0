/**
 * Finds what rays hit faster than by asking every object, and the same: the picture is that of {@link simpleray.scene.Scene#intersect},
 * bit for bit. Without this room (and one line of the renderer) everything still renders.
 */
package simpleray.accel;
