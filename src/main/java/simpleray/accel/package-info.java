/**
 * Finds the few primitives that a ray may hit, without testing the others; knows boxes and rays, and no scene. No hit is lost: testing
 * these primitives gives the same result as testing all.
 */
package simpleray.accel;
