/** Pictures, their differences, and checkpoints of unfinished ones. {@link simpleray.image.Picture} is the one place that turns light into levels. */
package simpleray.image;
