package simpleray.render;

import simpleray.scene.RayStats;

/**
 * What a rendering did and how long it took. <em>Constant.</em>
 *
 * @param rays the rays and tests; null if they were not counted, as with {@link Accel#NONE}
 * @param readySeconds the time to make the scene ready, in seconds
 * @param renderSeconds the time from then on until all rows were finished
 */
public record RenderStats(RayStats rays, double readySeconds, double renderSeconds) {
}
