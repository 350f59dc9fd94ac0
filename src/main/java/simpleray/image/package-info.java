/** Pictures, how they differ, and what keeps them while they are rendered. {@link simpleray.image.Picture} is the one place that turns light into levels. */
package simpleray.image;
