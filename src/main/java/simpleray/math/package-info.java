/**
 * Vectors, points, rays and colours (thesis, chapters 3 and 5). All arithmetic is {@code double}; coordinates are right-handed, x to
 * the right, y up, the viewer looking down -z; lengths are in scene units.
 *
 * <p>The classes are <em>mutable</em> and their fields public, for speed and as in the thesis. An operation comes in
 * up to three forms: {@code a.add(b)} changes a; {@code Vector.add(a, b)} returns a new vector; {@code Vector.add(d, a, b)} writes
 * the result to d, and d may be a or b. No object may be changed by one thread while another uses it.
 */
package simpleray.math;
