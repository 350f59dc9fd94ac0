package simpleray.render;

import simpleray.scene.RayStats;

/**
 * The work that a rendering did, and the time that it took. <em>Constant.</em>
 *
 * @param rays the rays and tests; null if they were not counted, as with {@link Accel#NONE}
 * @param readySeconds the time to compile the scene, in seconds
 * @param renderSeconds the time to render all rows, in seconds
 */
public record RenderStats(RayStats rays, double readySeconds, double renderSeconds) {
}
