/** PNG files: written row by row while a picture is rendered, read, and compared. Reading is left to ImageIO. */
package simpleray.image.png;
