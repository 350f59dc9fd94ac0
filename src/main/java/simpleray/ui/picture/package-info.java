/**
 * The picture: rendered on threads of its own, shown while it grows, zoomed, and seen by a camera that moves. Threads hand finished pixel
 * runs over in a queue; what shows them is touched by the event thread alone.
 */
package simpleray.ui.picture;
