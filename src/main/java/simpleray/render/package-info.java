/** Renders a scene to a picture: settings, threads, progress, cancelling. Knows no window. */
package simpleray.render;
