/** Pictures and their file formats. {@link simpleray.image.Picture} is the one place that turns light into levels. */
package simpleray.image;
