/**
 * Finds the few primitives that a ray may hit without a look at the others: boxes and rays, and nothing of scenes. No hit is lost: who tests
 * what is shown here finds the same as who tests all.
 */
package simpleray.accel;
