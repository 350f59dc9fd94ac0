/** A scene compiled for fast rendering, and its intersector. */
package simpleray.trace;
