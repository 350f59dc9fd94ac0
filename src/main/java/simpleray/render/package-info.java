/** Turns a scene into a picture: settings, rows handed out to threads, progress, cancelling. Knows no window. */
package simpleray.render;
