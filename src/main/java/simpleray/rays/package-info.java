/** Draws the rays of a pixel in its scene, as seen from outside. Knows BufferedImage and Graphics2D, but no window. */
package simpleray.rays;
