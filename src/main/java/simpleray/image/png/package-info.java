/** PNG files: written row by row while a picture is rendered, read with the help of ImageIO, and compared. */
package simpleray.image.png;
